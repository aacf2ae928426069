# SPDX-License-Identifier: BSD-3-Clause
"""Functions of Python as metrics of a report."""

import csv
import math
import os
import shutil
import traceback
import unittest

import numpy as np
from support import FolderTest, random_views, read, small_session

import hogelscope as hs


class Metrics(FolderTest):
    def setUp(self):
        super().setUp()
        self.views = random_views()
        self.write_views(self.views)
        self.coded = self.write_views(self.views // 16 * 16, "coded")
        self.file = self.write("s.json", small_session(
            lightField={"file": "views", "layout": "views"}))
        self.session = hs.Session(self.file)

    def test_functions_as_metrics(self):
        """A function's numbers are in every table; what it is told is what the report knows."""
        told = []

        def mean_error(reference, test, seen, info):
            told.append(info)
            self.assertEqual(reference.dtype, np.float32)
            self.assertEqual(seen.dtype, bool)
            self.assertEqual(reference.shape, (*seen.shape, 3))
            self.assertTrue(0 <= test.min() and test.max() <= 1)
            return 255**2 * np.mean((reference[seen] - test[seen]) ** 2)

        def both(reference, test, seen, info):
            return {"light": float(test.mean()), "nothing": math.nan}

        tests = {f"q{k}": self.views // step * step for k, step in enumerate((64, 32, 16, 8))}
        made = hs.report(self.session, tests, output=self.path("out"), images=True,
                         groups={"a": {f"q{k}": 2.0**k for k in range(4)},
                                 "b": {f"q{k}": 3.0**k for k in range(4)}},
                         metrics={"mean_error": mean_error, "both": both})
        self.assertEqual(len(told), 8)  # once for each state and test
        self.assertEqual({info["state"] for info in told}, {"middle", "left"})
        middle = next(info for info in told if info["state"] == "middle")
        self.assertAlmostEqual(middle["distance"], 0.6)
        focal = 20 / math.tan(math.radians(25))  # pixels, of 40 down 50 degrees
        self.assertAlmostEqual(middle["pixels_per_degree"], math.radians(focal), 2)
        self.assertEqual(middle["light"], "encoded")
        for row in made:
            self.assertAlmostEqual(row["mean_error"], row["mse_seen"], 3)
            self.assertTrue(math.isnan(row["both_nothing"]))
        with open(self.path("out", "metrics.csv"), encoding="utf-8") as file:
            for row, ours in zip(csv.DictReader(file), made):
                self.assertEqual(float(row["mean_error"]), ours["mean_error"])
                self.assertEqual(float(row["both_light"]), ours["both_light"])
        low, high = made.intervals["q0"]["mean_mean_error"]
        self.assertLess(low, high)
        errors = [row["mean_error"] for row in made if row["test"] == "q0"]
        self.assertAlmostEqual(made.summary["q0"]["mean_mean_error"], sum(errors) / 2)
        page = read(self.path("out", "report.html"), mode="r")
        self.assertIn("mean mean_error", page)
        # An error falls with the rate, so that it has a BD-rate.
        bd = next(one for one in made.bd if one["quality"] == "mean_mean_error")
        self.assertEqual(bd["problem"], "")
        self.assertTrue(os.path.exists(self.path("out", "plots", "rate_mean_mean_error.csv")))
        self.assertFalse(os.path.exists(self.path("out", "report.columns")))

    def test_functions_are_not_called_again(self):
        """A report that goes on takes their numbers from its journal, columns too."""
        bare = hs.Session(small_session())
        bare["cameras"] = hs.cameras(bare, "random", count=12)
        coded = self.views // 16 * 16
        called = []

        def metric(fails_at):
            def spread(reference, test, seen, info):
                called.append(info["state"])
                if len(called) == fails_at:
                    raise KeyError("as it\nhappens")
                return {"a": float(np.std(test)), "b": 1.0}
            return {"spread": spread}

        with self.assertRaisesRegex(hs.InputError, r"metrics: spread: raises KeyError: .*happens") as at:
            hs.report(bare, {"c": coded}, light_field=self.views, output=self.path("out"),
                      metrics=metric(6), threads=1)
        self.assertNotIn("\n", str(at.exception))
        cause = at.exception.__cause__
        self.assertEqual(cause.args, ("as it\nhappens",))
        self.assertEqual(traceback.extract_tb(cause.__traceback__)[-1].name, "spread")
        done = len(called) - 1
        rows = hs.report(bare, {"c": coded}, light_field=self.views, output=self.path("out"),
                         metrics=metric(-1))
        self.assertEqual(len(called), done + 1 + 12 - done)  # the one that failed is asked again
        self.assertEqual(len({*called}), 12)
        whole = hs.report(bare, {"c": coded}, light_field=self.views, output=self.path("other"),
                          metrics=metric(-1))
        self.assertEqual(rows, whole)
        self.assertEqual(rows.summary, whole.summary)

    def test_functions_that_are_wrong(self):
        report, s, tests = hs.report, self.session, {"c": self.coded}

        def refuses(pattern, **metrics):
            self.assertRefuses(pattern, report, s, tests, output=self.path("out"), metrics=metrics)

        refuses("returns <class 'str'>, not a number", m=lambda *_: "one")
        refuses("returns <class 'NoneType'>", m=lambda *_: None)
        refuses("returns an empty dict", m=lambda *_: {})
        refuses('returns the key "a b"', m=lambda *_: {"a b": 1})
        refuses("returns two keys of one column: m_1", m=lambda *_: {1: 2, "1": 3})
        refuses("returns a key that is no text", m=lambda *_: {"\ud800": 1})
        refuses("returns 201 numbers; a metric has at most 200",
                m=lambda *_: {f"k{k}": k for k in range(201)})
        refuses("psnr: is the name of another column", psnr=lambda *_: 1)
        refuses("raises ZeroDivisionError: division by zero", m=lambda *_: 1 / 0)
        calls = iter(range(9))
        refuses("m: returns m_1 for .*, but m_0 before", m=lambda *_: {next(calls): 1})
        self.assertRefuses("is no column's name", report, s, tests, output=self.path("out"),
                           metrics={"a,b": lambda *_: 1})
        with self.assertRaisesRegex(TypeError, "is no function"):
            report(s, tests, output=self.path("out"), metrics={"m": 5})

    def test_foreign_files_of_columns_stay(self):
        """report.columns is the program's own name: neither a user's file nor a link is touched."""
        with open(self.path("notes"), "w", encoding="utf-8") as file:
            file.write("notes")
        for name, make in (("file", shutil.copy), ("link", os.symlink), ("linked", os.link)):
            os.mkdir(self.path(name))
            columns = self.path(name, "report.columns")
            make(self.path("notes"), columns)
            self.assertRefuses("report.columns: cannot be written: .* not written by hogelscope",
                               hs.report, self.session, {"c": self.coded}, output=self.path(name),
                               metrics={"m": lambda *_: 1})
            hs.report(self.session, {"c": self.coded}, output=self.path(name))
            self.assertEqual(read(columns), b"notes")
            self.assertEqual(os.path.islink(columns), name == "link")
        os.mkdir(self.path("own"))
        with open(self.path("own", "report.columns"), "w", encoding="utf-8") as file:
            file.write("hogelscope columns of metrics 1\nm,m\n")  # of a report that was given up
        hs.report(self.session, {"c": self.coded}, output=self.path("own"))
        self.assertFalse(os.path.exists(self.path("own", "report.columns")))


if __name__ == "__main__":
    unittest.main()
