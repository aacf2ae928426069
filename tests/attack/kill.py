# SPDX-License-Identifier: BSD-3-Clause
"""Ends every job with kill -9 at 30 moments spread over its run: python3 kill.py [MOMENTS].

Afterwards every file must be the old one or a whole new one, nothing may be left over but what a
job goes on with, and the same command must then end as if it had never been stopped. Findings are
printed; then the script ends with status 1."""

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import attack

LARGE = ["--set", "camera.res=[700,700]"]
JOBS = {
    "render": ["--render", "--session", "s.json", "--output", "out", "--masks", *LARGE],
    "render to EXR": ["--render", "--session", "s.json", "--output", "out", "--format", "exr",
                      *LARGE],
    "report": ["--report", "--session", "s.json", "--test", "b.png", "--output", "out",
               "--images", *LARGE],
    "generate": ["--generate", "scene", "--session", "s.json", "--output", "out/g.png", "--set",
                 "display.directions=[90,90]"],
    "pack": ["--pack", "a.png", "--session", "s.json", "--output", "out/p.tif"],
    "make-cameras": ["--make-cameras", "random", "--count", "3000", "--session", "s.json",
                     "--output", "out/c.json"],
}
GOES_ON_WITH = ("report.hashes", "report.journal", "report.panel", ".part")


def goes_on_with(name):
    return any(part in name for part in GOES_ON_WITH)


def undated(name, data):
    """A report's page says when it was made."""
    if not name.endswith("report.html"):
        return data
    return b"\n".join(line for line in data.split(b"\n") if b"UTC" not in line)


def killed_after(seconds, job, folder):
    environment = {k: v for k, v in os.environ.items() if k != "DISPLAY"}
    process = subprocess.Popen([attack.PROGRAM, *job], cwd=folder, env=environment,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        process.wait(seconds)
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGKILL)
        process.wait()


def problems(folder, expected):
    for name, data in attack.contents(folder).items():
        if goes_on_with(name):
            continue
        if name not in expected:
            yield f"left over: {name}"
        elif data != b"old" and undated(name, data) != undated(name, expected[name]):
            yield f"not whole: {name}"


def attack_job(name, job, root, moments):
    whole = root / "whole"
    # The same inputs every time: stores keep the path, inode and times of what they are made of.
    folder = root / "work"
    shutil.copytree(whole, folder)
    start = time.monotonic()
    attack.must(job, folder)
    duration = time.monotonic() - start
    expected = {file: data for file, data in attack.contents(folder / "out").items()
                if not goes_on_with(file)}
    findings = 0
    for k in range(moments):
        shutil.rmtree(folder / "out")
        shutil.copytree(whole / "out", folder / "out")
        for file in expected:
            (folder / "out" / file).parent.mkdir(parents=True, exist_ok=True)
            (folder / "out" / file).write_bytes(b"old")
        killed_after(duration * (k + 0.5) / moments, job, folder)
        wrong = list(problems(folder / "out", expected))
        attack.must(job, folder)
        after = attack.contents(folder / "out")
        wrong += [f"differs after going on: {file}" for file in expected
                  if undated(file, after.get(file, b"")) != undated(file, expected[file])]
        wrong += [f"left after going on: {file}" for file in after
                  if file not in expected and file != "report.hashes"]
        findings += len(wrong)
        for line in wrong:
            print(f"{name}, killed at {k + 0.5} of {moments}: {line}")
    shutil.rmtree(folder)
    print(f"{name}: {moments} kills within {duration:.1f} s, {findings} findings")
    return findings


def main(moments=30):
    root = pathlib.Path(tempfile.mkdtemp(prefix="attack-"))
    (root / "whole/out").mkdir(parents=True)
    attack.make_inputs(root / "whole")
    return 1 if sum(attack_job(name, job, root, moments) for name, job in JOBS.items()) else 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
