# SPDX-License-Identifier: BSD-3-Clause
"""bytes.py FOLDER: prints what Python's package says of the small documents in FOLDER, and writes
files into the working folder. Run by bytes.sh, which compares them between two builds."""

import hashlib
import json
import sys

import numpy as np

import hogelscope as hs

folder = sys.argv[1]
small = hs.Session(folder + "/small.json")
sheet = hs.Session(folder + "/sheet.json")
unit = json.load(open(folder + "/unit.json", encoding="utf-8"))["twin"]


def told(name: str, value: object) -> None:
    """Prints a value; of an array, its shape and its hash."""
    if isinstance(value, np.ndarray):
        value = (value.shape, str(value.dtype), hashlib.sha256(value.tobytes()).hexdigest())
    print(name, value)


def view(name: str, session: hs.Session, *words: object, **options: object) -> None:
    shown = session.render(*words, **options)
    told(name, shown.image)
    told(name + " seen", shown.seen)


light = hs.Session(small)
light["twin"] = unit
for state in light["cameras"]:
    state.setdefault("psf", {})["light"] = "linear"
drawn = np.random.default_rng(1).integers(0, 256, (12, 12, 32, 32, 3), dtype=np.uint8)
for state in ("front", "wide"):
    view("small " + state, small, state)
    view("unit " + state, light, state)
    view("own content " + state, small, state, hs.LightField(drawn))
view("sheet", sheet, "side")
told("content", sheet.light_field().array())
for name, session in (("small", small), ("unit", light), ("sheet", sheet)):
    told(name + " text", session.text())
    session.save(f"{name}.json")
    for row in hs.measure(session):
        told(name, row)
for row in hs.sweep(small, json.load(open(folder + "/table.json", encoding="utf-8"))):
    told("sweep", row)
told("depth", json.dumps({key: value for key, value in hs.depth(small).items() if key != "fitted"}))
told("cameras", hs.cameras(small, "random", count=3, seed=2))
for row in hs.report(small, {"drawn": hs.LightField(drawn)}, output="report"):
    told("report", row)
told("compare", hs.compare(small.render("front"), light.render("front")))
told("info", hs.info(folder + "/sheet_qs12x1a0.75.png"))
for section, value in (("display", {"fov": [500, 50]}), ("twin", {"light": {"black": 2}}),
                       ("cameras", [{"name": "a", "eye": [0, 0, 1], "pupil": {"samples": -1}}])):
    wrong = hs.Session(small)
    wrong[section] = value
    try:
        wrong.check()
    except hs.InputError as error:
        told(section, error)
