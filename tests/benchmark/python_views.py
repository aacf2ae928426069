#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a view costs from Python, beside the engine's own view of the same light field and poses.

    PYTHONPATH=build/release/lib/python3/dist-packages python3 tests/benchmark/python_views.py \\
        build/release/bin/hogelscope-benchmark

Both are timed in turn, five times each. It prints medians and their ratio, and what a view of many
costs that render_all() gives.
"""

import json
import math
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

import hogelscope as hs

HOGELS, DIRECTIONS, POSES = 128, 20, 64
SIZES = {"view/nearest": [600, 600], "view/nearest of 3840x2160": [3840, 2160]}


def engine_times():
    """Milliseconds of the engine's views by their names."""
    names = "|".join(f"^{name}/real_time$" for name in SIZES)
    with tempfile.NamedTemporaryFile() as file:
        subprocess.run(
            [sys.argv[1], f"--hogels={HOGELS}", f"--directions={DIRECTIONS}",
             f"--benchmark_filter={names}", f"--benchmark_out={file.name}"],
            check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        runs = json.load(file)["benchmarks"]
    return {run["name"].removesuffix("/real_time"): run["real_time"] for run in runs}


def states(res):
    """The benchmark's poses."""
    return [
        {"name": f"pose {k}", "res": res,
         "eye": [0.1 * math.cos(angle), 0.1 * math.sin(angle), 0.559]}
        for k, angle in enumerate(2 * math.pi * k / POSES for k in range(POSES))
    ]


def median(call, seconds=1.0):
    """Milliseconds of a call that is made again and again for so long."""
    times = []
    end = time.perf_counter() + seconds
    while time.perf_counter() < end:
        start = time.perf_counter()
        call(len(times) % POSES)
        times.append(1000 * (time.perf_counter() - start))
    return statistics.median(times)


def main():
    light = hs.LightField(np.random.default_rng(1).integers(
        0, 256, (DIRECTIONS, DIRECTIONS, HOGELS, HOGELS, 3), np.uint8))
    sessions = {name: hs.Session({"cameras": states(res)}) for name, res in SIZES.items()}
    times = {name: {"engine": [], "render": [], "out=": [], "render_all": []} for name in SIZES}
    for _ in range(5):
        for name, milliseconds in engine_times().items():
            times[name]["engine"].append(milliseconds)
        for name, (width, height) in SIZES.items():
            session, of = sessions[name], times[name]
            out = np.zeros((height, width, 3), np.uint8)
            of["render"].append(median(lambda k: session.render(k, light)))
            of["out="].append(median(lambda k: session.render(k, light, out=out)))
            start = time.perf_counter()
            for _view in session.render_all(None, light):
                pass
            of["render_all"].append(1000 * (time.perf_counter() - start) / POSES)
    for name, of in times.items():
        engine = statistics.median(of["engine"])
        print(f"{name}: engine {engine:.3f} ms")
        for way, values in list(of.items())[1:]:
            value = statistics.median(values)
            print(f"  {way:10} {value:.3f} ms, {value / engine:.2f} times the engine's")


if __name__ == "__main__":
    main()
