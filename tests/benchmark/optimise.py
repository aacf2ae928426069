#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What optimising content costs, beside the same steps in numpy with dense matrices.

    python3 tests/benchmark/optimise.py build/release/bin/hogelscope

128 × 128 hogels of 20 × 20 directions, leakage of sigma 0.67 in a window of 5. It prints the
nanoseconds per texel, colour and step on one thread, of the program (from runs of 100 and of 300
steps for every hogel) and of numpy, five times in turn, and their ratio; and the seconds of the
whole command as a user runs it, with the gain of held-out eyes.
"""

import csv
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

PROGRAM = os.path.abspath(sys.argv[1])
HOGELS, DIRECTIONS = 128, 20
FEW, MANY = 100, 300
SIGMA, WINDOW = 0.67, 5


def run(*arguments):
    begin = time.perf_counter()
    subprocess.run([PROGRAM, *arguments], check=True, capture_output=True)
    return time.perf_counter() - begin


def leakage():
    places = np.arange(DIRECTIONS)
    apart = np.abs(places[:, None] - places)
    weights = np.where(apart <= WINDOW // 2, np.exp(-apart**2 / (2 * SIGMA**2)), 0)
    return weights / weights.sum(1, keepdims=True)


def numpy_step(matrix, point, target, now):
    """One accelerated projected gradient step of all hogels and one colour."""
    residual = np.matmul(matrix, point @ matrix.T) - target
    following = np.clip(point - np.matmul(matrix.T, residual @ matrix), 0, 1)
    return following, following + 0.5 * (following - now)


def seconds_of_numpy(steps=10):
    random = np.random.default_rng(0)
    target = random.random((HOGELS * HOGELS // 16, DIRECTIONS, DIRECTIONS))
    matrix, now, point = leakage(), target, target
    begin = time.perf_counter()
    for _ in range(steps):
        now, point = numpy_step(matrix, point, target, now)
    return (time.perf_counter() - begin) / (steps * target.size)


def main():
    with tempfile.TemporaryDirectory() as folder:
        path = lambda name: os.path.join(folder, name)
        session = {
            "hogelscope": 1,
            "display": {"size": [0.4, 0.4], "hogels": [HOGELS, HOGELS],
                        "directions": [DIRECTIONS, DIRECTIONS], "fov": [54, 54]},
            "lightField": {"layout": "live", "source": "mesh", "mesh": {
                "file": os.path.abspath("data/room.glb"), "shading": "lambert"}},
            "cameras": [{"name": "a", "eye": [0, 0, 0.6], "fov": 27, "res": [400, 400],
                         "psf": {"sigma": SIGMA, "windowSize": WINDOW}}]}
        with open(path("live.json"), "w") as text:
            json.dump(session, text)
        run("--export", "hogels", "--prefilter", "--session", path("live.json"), "--output",
            path("room.png"))
        session["lightField"] = {"file": "room.png"}
        with open(path("s.json"), "w") as text:
            json.dump(session, text)
        command = ["--optimise", "hogels", "--session", path("s.json"), "--output", path("o.png")]
        of_all = 3 * (HOGELS * DIRECTIONS) ** 2
        own, peer = [], []
        for _ in range(5):
            few, many = [run(*command, "--threads", "1", "--set", "optimise.tolerance=0", "--set",
                             f"optimise.iterations={steps}") for steps in (FEW, MANY)]
            own.append((many - few) / ((MANY - FEW) * of_all))
            peer.append(seconds_of_numpy())
        ratio = statistics.median(a / b for a, b in zip(own, peer))
        print(f"{1e9 * statistics.median(own):.1f} ns per texel, colour and step; "
              f"numpy {1e9 * statistics.median(peer):.1f} ns; ratio {ratio:.2f}")
        whole = statistics.median(run(*command) for _ in range(5))
        with open(path("o.csv")) as table:
            row = list(csv.DictReader(table))[-1]
        print(f"{whole:.1f} s as a user runs it; held-out eyes {float(row['before_psnr']):.1f} dB "
              f"before, {float(row['after_psnr']):.1f} dB after")


main()
