#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How soon every job of the batch mode ends after SIGTERM, at random moments.

    tests/attack/stops.py build/release/bin/hogelscope [--moments 30] [--only PATTERN] [--seed 1]

Prints a table: of each job the median and the longest time from the signal to the end, and what
was left behind. Exit status 1 where an end took longer than 0.5 s, the program did not end by the
signal, or a temporary file was left. By hand, on a machine that does nothing else: it measures
times, so it is no test.
"""

import argparse
import json
import os
import random
import re
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

LONGEST_RUN = 5.0  # seconds: the signal comes before
PATIENCE = 20.0  # seconds after the signal, then SIGKILL
REPOSITORY = Path(__file__).resolve().parents[2]

# Of whose pixels many lie near the fold, where the certified inverse takes longest.
HARD_LENSES = {
    "k1 -0.45 k2 0.25": {"k1": -0.45, "k2": 0.25},
    "OpenCV's sample": {"k1": 0.2958943955272433, "k2": -1.0354662043042675},
    "k1 10": {"k1": 10},
    "k1 -10": {"k1": -10},
    "near miss of a fold": {"k1": 1.3703159456544856, "k2": -0.06496402261108393,
                            "p2": 1.8e-07, "k3": 0.00090798962886300778},
}


def lens(coefficients, resolution, fov=100):
    words = ["--set", f"camera.res=[{resolution},{resolution}]", "--set", f"camera.fov={fov}"]
    for name in ("k1", "k2", "p1", "p2", "k3"):
        words += ["--set", f"distortion.{name}={coefficients.get(name, 0)!r}"]
    return words


def make_inputs(program, folder):
    """Light fields in other formats than the sample's, and a huge session."""
    def run(*arguments):
        subprocess.run([program, *arguments, "--quiet"], cwd=folder, check=True)

    shutil.copy(REPOSITORY / "data" / "table1.json", folder)
    shutil.copy(REPOSITORY / "data" / "scene.png", folder)
    large = ["--session", "table1.json", "--set", "display.hogels=[400,400]"]
    run("--generate", "spheres", *large, "--output", "large.png")
    run("--generate", "spheres", *large, "--output", "large.tif")
    run("--pack", "large.png", *large, "--output", "store.tif")
    run("--make-cameras", "random", "--session", "table1.json", "--count", "60000", "--region",
        "box", "--output", "huge.json", "--set", "cameraRegion.centre=[0,0,0.6]")
    for name in ("large.jpg", "large.exr", "large.jp2"):
        if shutil.which("oiiotool"):
            subprocess.run(["oiiotool", "large.png", "-o", name], cwd=folder, check=True)
    document = json.loads((folder / "table1.json").read_text())
    document["display"]["hogels"] = [400, 400]
    for state in document["cameras"]:
        state["res"] = [600, 600]
    for file in sorted(folder.glob("large.*")):
        document["lightField"] = {"file": file.name, "layout": "hogels"}
        (folder / (file.name + ".json")).write_text(json.dumps(document))
    document["lightField"] = {"file": "store.tif", "layout": "pack"}
    (folder / "store.json").write_text(json.dumps(document))


