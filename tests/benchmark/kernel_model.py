#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""kernel_model.py SOURCE [PROCESSOR ...]: what llvm-mca's model of a processor expects of kernels.

For machines that are not at hand: SOURCE, such as src/core/engine/row_kernels.cpp, is compiled for
AVX-512, and the cycles and micro-operations of each long block of vector instructions are printed, as
if it were repeated with all data in the first-level cache: the loops' bodies, mostly of 16 rays, and
strips of 32, which the compiler unrolls.
"""
import re
import subprocess
import sys


def assembly(source):
    command = "g++ -S -o - -DHOGELSCOPE_BASELINE -Isrc -O3 -DNDEBUG -fPIC -std=gnu++20 -fno-trapping-math"
    command += " -fno-math-errno -ffp-contract=off -march=x86-64-v4"
    return subprocess.check_output(command.split() + [source], text=True).split("\n")


def functions(lines):
    name = None
    found = {}
    for line in lines:
        label = re.match(r"(_Z\w+):", line)
        if label:
            name = label.group(1)
            found[name] = []
        elif name:
            found[name].append(line)
    return found


def blocks(lines):
    """Yields the instructions between labels and jumps."""
    block = []
    for line in lines:
        if re.match(r"\s+[a-z]", line):
            block.append(line)
        if re.match(r"\.L|\s+(j|call|ret)", line):
            yield block
            block = []


def cycles(body, processor):
    turns = 100
    command = ["llvm-mca", f"-mcpu={processor}", f"-iterations={turns}", "-"]
    run = subprocess.run(command, input="\n".join(body), text=True, capture_output=True, check=False)
    if run.returncode != 0:
        sys.exit(f"kernel_model.py: no model of AVX-512 on {processor}: {run.stderr.strip().splitlines()[0]}")
    numbers = [re.search(what + r":\s+(\d+)", run.stdout).group(1) for what in ("Total Cycles", "Total uOps")]
    return [int(number) / turns for number in numbers]


def main():
    print("cycles  micro-ops  instructions  in")
    for processor in sys.argv[2:] or ["cascadelake"]:
        for name, lines in functions(assembly(sys.argv[1])).items():
            readable = subprocess.check_output(["c++filt", "-p", name], text=True).strip()
            for body in blocks(lines):
                if len(body) < 40 or not any(re.search("[yz]mm", line) for line in body):
                    continue
                took, operations = cycles(body, processor)
                print(f"{took:6.1f} {operations:10.1f} {len(body):13}  {readable} ({processor})")


if __name__ == "__main__":
    main()
