# SPDX-License-Identifier: BSD-3-Clause
"""Sessions as mappings: where they come from, what is said of mistakes, camera sets."""

import copy
import json
import os
import pickle
import subprocess
import unittest
import warnings

import numpy as np
from support import PROGRAM, TABLE1, FolderTest, program, random_views, refusal, small_session

import hogelscope as hs


class Sessions(FolderTest):
    def test_sources(self):
        with open(TABLE1, encoding="utf-8") as file:
            text = file.read()
        from_file = hs.Session(TABLE1)
        self.assertEqual(dict(from_file), json.loads(text))
        from_dict = hs.Session(json.loads(text), folder="tests/data")
        from_text = hs.Session(text, folder="tests/data")
        image = from_file.render("Fig 1").image
        self.assertSame(from_dict.render("Fig 1").image, image)
        self.assertSame(from_text.render("Fig 1").image, image)
        os.symlink(os.path.abspath("tests/data"), self.path("link"))  # any path-like will do
        self.assertEqual(hs.Session(os.path.join(self.folder, "link", "table1.json")), from_file)
        self.assertEqual(hs.Session({"cameras": []})["hogelscope"], 1)
        given = {"display": {"fov": [60, 60]}}
        hs.Session(given)["display"]["fov"] = [1, 1]
        self.assertEqual(given, {"display": {"fov": [60, 60]}})

    def test_is_a_mapping(self):
        s = hs.Session(TABLE1)
        self.assertEqual(list(s), ["hogelscope", "display", "lightField", "sampling", "cameras"])
        wide = s.copy()
        wide["display"]["fov"] = np.array([70, 70])
        wide["cameras"][3]["res"] = (np.int64(90), 70)
        self.assertEqual(s["display"]["fov"], [60, 60])
        self.assertEqual(wide.render("Fig 4").image.shape, (70, 90, 3))
        for other in (pickle.loads(pickle.dumps(s)), copy.deepcopy(s), hs.Session(s)):
            self.assertEqual((other, other.folder, other.name), (s, "tests/data", TABLE1))
        self.assertIn('"windowSize": 5', s.text())

    def test_changes_are_used_by_the_next_view(self):
        s = hs.Session(TABLE1)
        before = s.render("Fig 4").image
        s["display"]["size"] = [0.3, 0.3]
        self.assertFalse((s.render("Fig 4").image == before).all())
        s["display"]["size"] = [0.5, 0.5]
        self.assertSame(s.render("Fig 4").image, before)

    def test_words_are_the_programs(self):
        wrong = {
            "dispaly": {"dispaly": {}},
            "fov": {"display": {"fov": [500, 50]}},
            "name": small_session(lightField={"file": "no.png", "layuot": "views"}),
            "state": small_session(lightField={"file": "v", "layout": "views"},
                                   cameras=[{"name": "a", "psf": {"sigma": -1}}]),
            "version": {"hogelscope": 7},
            "twice": small_session(lightField={"file": "v", "layout": "views"},
                                   cameras=[{"name": "a"}, {"name": "a"}]),
        }
        for name, document in wrong.items():
            file = self.write(name + ".json", {"hogelscope": 1, **document})
            said = refusal("--render", "--session", file, "--output", self.path("o"))
            self.assertEqual(self.assertRefuses("", hs.Session, file), said)
            words = said.removeprefix(file + ": ")
            s = hs.Session(document, check=False)  # checked when it is used
            self.assertEqual(self.assertRefuses("", s.render), words)
        s = hs.Session(TABLE1)
        s["display"]["fvo"] = 50
        self.assertRefuses("^tests/data/table1.json: display.fvo: is not known here", s.render, 0)
        self.assertRefuses("^nothere.json: cannot be read: No such file", hs.Session, "nothere.json")
        self.assertRefuses("^{}/none: there is no such file".format(self.folder), hs.Session,
                           self.path("none"))
        self.assertRefuses("not JSON", hs.Session, "{]")
        self.assertRefuses("not finite", hs.Session,
                           small_session(display={"fov": [1, np.nan]}))
        endless = hs.Session(small_session())
        endless["display"]["self"] = endless["display"]
        self.assertRefuses("contains itself", endless.check)
        with self.assertRaises(TypeError):
            hs.Session({"display": object()}).check()
        with self.assertRaises(TypeError):
            hs.Session(5)
        with self.assertRaises(TypeError):
            hs.Session(TABLE1, fodler="data")

    def test_overrides_and_calibration(self):
        calibration = self.write("lens.json", {
            "image_width": 80, "image_height": 60, "camera_matrix": {
                "rows": 3, "cols": 3, "data": [90, 0, 40, 0, 90, 30, 0, 0, 1]},
            "distortion_coefficients": {"rows": 1, "cols": 5, "data": [0.1, 0, 0, 0, 0]}})
        s = hs.Session(TABLE1, overrides=["display.fov=[50,50]", "psf.windowSize=1"],
                       calibration=calibration)
        self.assertEqual(s["display"]["fov"], [50, 50])
        program("--render", "--session", TABLE1, "--calibration", calibration, "--set",
                "display.fov=[50,50]", "--set", "psf.windowSize=1", "--output", self.path("o"))
        for view in s.render():
            view.save(self.path("own.png"))
            with open(self.path("own.png"), "rb") as own, \
                 open(self.path("o", view.state + ".png"), "rb") as other:
                self.assertEqual(own.read(), other.read())
        self.assertRefuses("override psf.sgima", hs.Session, TABLE1, overrides=["psf.sgima"])
        with self.assertWarnsRegex(UserWarning, "is of pictures of 80×60 px, but states have 40"):
            hs.Session(TABLE1, overrides=["camera.res=[40,30]"], calibration=calibration)

    def test_one_of_several_cameras(self):
        pair = self.write("pair.json", {
            name: {"K": [focal, 0, 40, 0, focal, 30, 0, 0, 1], "D": [0, 0, 0, 0]}
            for name, focal in (("left", 90), ("right", 70))})
        self.assertRefuses("has the cameras", hs.Session, TABLE1, calibration=pair)
        self.assertRefuses("needs a calibration", hs.Session, TABLE1, camera="right")
        with self.assertWarnsRegex(UserWarning, "does not say the size of its pictures"):
            s = hs.Session(TABLE1, calibration=pair, camera="right")
        self.assertEqual(s["cameras"][0]["intrinsics"]["fx"], 70)

    def test_save(self):
        s = hs.Session(TABLE1)
        s.save(self.path("moved.json"))
        again = hs.Session(self.path("moved.json"))
        self.assertSame(again.render("Fig 2").image, s.render("Fig 2").image)
        self.assertRefuses("", s.save, self.path("missing", "a.json"))

    def test_save_replaces_no_input(self):
        self.write("unit.json", {"lensArray": {"offset": [0.0001, 0]}})
        self.write("s.json", small_session(
            twin="unit.json", lightField={"layout": "live", "source": "scene"},
            display={"size": [0.4, 0.4], "hogels": [8, 8], "directions": [4, 4]}))
        s = hs.Session(self.path("s.json"))
        os.symlink("unit.json", self.path("link.json"))
        for name in ("unit.json", "link.json"):
            self.assertRefuses("which is read", s.save, self.path(name))
        with open(self.path("unit.json"), encoding="utf-8") as file:
            self.assertIn("lensArray", file.read())

    def test_around_a_folder(self):
        folder = self.write_views(random_views())
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            s = hs.Session(folder, overrides=["display.fov=[20,20]"])
            view = s.render(0)
        program("--render", "--session", folder, "--set", "display.fov=[20,20]", "--output",
                self.path("o"), "--quiet")
        view.save(self.path("own.png"))
        with open(self.path("own.png"), "rb") as own, \
             open(self.path("o", view.state + ".png"), "rb") as other:
            self.assertEqual(own.read(), other.read())

    def test_cameras(self):
        s = hs.Session(TABLE1)
        program("--make-cameras", "random", "--session", TABLE1, "--set", "cameraSet.count=7",
                "--set", "cameraSet.seed=3", "--set", "cameraRegion.region=arc", "--output",
                self.path("made.json"))
        made = hs.Session(self.path("made.json"))["cameras"][6:]
        states = hs.cameras(s, "random", count=7, seed=3, region={"region": "arc"})
        self.assertEqual(states, made)
        self.assertEqual(len(s["cameras"]), 6)  # unchanged
        self.assertEqual(len(hs.cameras(s, "grid", count=4, template="Fig 3", keepTemplate=False)), 4)
        self.assertEqual(hs.cameras(s, "uniform", count=4), hs.cameras(s, "grid", count=4))
        s["cameras"] += states
        self.assertEqual(s.render(states[0]["name"]).state, states[0]["name"])
        with open(self.path("trace.csv"), "w", encoding="utf-8") as file:
            file.write("0,0,0,0.6\n1,0.1,0,0.6\n2,0.2,0.1,0.7\n")
        self.assertGreater(len(hs.cameras(s, self.path("trace.csv"), count=5)), 1)
        self.assertRefuses("cameraSet.cuont", hs.cameras, s, "random", cuont=5)
        self.assertRefuses('"rnd" is not one of uniform', hs.cameras, s, "rnd")
        self.assertRefuses("out of range", hs.cameras, s, "random", count=10**7)
        self.assertRefuses("cameraRegion.extent", hs.cameras, s, region={"extent": [1, 1, -1]})

    def test_mappings_are_checked_when_made(self):
        """With the words of the program; without a light field and states, which calls may give."""
        self.assertRefuses("fvo: is not known", hs.Session, {"display": {"fvo": [1, 1]}})
        self.assertRefuses("cameras\\[0\\].fov", hs.Session, {"cameras": [{"fov": 500}]})
        self.assertRefuses("cameras", hs.Session, {"cameras": 5})
        self.assertEqual(hs.Session({"display": {"fvo": 1}}, check=False)["display"], {"fvo": 1})
        hs.Session({"display": {"size": [0.4, 0.4]}})

    def test_states_get_names(self):
        s = hs.Session({"cameras": [{"eye": [0, 0, 1]}, {"name": "mine"}, {}]})
        self.assertEqual([state["name"] for state in s["cameras"]], ["view 1", "mine", "view 3"])
        taken = hs.Session({"cameras": [{"name": "view 2"}, {}, {}]})
        self.assertEqual([state["name"] for state in taken["cameras"]],
                         ["view 2", "view 3", "view 4"])
        s["cameras"].append({"eye": [0, 0, 2]})
        s["lightField"] = {"file": "none", "layout": "views"}
        self.assertIn('"view 4"', s.text())

    def test_info(self):
        """What --info --json prints, of a light field and of a session."""
        self.write_views(random_views())
        found = hs.info(self.path("views"))
        self.assertEqual((found["layout"], found["hogels"], found["directions"]),
                         ("views", [10, 12], [4, 3]))
        self.assertIn(found["confidence"], ("sure", "likely", "unknown"))
        self.assertIsInstance(found["warnings"], list)
        file = self.write("s.json", small_session(lightField={"file": "views", "layout": "views"}))
        self.assertEqual(hs.info(file)["directions"], [4, 3])
        done = subprocess.run([PROGRAM, "--info", self.path("views"), "--json"], capture_output=True,
                              text=True, check=True)
        self.assertEqual(found, json.loads(done.stdout))
        self.assertRefuses("/none", hs.info, self.path("none"))

    def test_warnings_come_once(self):
        self.write_views(random_views())
        os.remove(self.path("views", "01_01.png"))
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            for _ in range(3):
                hs.open(self.path("views"), "views", display={"directions": [4, 3]})
        self.assertEqual(len(caught), 1)


if __name__ == "__main__":
    unittest.main()
