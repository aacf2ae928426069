# SPDX-License-Identifier: BSD-3-Clause
"""Feeds damaged copies of every kind of input to the program: python3 mutate.py [SEED] [COUNT].

An input may be refused (status 2, one line on stderr that names the program) or used (status 0 or 1). A
crash, status 3, a second line, a run that does not hear Ctrl-C after 20 s, or a file that is left over
is a finding: it is printed, its input is kept, and the script ends with status 1. The same seed gives
the same inputs."""

import pathlib
import random
import shutil
import signal
import sys
import tempfile

import attack

WORDS = [b"1e308", b"-1", b"0", b"NaN", b"null", b"[]", b"{}", b'""', b"1e-320", b"\xff\xfe",
         b"../../x", b"[[[[[[[[", b"99999999999999999999", b"true", b"\x00", b"\xe2\x80\xae"]


def render(session="s.json", *more):
    return ["--render", "--session", session, "--output", "out", *more]


# The file that is damaged, and a job that reads it.
JOBS = [
    ("s.json", render()),
    ("s.json", ["--info", "s.json"]),
    ("s.json", ["--make-cameras", "random", "--session", "s.json", "--output", "out.json"]),
    ("s.json", ["--report", "--session", "s.json", "--test", "b.png", "--output", "out"]),
    ("set.json", ["--make-cameras", "set.json", "--session", "s.json", "--output", "out.json"]),
    ("trace.csv", ["--make-cameras", "trace.csv", "--session", "s.json", "--output", "out.json"]),
    ("c.yml", render("s.json", "--calibration", "c.yml")),
    ("lenses.json", ["--stability", "--calibrations", "lenses.json", "--output", "out"]),
    ("a.store.tif", render("s.json", "--set", "lightField.layout=pack", "--set",
                           "lightField.file=a.store.tif")),
    ("out/report.journal", ["--report", "--session", "s.json", "--test", "b.png", "--output",
                            "out"]),
    ("out/report.panel1", ["--report", "--session", "s.json", "--test", "b.png", "--output",
                           "out"]),
] + [(f"a.{format}", render("s.json", "--set", f"lightField.file=a.{format}"))
     for format in ("png", "jpg", "tif", "exr", "bmp")]
# Meshes, and the fuzzer's seed that each is made of, which begins with a letter for its kind.
MESHES = {"m.glb": "scene.glb", "m.gltf": "data.gltf", "m.obj": "colours.obj", "m.ply": "binary.ply",
          "a.mtl": "a.mtl"}
JOBS += [(name, render("m.obj" if name == "a.mtl" else name, "--set", "camera.res=[60,60]"))
         for name in MESHES]
# Videos, HDF5 and pictures of rare formats, which a process of their own reads: the fuzzers' seeds.
OTHERS = {"v.mp4": "video/mpeg4.mp4", "v.mov": "video/png.mov", "v.avi": "video/png.avi",
          "v.mkv": "video/hevc.mkv", "v.webm": "video/vp9.webm", "v.y4m": "video/raw.y4m",
          "v.ts": "video/h264.ts", "v.h5": "hdf5/lf.h5"} | {f"p.{ending}": f"image/plain.{ending}" for ending in
                                   ("dds", "iff", "psd", "tga", "gif", "jp2", "webp", "dpx")}
JOBS += [(name, render(name, "--set", "camera.res=[60,60]")) for name in OTHERS if name[0] == "v"]
JOBS += [(name, render(name, "--set", "display.hogels=[4,3]", "--set", "display.directions=[4,4]"))
         for name in OTHERS if name[0] == "p"]


def mutated(data, rng):
    data = bytearray(data)
    for _ in range(rng.choice([1, 1, 2, 4, 16])):
        at = rng.randrange(len(data) + 1)
        kind = rng.randrange(6)
        if kind == 0 and data:
            data[at % len(data)] ^= 1 << rng.randrange(8)
        elif kind == 1:
            data[at:at] = rng.choice(WORDS)
        elif kind == 2:
            del data[at:at + rng.randrange(1, 40)]
        elif kind == 3:
            data[at:at + 4] = rng.randbytes(4)
        elif kind == 4:
            end = rng.randrange(len(data) + 1)
            data[at:at] = data[min(at, end):max(at, end)][:4000]
        else:
            del data[at:]
    return bytes(data)


def problem(status, lines, folder, before):
    if status is None:
        return "does not stop"
    if status not in (0, 1, 2, -signal.SIGINT):
        return f"status {status}: {lines[-1:]}"
    if status == 2 and (len(lines) != 1 or not lines[0].startswith("hogelscope: ")):
        return f"{len(lines)} lines: {lines[:3]}"
    left = [name for name in attack.contents(folder) if ".hogelscope-" in name]
    return f"left over: {left}" if left else None


def main(seed=1, count=1000):
    root = pathlib.Path(tempfile.mkdtemp(prefix="attack-"))
    whole = root / "whole"
    whole.mkdir()
    attack.make_inputs(whole)
    (whole / "out").mkdir()
    (whole / "out/report.journal").write_text('{"hogelscope report":1,"key":"k"}\n')
    (whole / "out/report.panel1").write_text('{"hogelscope panel error":1,"key":"k"}\n')
    seeds = pathlib.Path(__file__).parent.parent / "fuzz/seeds"
    for name, seed_file in MESHES.items():
        (whole / name).write_bytes((seeds / "mesh" / seed_file).read_bytes()[1:])
    for name, seed_file in OTHERS.items():
        (whole / name).write_bytes((seeds / seed_file).read_bytes())
    findings = used = 0
    for k in range(count):
        rng = random.Random(f"{seed} {k}")
        name, job = JOBS[k % len(JOBS)]
        folder = root / "work"
        shutil.copytree(whole, folder)
        (folder / name).write_bytes(mutated((whole / name).read_bytes(), rng))
        status, lines = attack.run(job, folder, timeout=20)
        used += status == 0
        wrong = problem(status, lines, folder, whole)
        if wrong:
            findings += 1
            shutil.copytree(folder, root / f"finding{k}")
            print(f"{root}/finding{k}: {' '.join(job)}: {wrong}")
        shutil.rmtree(folder)
    print(f"{count} inputs: {used} used, {count - used - findings} refused, {findings} findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
