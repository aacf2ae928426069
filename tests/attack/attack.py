# SPDX-License-Identifier: BSD-3-Clause
"""What the attacks share: a small session with light fields in several formats, and running jobs."""

import json
import os
import pathlib
import signal
import subprocess
import sys

PROGRAM = os.environ.get(
    "HOGELSCOPE",
    str(pathlib.Path(__file__).resolve().parents[2] / "build/release/bin/hogelscope"))


def run(arguments, folder, timeout=60):
    """Status and the lines on stderr. A run that takes longer is asked to stop, as by Ctrl-C, and has
    six seconds for it: else the status is None."""
    environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    process = subprocess.Popen([PROGRAM, *arguments], cwd=folder, env=environment,
                               stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE)
    for seconds, after in ((timeout, signal.SIGINT), (6, signal.SIGKILL)):
        try:
            lines = process.communicate(timeout=seconds)[1].decode(errors="replace").splitlines()
            return process.returncode, lines
        except subprocess.TimeoutExpired:
            process.send_signal(after)
    process.wait()
    return None, []


def must(arguments, folder):
    status, lines = run(arguments, folder)
    if status != 0:
        sys.exit(f"{arguments}: {status} {lines}")


def make_inputs(folder):
    """Documents and light fields that are right; what the jobs read has the name of its kind."""
    session = {
        "hogelscope": 1,
        "display": {"size": [0.2, 0.2], "hogels": [8, 8], "directions": [6, 6], "fov": [50, 50]},
        "lightField": {"file": "a.png"},
        "cameras": [{"name": f"s{k}", "eye": [0.01 * k, 0, 0.4], "res": [40, 40],
                     "distortion": {"k1": -0.1 * k}, "psf": {"sigma": 0.8, "windowSize": 5}}
                    for k in range(2)]}
    write(folder / "s.json", session)
    for format in ("png", "jpg", "tif", "exr", "bmp"):
        must(["--generate", "scene", "--session", "s.json", "--output", f"a.{format}"], folder)
    must(["--generate", "spheres", "--session", "s.json", "--output", "b.png"], folder)
    must(["--pack", "a.png", "--session", "s.json", "--output", "a.store.tif"], folder)
    write(folder / "set.json", {"hogelscopeCameras": 1, "poses": [{"eye": [0, 0, 1]}, {"eye": [0.1, 0, 1], "weight": 3}]})
    (folder / "trace.csv").write_text("time,x,y,z\n0,0,0,0.4\n1,0.1,0,0.5\n2,0.1,0.1,0.5\n")
    write(folder / "lenses.json", {"cameras": [
        {"name": "c", "size": [40, 40], "K": [40, 40, 19.5, 19.5], "D": [-0.2, 0.1, 0, 0]}]})
    (folder / "c.yml").write_text(
        "%YAML:1.0\n---\nimage_width: 40\nimage_height: 40\n"
        "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
        "   data: [ 40., 0., 19.5, 0., 40., 19.5, 0., 0., 1. ]\n"
        "distortion_coefficients: !!opencv-matrix\n   rows: 5\n   cols: 1\n   dt: d\n"
        "   data: [ -0.2, 0.1, 0., 0., 0. ]\n")


def write(file, document):
    file.write_text(json.dumps(document))


def contents(folder):
    """Every file of a folder, hidden ones too: name → bytes."""
    return {str(file.relative_to(folder)): file.read_bytes()
            for file in sorted(folder.rglob("*")) if file.is_file()}