def jobs(folder):
    """Name and arguments of each; all write below "out"."""
    sample = ["--session", "table1.json"]
    render = ["--render", "--output", "out"]
    report = ["--report", "--output", "out"]
    one = ["--states", "Fig 1"]
    for name, coefficients in HARD_LENSES.items():
        yield f"render, lens {name}", render + sample + one + lens(coefficients, 2000)
    hard = lens(HARD_LENSES["OpenCV's sample"], 2000)
    yield "render, tolerance 2, hard lens", render + sample + one + hard + [
        "--set", "sampling.tolerance=2", "--set", "sampling.samplesPerPixel=2"]
    yield "render, no lens table, hard lens", render + sample + one + hard + [
        "--set", "sampling.samplesPerPixel=8"]
    yield "render --explain, hard lens", render + sample + one + hard + ["--explain"]
    yield "render, 64×64 rays, leakage 99×99", render + sample + one + [
        "--set", "sampling.samplesPerPixel=64", "--set", "psf.windowSize=99", "--set",
        "sampling.reconstruction=quadrilinear", "--set", "psf.sigma=20"]
    yield "render, 16384² px", render + sample + one + ["--set", "camera.res=[16384,16384]"]
    yield "render, store, hard lens", render + ["--session", "store.json"] + one + hard + [
        "--memory", "50"]
    yield "render in passing, hard lens", render + ["--session", "large.png.json"] + one + hard + [
        "--memory", "100"]
    yield "report", report + sample + ["--test", "scene.png"]
    yield "report, hard lens", report + sample + ["--test", "scene.png"] + hard
    yield "report, pictures of 6000² px", report + sample + one + [
        "--test", "scene.png", "--images", "--set", "camera.res=[6000,6000]"]
    yield "report, two large files", report + ["--session", "large.png.json", "--test", "large.tif"]
    yield "tradeoff", ["--tradeoff", "--output", "out"] + sample
    yield "tradeoff, hard lens", ["--tradeoff", "--output", "out"] + sample + one + hard
    yield "stability", ["--stability", "--output", "out"]
    yield "pack", ["--pack", "large.png", "--session", "large.png.json", "--output", "out/a.tif"]
    yield "generate", ["--generate", "scene", *sample, "--output", "out/a.png", "--set",
                       "display.hogels=[2000,2000]"]
    for degradation in ("noise:2", "blur:3", "jpeg:60"):
        yield f"generate, wide rows, {degradation}", [
            "--generate", "spheres", *sample, "--output", "out/a.png", "--degrade", degradation,
            "--set", "display.hogels=[3000,20]", "--set", "display.directions=[40,200]"]
    yield "make-cameras, 100 000", ["--make-cameras", "random", *sample, "--count", "100000",
                                    "--output", "out/a.json"]
    yield "render, session of 60 000 states", render + ["--session", "huge.json"]
    yield "info, session of 60 000 states", ["--info", "huge.json"]
    for file in sorted(folder.glob("large.*.json")):
        yield f"read {file.stem}", render + ["--session", file.name]


def temporaries(folder):
    """What is to go on with is no temporary file: a store's .part, a report's journal."""
    return sorted(str(p.relative_to(folder)) for p in folder.rglob(".*.part*"))


class Campaign:
    def __init__(self, program, folder):
        self.program = program
        self.folder = folder

    def start(self, arguments):
        out = self.folder / "out"
        shutil.rmtree(out, ignore_errors=True)
        out.mkdir()
        return subprocess.Popen([self.program, *arguments], cwd=self.folder,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def duration(self, arguments):
        process = self.start(arguments)
        begin = time.monotonic()
        try:
            process.wait(LONGEST_RUN)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        return min(time.monotonic() - begin, LONGEST_RUN)

    def stop_at(self, arguments, moment):
        """Seconds to the end, or None where it was over before; what went wrong."""
        process = self.start(arguments)
        time.sleep(moment)
        if process.poll() is not None:
            return None, []
        begin = time.monotonic()
        process.send_signal(signal.SIGTERM)
        wrong = []
        try:
            process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            wrong.append(f"had to be killed after {PATIENCE:.0f} s")
        seconds = time.monotonic() - begin
        if not wrong and process.returncode not in (-signal.SIGTERM, 0):
            wrong.append(f"status {process.returncode}")
        wrong += [f"left {name}" for name in temporaries(self.folder)]
        return seconds, wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=lambda p: str(Path(p).resolve()))
    parser.add_argument("--moments", type=int, default=30)
    parser.add_argument("--only", default="", help="a regular expression of job names")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--inputs", type=Path, help="a folder that keeps the inputs")
    options = parser.parse_args()
    failed = False
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.inputs or Path(temporary)
        if not (folder / "store.json").exists():
            folder.mkdir(exist_ok=True)
            make_inputs(options.program, folder)
        campaign = Campaign(options.program, folder)
        print("| job | runs for | signals | median | longest | left, wrong |\n|---|---|---|---|---|---|")
        for name, arguments in jobs(folder):
            if not re.search(options.only, name):
                continue
            duration = campaign.duration(arguments)
            chance = random.Random(f"{options.seed} {name}")
            seconds, wrong = [], set()
            for _ in range(options.moments):
                took, faults = campaign.stop_at(arguments, chance.uniform(0.02, duration))
                if took is not None:
                    seconds.append(took)
                wrong.update(re.sub(r"out/.*", "temporary files", fault) for fault in faults)
            longest = max(seconds, default=0)
            failed = failed or longest > 0.5 or bool(wrong)
            runs = f"{duration:.1f} s" if duration < LONGEST_RUN else f"> {LONGEST_RUN:.0f} s"
            print(f"| {name} | {runs} | {len(seconds)} | "
                  f"{statistics.median(seconds or [0]):.3f} s | {longest:.3f} s | "
                  f"{', '.join(sorted(wrong))} |", flush=True)
        shutil.rmtree(folder / "out", ignore_errors=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
