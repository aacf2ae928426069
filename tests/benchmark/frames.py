#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What rendering a light field in time costs, beside decoding the same videos by FFmpeg's program.

    python3 tests/benchmark/frames.py build/release/bin/hogelscope [VIEWS FRAMES]

81 videos (HEVC, 480×320) of 100 frames, one state with leakage. It prints the seconds of ffmpeg, of
the bare views (as many states of one frame) and of the run, each three times in turn, the ratio
(run - bare) / ffmpeg, and the memory of all processes together.
"""

import json
import os
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

PROGRAM = os.path.abspath(sys.argv[1])
SIDE, FRAMES = [int(text) for text in sys.argv[2:4]] or (9, 100)
WIDTH, HEIGHT = 480, 320


def content():
    """A texture with detail of several sizes, larger than the pictures cut out of it."""
    random = np.random.default_rng(0)
    texture = np.zeros((1024, 1024, 3))
    for cells, weight in ((8, 1.0), (32, 0.6), (128, 0.3), (512, 0.15)):
        texture += weight * random.random((cells, cells, 3)).repeat(1024 // cells, 0).repeat(
            1024 // cells, 1)
    return (255 * texture / texture.max()).astype(np.uint8)


def write_videos(folder):
    texture = content()
    os.mkdir(folder)
    for v in range(SIDE):
        for u in range(SIDE):
            frames = [texture[200 + 3 * v + t:][:HEIGHT, 200 + 3 * u + 2 * t:][:, :WIDTH]
                      for t in range(FRAMES)]
            subprocess.run(
                ["ffmpeg", "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s",
                 f"{WIDTH}x{HEIGHT}", "-r", "25", "-i", "-", "-c:v", "libx265", "-preset",
                 "veryfast", "-x265-params", "log-level=error", "-crf", "28", "-pix_fmt",
                 "yuv420p", os.path.join(folder, f"{v:02}_{u:02}.mp4")],
                input=np.ascontiguousarray(frames).tobytes(), check=True)


def session(name, file, states):
    state = {"eye": [0, 0, 0.6], "fov": 25, "res": [600, 400],
             "psf": {"sigma": 0.67, "windowSize": 5}}
    with open(name, "w") as text:
        json.dump({"hogelscope": 1, "display": {"size": [0.3, 0.2], "fov": [20, 20]},
                   "lightField": {"file": file, "layout": "views"},
                   "cameras": [{**state, "name": f"s{k}"} for k in range(states)]}, text)
    return name


def decode(folder):
    for name in sorted(os.listdir(folder)):
        subprocess.run(["ffmpeg", "-loglevel", "error", "-i", os.path.join(folder, name), "-f",
                        "rawvideo", "-pix_fmt", "rgb24", "-y", "/dev/null"], check=True)


def render(*arguments):
    subprocess.run([PROGRAM, "--render", "--output", "out", "--quiet", *arguments], check=True)


def seconds(work, *arguments):
    begin = time.perf_counter()
    work(*arguments)
    return time.perf_counter() - begin


def memory_of(*arguments):
    """The most megabytes of the program and its copies together while it runs (PSS)."""
    most = 0
    with subprocess.Popen([PROGRAM, "--render", "--output", "out", "--quiet", *arguments]) as run:
        while run.poll() is None:
            total = 0
            copies = subprocess.run(["pgrep", "-P", str(run.pid)], capture_output=True, text=True,
                                    check=False).stdout.split()
            for process in (str(run.pid), *copies):
                try:
                    with open(f"/proc/{process}/smaps_rollup") as lines:
                        total += sum(int(line.split()[1]) for line in lines
                                     if line.startswith("Pss:"))
                except OSError:
                    pass  # it has ended
            most = max(most, total)
            time.sleep(0.2)
    return most / 1000


def main():
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        write_videos("videos")
        moving = session("moving.json", "videos", 1)
        subprocess.run([PROGRAM, "--export", "views", "--session", moving, "--output", "still",
                        "--quiet"], check=True)
        many = session("many.json", "still", FRAMES + 1)
        one = session("one.json", "still", 1)
        runs = [(seconds(decode, "videos"),
                 seconds(render, "--session", many) - seconds(render, "--session", one),
                 seconds(render, "--session", moving, "--frames", "all")) for _ in range(3)]
        decoding, bare, run = (statistics.median(column) for column in zip(*runs))
        print(f"ffmpeg {decoding:.2f} s, bare views {bare:.2f} s, run {run:.2f} s")
        print(f"(run - bare) / ffmpeg {(run - bare) / decoding:.2f}")
        limit = 6 * SIDE**2 * WIDTH * HEIGHT * 3 / 1e6 + 6 * SIDE**2 + 200
        print(f"memory {memory_of('--session', moving, '--frames', 'all'):.0f} MB, limit of 6 "
              f"frames, 6 MB a video and 200 MB: {limit:.0f} MB")


if __name__ == "__main__":
    main()
