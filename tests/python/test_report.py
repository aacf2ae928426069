# SPDX-License-Identifier: BSD-3-Clause
"""Reports: the program's own tables, from files and from numpy."""

import csv
import math
import os
import unittest

import numpy as np
from support import FolderTest, program, random_views, read, small_session

import hogelscope as hs


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

    def test_views_in_another_order(self):
        """Views to and fro, as the frames of a video, are those of the reference all the same."""
        frames = [view for v, row in enumerate(self.views) for view in (row[::-1] if v % 2 else row)]
        os.mkdir(self.path("frames"))
        for k, view in enumerate(frames):
            seen = np.ones(view.shape[:2], bool)
            hs.View("", view, seen).save(self.path("frames", f"{k:02}.png"))
        self.session["display"]["directions"] = [4, 3]
        with self.assertWarnsRegex(UserWarning, "read with lightField.scan=serpentine, because"):
            rows = hs.report(self.session, [self.path("frames")], output=self.path("out"))
        self.assertEqual([row["mse"] for row in rows], [0, 0])

    def test_units_against_the_design(self):
        """The program's tables; the session's own twin and dicts are as files."""
        offset = {"lensArray": {"offset": [1e-3, 0]}}
        turned = {"lensArray": {"rotation": 0.3}, "colour": {"scale": [-0.02, 0, 0.02]}}
        files = [self.write("offset.json", {"hogelscope": 1, "twin": offset}),
                 self.write("turned.json", {"hogelscope": 1, "twin": turned})]
        program("--report", "--session", self.file, "--against", "design", "--twin", files[0],
                "--twin", files[1], "--output", self.path("a"), "--quiet")
        rows = hs.report(self.session, against="design", twins=files, output=self.path("b"))
        for name in ("report.csv", "metrics.csv", "summary.csv"):
            self.assertEqual(read(self.path("a", name)), read(self.path("b", name)), name)
        self.assertEqual([row["test"] for row in rows], ["offset.json", "turned.json"] * 2)
        self.assertTrue(all(row["move_rms"] > 0 for row in rows))
        self.assertLess(rows[0]["move_rest"], 1e-6)  # an offset moves all rays alike
        self.assertGreater(rows[1]["move_rest"], 1e-3)

        dicts = hs.report(self.session, against="design", output=self.path("c"),
                          twins={"offset.json": offset, "turned.json": turned})
        self.assertEqual(dicts, rows)
        own = self.session.copy()
        own["twin"] = turned
        alone = hs.report(own, against="design", output=self.path("d"))
        self.assertEqual(alone, [{**row, "test": "twin"} for row in rows[1::2]])
        array = hs.report(hs.Session(small_session()), against="design", twins=files,
                          light_field=self.views, output=self.path("e"))
        self.assertEqual(array, rows)

        design = {"against": "design", "output": self.path("f")}
        self.assertRefuses("needs a unit", hs.report, self.session, **design)
        self.assertRefuses('for against="design"', hs.report, self.session,
                           twins=files, output=self.path("f"))
        self.assertRefuses("is there twice", hs.report, self.session, twins=files[:1] * 2, **design)
        self.assertRefuses("none.json", hs.report, self.session, twins=self.path("none.json"),
                           **design)
        self.assertRefuses("rotation", hs.report, self.session, **design,
                           twins={"a": {"lensArray": {"rotation": "much"}}})
        self.assertFalse(os.path.exists(self.path("f")))

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
            if done > 0.06:  # rows are made: the journal of the run before is replaced
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

    def test_more_than_rows(self):
        """Means, intervals and BD-rates are those of the files."""
        tests = {f"{codec}{k}": self.views // step * step + shift
                 for codec, shift in (("a", 0), ("b", 1), ("c", 2))
                 for k, step in enumerate((32, 16, 8, 4))}
        rates = {codec: {f"{codec}{k}": (1 + 0.1 * n) * 2**k for k in range(4)}
                 for n, codec in enumerate("abc")}
        bare = hs.Session(small_session())
        bare["cameras"][0]["weight"] = 3
        made = hs.report(bare, tests, light_field=self.views, groups=rates, output=self.path("out"))
        self.assertIsInstance(made, list)
        self.assertEqual(len(made), 24)
        with open(self.path("out", "summary.csv"), encoding="utf-8") as file:
            for row in csv.DictReader(file):
                if row["figure"] != "mean_psnr_seen" or row["test"] == "all tests":
                    continue
                ours, ranges = made.summary[row["test"]], made.intervals[row["test"]]
                self.assertEqual(float(row["value"]), ours["mean_psnr_seen"])
                self.assertEqual(float(row["weighted"]), ours["weighted_mean_psnr_seen"])
                self.assertEqual((float(row["low"]), float(row["high"])), ranges["mean_psnr_seen"])
        with open(self.path("out", "bd.csv"), encoding="utf-8") as file:
            lines = list(csv.DictReader(file))
        self.assertEqual(len(lines), len(made.bd))
        for line, ours in zip(lines, made.bd):
            self.assertEqual([line[name] for name in ("anchor", "group", "quality", "means")],
                             [ours[name] for name in ("anchor", "group", "quality", "means")])
            if not ours["problem"]:
                self.assertEqual(float(line["bd_rate_percent"]), ours["rate"])
                self.assertEqual(float(line["bd_rate_low"]), ours["rate_interval"][0])
        self.assertEqual({(one["anchor"], one["group"]) for one in made.bd},
                         {("a", "b"), ("a", "c"), ("b", "c")})
        self.assertTrue(os.path.exists(self.path("out", "plots", "rate_mean_psnr_seen.svg")))

    def test_rates_of_files(self):
        """Groups without rates have those of the sizes of their files, as on the command line."""
        coded = [self.write_views(self.views // step * step, f"q{step}") for step in (32, 16, 8, 4)]
        arguments = [word for name in coded for word in ("--test", name)]
        program("--report", "--session", self.file, *arguments, "--quiet", "--output", self.path("a"),
                "--group", "a=" + ",".join(coded))
        for groups in ({"a": coded}, {"a": dict.fromkeys(coded)}):
            hs.report(self.session, coded, output=self.path("b"), groups=groups)
            self.assertEqual(read(self.path("a", "summary.csv")), read(self.path("b", "summary.csv")))
        self.assertIn(b"rate_bpp", read(self.path("b", "summary.csv")))
        self.assertRefuses('"array" has no size of its own; give its rate', hs.report, self.session,
                           {"array": self.views}, output=self.path("c"), groups={"a": ["array"]})

    def test_tests_of_any_kind(self):
        """Lists of light fields and arrays; what numpy makes an array of is one."""

        class Wrapped:
            def __init__(self, array):
                self.array = array

            def __array__(self, dtype=None, copy=None):
                return self.array

        coded = self.views // 16 * 16
        rows = hs.report(hs.Session(small_session()),
                         [coded, hs.LightField(coded), Wrapped(coded), list(coded)],
                         light_field=Wrapped(self.views), output=self.path("out"))
        self.assertEqual([row["test"] for row in rows[:4]], [f"test {k}" for k in range(1, 5)])
        self.assertEqual(len({row["mse"] for row in rows[:4]}), 1)
        one = hs.report(hs.Session(small_session()), coded, light_field=self.views,
                        output=self.path("one"))
        self.assertEqual(one[0]["mse"], rows[0]["mse"])

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
        self.assertRefuses('"idael" is neither', report, s, output=out, against="idael")
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
