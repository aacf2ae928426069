#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""cpu_time.py BUILD [REGEX]: seconds of CPU and of wall time of each test, one at a time, and the sum.

Wall time depends on what else the machine does; CPU time hardly does. Processes that a test leaves
to others, such as the X server of xvfb-run, are not counted.
"""
import json
import re
import resource
import subprocess
import sys
import time


def cpu():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def main():
    ctest = ["ctest", "--test-dir", sys.argv[1]]
    tests = json.loads(subprocess.check_output(ctest + ["--show-only=json-v1"]))["tests"]
    names = [test["name"] for test in tests]
    if len(sys.argv) > 2:
        names = [name for name in names if re.search(sys.argv[2], name)]
    start = cpu()
    for name in names:
        before, began = cpu(), time.monotonic()
        run = subprocess.run(ctest + ["-R", f"^{re.escape(name)}$"], capture_output=True, check=False)
        verdict = "" if run.returncode == 0 else " FAILED"
        print(f"{cpu() - before:8.2f} {time.monotonic() - began:8.2f} {name}{verdict}", flush=True)
    print(f"{cpu() - start:8.2f} sum of CPU")


if __name__ == "__main__":
    main()
