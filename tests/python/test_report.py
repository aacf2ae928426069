# SPDX-License-Identifier: BSD-3-Clause
"""Reports: the program's own tables, from files and from numpy."""

import csv
import math
import os
import unittest

import numpy as np
from support import FolderTest, program, random_views, small_session

import hogelscope as hs


def read(*names, mode="rb"):
    with open(os.path.join(*names), mode) as file:
        return file.read()


class Report(FolderTest):
    def setUp(self):
        super().setUp()
        self.views = random_views()
        self.reference = self.write_views(self.views)
        self.coded = self.write_views(self.views // 16 * 16, "coded")
        self.file = self.write("s.json", small_session(
            lightField={"file": "views", "layout": "views"}))
        self.session = hs.Session(self.file)

    def test_tables_are_the_programs(self):
        program("--report", "--session", self.file, "--test", self.coded, "--output", self.path("a"),
                "--quiet")
        rows = hs.report(self.session, [self.coded], output=self.path("b"))
        for name in ("report.csv", "metrics.csv", "summary.csv"):
            self.assertEqual(read(self.path("a", name)), read(self.path("b", name)), name)
        columns = {}
        for name in ("report.csv", "metrics.csv"):
            with open(self.path("b", name), encoding="utf-8") as file:
                for row, ours in zip(csv.DictReader(file), rows):
                    for key, text in row.items():
                        value = ours[key]
                        columns[key] = value
                        if isinstance(value, str):
                            self.assertEqual(text, value)
                        else:
                            self.assertAlmostEqual(float(text), value, 3)
        self.assertEqual(set(columns), set(rows[0]))
        self.assertEqual([row["state"] for row in rows], ["middle", "left"])

    def test_numpy_is_as_files(self):
        """The same rows, and a report of numpy needs no file at all."""
        files = hs.report(self.session, {"coded": self.coded}, output=self.path("a"))
        bare = hs.Session(small_session())
        arrays = hs.report(bare, {"coded": self.views // 16 * 16}, light_field=self.views,
                           output=self.path("b"))
        self.assertEqual(arrays, files)
        opened = hs.report(bare, {"coded": hs.open(self.coded, "views")},
                           light_field=hs.LightField(self.views), output=self.path("c"))
        self.assertEqual(opened, files)
        self.assertIn(b"array, XXH3-128", read(self.path("b", "report.html")))

    def test_other_content_is_another_report(self):
        """A journal of other values is not taken up."""
        bare = hs.Session(small_session())
        journals = []

        def stop_late(done):
            name = self.path("out", "report.journal")
            if os.path.exists(name):
                journals.append(read(name, mode="r").splitlines()[0])
                raise RuntimeError("enough")

        bare["cameras"] = hs.cameras(bare, "random", count=30)
        for state in bare["cameras"]:
            state["res"] = [300, 300]
        for views in (self.views // 2, self.views // 2, self.views // 4):
            with self.assertRaisesRegex(RuntimeError, "enough"):
                hs.report(bare, {"a": views}, light_field=self.views, output=self.path("out"),
                          progress=stop_late)
        self.assertEqual(journals[0], journals[1])
        self.assertNotEqual(journals[1], journals[2])

    def test_groups(self):
        tests, rates = {}, {"a": {}, "b": {}}
        for k, step in enumerate((32, 16, 8, 4)):
            tests[f"a{k}"] = self.views // step * step
            tests[f"b{k}"] = self.views // step * step
            rates["a"][f"a{k}"] = 1.0 * 2**k
            rates["b"][f"b{k}"] = 0.5 * 2**k
        bare = hs.Session(small_session())
        rows = hs.report(bare, tests, light_field=self.views, groups=rates, output=self.path("out"),
                         images=True)
        self.assertEqual(len(rows), 16)
        self.assertRegex(read(self.path("out", "bd.csv"), mode="r"), r"a,b,.*-50")
        self.assertTrue(os.path.exists(self.path("out", "test8", "left.png")))
        points = {name: [(rates[name][test], row["psnr_seen"]) for test in rates[name]
                         for row in rows if row["test"] == test and row["state"] == "left"]
                  for name in rates}
        self.assertAlmostEqual(hs.bd_rate(points["a"], points["b"])["rate"], -50, 6)

    def test_against_ideal(self):
        live = hs.Session(small_session(
            display={"hogels": [32, 32], "directions": [8, 8]},
            lightField={"layout": "live", "source": "scene"}))
        rows = hs.report(live, output=self.path("out"), against="ideal")
        self.assertEqual([row["test"] for row in rows], ["display"] * 2)
        self.assertTrue(all(math.isfinite(row["psnr_seen"]) for row in rows))
        self.assertRefuses("only a 3-D scene", hs.report, self.session, output=self.path("o"),
                           against="ideal")

    def test_hostile(self):
        report, s, out = hs.report, self.session, self.path("out")
        self.assertRefuses("tests: is empty", report, s, {}, output=out)
        sized = hs.Session(small_session(display={"hogels": [10, 12]}))
        self.assertRefuses("display.hogels: is 10×12, but .* has 4×4", report, sized,
                           {"a": np.zeros((3, 4, 4, 4, 3), np.uint8)}, output=out,
                           light_field=self.views)
        self.assertRefuses("cannot be made|cannot", report, s, {"a": self.coded}, output="/proc/no")
        self.assertRefuses('"idael" is not', report, s, output=out, against="idael")
        self.assertRefuses('"c" is none of the tests', report, s, {"a": self.coded}, output=out,
                           groups={"g": {"c": 1}})
        self.assertRefuses("needs four or more", report, s, {"a": self.coded}, output=out,
                           groups={"g": {"a": 1}})
        self.assertRefuses("not a number above 0", report, s, {"a": self.coded}, output=out,
                           groups={"g": {"a": -1}})
        self.assertRefuses("/none: ", report, s, {"a": self.path("none")}, output=out)
        self.assertRefuses("camera state", report, s, {"a": self.coded}, output=out, cameras=[])
        for wrong in ({"a": None}, {"a": 5}, [5]):
            with self.assertRaises(TypeError):
                report(s, wrong, output=out)
        with self.assertRaises(TypeError):
            report(s, {"a": self.coded})
        self.assertFalse(os.path.exists(out))


if __name__ == "__main__":
    unittest.main()
