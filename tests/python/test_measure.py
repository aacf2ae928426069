# SPDX-License-Identifier: BSD-3-Clause
"""depth(): the program's own figures, as Python has them."""

import csv
import json
import os
import unittest

from support import FolderTest, program, small_session

import hogelscope as hs

ROOM = "data/room.json"


class Depth(FolderTest):
    def test_is_what_the_program_says(self):
        program("--depth", "--session", ROOM, "--output", self.folder, "--states", "front",
                "--set", "camera.res=[40,30]", "--fit", self.path("fit.json"))
        with open(self.path("depth.json"), encoding="utf-8") as file:
            expected = json.load(file)
        with open(self.path("depth.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        session = hs.Session(ROOM, overrides=["camera.res=[40,30]"])
        told = []
        found = hs.depth(session, cameras=session["cameras"][:1], progress=told.append)
        self.assertEqual(told[-1], 1)
        fitted, table = found.pop("fitted"), found.pop("rows")
        self.assertEqual(found, expected)
        self.assertEqual([row["share"] for row in table], [float(row["share"]) for row in rows])
        self.assertEqual({row["state"] for row in table}, {"front"})
        self.assertEqual(fitted["lightField"]["mesh"]["scale"], expected["proposal"]["scale"])
        self.assertAlmostEqual(hs.depth(fitted)["inside"]["both"], expected["proposed"]["both"])

    def test_of_nothing(self):
        session = hs.Session(ROOM)
        session["cameras"][0]["eye"] = [0, 0, -1]
        with self.assertRaisesRegex(hs.InputError, "front: its eye is not in front of the panel"):
            hs.depth(session)


class LensSheet(FolderTest):
    def test_is_measured_but_not_swept(self):
        """The functions themselves refuse, where the program's jobs look first."""
        session = hs.Session({
            "display": {"kind": "sheet", "calibration": {
                "pitch": 5, "slope": -6, "center": 0.1, "dpi": 50, "panel": [90, 60], "cone": 40}},
            "lightField": {"layout": "quilt", "file": "none_qs6x1a1.5.png"},
            "cameras": [{"name": "a", "eye": [0, 0, 0.6]}]})
        rows = hs.measure(session)
        flips = [row for row in rows if row["figure"] == "flip"]
        self.assertEqual(len(flips), 2)
        self.assertAlmostEqual(flips[1]["closed_form"], 0.6 * 0.36397023, 6)
        with self.assertRaisesRegex(hs.InputError, "which a sweep does not know"):
            hs.sweep(session, {"parameters": {"camera.fov": [20, 30]}, "figures": ["mtf:0"]})


class Measure(FolderTest):
    def test_is_what_the_program_says(self):
        session = hs.Session(small_session(
            display={"size": [0.2, 0.2], "hogels": [40, 40], "directions": [12, 12]},
            lightField={"file": "missing.png"}))
        session.save(self.path("s.json"))
        program("--measure", "--session", self.path("s.json"), "--output", self.path("out"))
        rows = hs.measure(session)
        with open(self.path("out", "measure.csv"), encoding="utf-8") as file:
            expected = list(csv.DictReader(file))
        self.assertEqual(len(rows), len(expected))
        for row, line in zip(rows, expected):
            self.assertEqual(row["where"], line["where"])
            self.assertEqual(row["value"], float(line["value"]) if line["value"] else None)
        self.assertEqual(sorted(os.listdir(self.folder)), ["out", "s.json"])
        hs.measure(session, output=self.path("again"))
        with open(self.path("again", "measure.csv"), encoding="utf-8") as file:
            self.assertEqual(list(csv.DictReader(file)), expected)

    def test_drives_an_optimiser(self):
        try:
            import optuna
        except ImportError:
            self.skipTest("no python3-optuna")
        optuna.logging.set_verbosity(optuna.logging.ERROR)
        session = hs.Session(small_session(
            display={"size": [0.2, 0.2], "hogels": [40, 40], "directions": [12, 12]},
            lightField={"file": "missing.png"}))

        def objective(trial):
            count = trial.suggest_int("directions", 4, 16)
            session["display"]["directions"] = [count, count]
            figures = {row["figure"]: row["value"] for row in hs.measure(session)}
            return figures["depthOfField"] - 0.01 * count

        study = optuna.create_study(direction="maximize",
                                    sampler=optuna.samplers.RandomSampler(seed=1))
        study.optimize(objective, n_trials=3)
        self.assertEqual(len(study.trials), 3)


class Sweep(FolderTest):
    def test_is_a_table(self):
        session = hs.Session(small_session(
            display={"size": [0.2, 0.2], "hogels": [40, 40], "directions": [12, 12]},
            lightField={"file": "missing.png"}))
        table = {"parameters": {"display.directions": [[8, 8], [16, 16]], "psf.sigma": [0.5],
                                "display.lens": ["rectilinear"]},
                 "figures": ["depthOfField", "megapixels"], "pareto": {"megapixels": "min"}}
        rows = hs.sweep(session, table, output=self.path("out"))
        self.assertEqual([row["megapixels"] for row in rows], [0.1024, 0.4096])
        self.assertEqual([row["pareto"] for row in rows], [1, 0])
        self.assertEqual(rows[0]["display.directions"], [8, 8])
        self.assertEqual((rows[0]["psf.sigma"], rows[0]["display.lens"]), (0.5, "rectilinear"))
        self.assertEqual(sorted(os.listdir(self.path("out"))),
                         ["plots", "sweep.csv", "sweep.html"])
        session["display"]["directions"] = [8, 8]
        for state in session["cameras"]:
            state["psf"] = {"sigma": 0.5}
        depth = [row["value"] for row in hs.measure(session) if row["figure"] == "depthOfField"]
        self.assertEqual(rows[0]["depthOfField"], depth[0])
        with self.assertRaisesRegex(hs.InputError, "figures: is missing"):
            hs.sweep(session, {"parameters": {"psf.sigma": [1]}})


if __name__ == "__main__":
    unittest.main()
