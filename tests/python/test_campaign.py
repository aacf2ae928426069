# SPDX-License-Identifier: BSD-3-Clause
"""Campaigns: several scenes with the same tests, against their single reports and numpy."""

import csv
import itertools
import os
import re
import shutil
import subprocess
import tempfile
import unittest

import numpy as np
from support import PROGRAM, FolderTest, program, read, refusal

import hogelscope as hs

SCENES = {"shop": 3, "bikes": 2, "tower": 4}  # states
CODECS = {"A": 3.0, "B": 5.0, "C": 4.2}  # errors of the coarsest
STEPS = (1, 2, 3, 4)
HOGELS, DIRECTIONS = (16, 12), (3, 2)


def rows_of(*path):
    with open(os.path.join(*path), newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def files_in(folder):
    """What all files of a folder have, without times; by their names in it."""
    found = {}
    for place, _, names in os.walk(folder):
        for name in names:
            data = read(place, name)
            if name.endswith(".html"):
                data = re.sub(rb"\d{4}-\d\d-\d\d[ T]\d\d:\d\d(:\d\d)?", b"DATE", data)
            found[os.path.relpath(os.path.join(place, name), folder)] = data
    return found


class CampaignTest(FolderTest):
    made = None  # the files, which are made once

    def setUp(self):
        super().setUp()
        if CampaignTest.made is None:
            self.make()
            CampaignTest.made = tempfile.TemporaryDirectory()
            shutil.copytree(self.folder, CampaignTest.made.name, dirs_exist_ok=True)
        else:
            shutil.copytree(CampaignTest.made.name, self.folder, dirs_exist_ok=True)
        with open(self.path("rates.csv"), newline="", encoding="utf-8") as file:
            self.rates = {(row["scene"], row["test"]): float(row["bits"])
                          for row in csv.DictReader(file)}
        self.file = self.path("campaign.json")

    def make(self):
        random = np.random.default_rng(8)
        (nx, ny), (du, dv) = HOGELS, DIRECTIONS
        rates = [["scene", "test", "bits"]]
        for number, (scene, states) in enumerate(SCENES.items()):
            y, x = np.mgrid[:ny * dv, :nx * du]
            own = np.stack([127 + 60 * np.sin(x * a + y * b + number)
                            for a, b in random.uniform(0.1, 0.4, (3, 2))], -1)
            self.picture(own, f"{scene}.png")
            self.session(scene, states)
            noise = random.normal(0, 1, own.shape)
            for codec, coarsest in CODECS.items():
                for step in STEPS:
                    error = coarsest * (5 - step) * (1 + 0.1 * number)
                    self.picture(own + error * noise, "coded", scene, f"{codec}_{step}.png")
                    rates.append([scene, f"{codec} q{step}",
                                  0.1 * 1.7**step * (1 + 0.1 * random.random())])
        with open(self.path("rates.csv"), "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows(rates)
        self.write("campaign.json", self.document())

    def picture(self, values, *names):
        os.makedirs(os.path.dirname(self.path(*names)), exist_ok=True)
        values = np.clip(values, 0, 255).round().astype(np.uint8)
        hs.View("", values, np.ones(values.shape[:2], bool)).save(self.path(*names))

    def session(self, name, states, **light):
        cameras = [{"name": f"eye{k}", "eye": [0.04 * k - 0.08, 0.01 * k, 0.6], "fov": 45,
                    "res": [36, 28]} for k in range(states)]
        cameras.append({"name": "far", "eye": [0, 0, 1.1], "fov": 25, "res": [30, 30]})
        display = {"size": [0.4, 0.32], "fov": [30, 25], "hogels": list(HOGELS),
                   "directions": list(DIRECTIONS)}
        return self.write(f"{name}.json", {
            "hogelscope": 1, "display": display, "cameras": cameras,
            "lightField": {"file": f"{name}.png", **light}})

    @staticmethod
    def document(**changes):
        return {"scenes": {"shop": "shop.json", "bikes": {"session": "bikes.json",
                                                          "states": "eye*"},
                           "tower": "tower.json"},
                "tests": [{"group": codec, "name": "q{q}", "q": list(STEPS),
                           "file": "coded/{scene}/" + codec + "_{q}.png"} for codec in CODECS],
                "rates": "rates.csv", **changes}

    def campaign(self, output="out", *more, file=None):
        """Makes it beside its files, as people do; what it says on stderr."""
        done = subprocess.run(
            [PROGRAM, "--report", "--campaign", os.path.basename(file or self.file), "--output",
             output, "--quiet", *more], capture_output=True, text=True, cwd=self.folder,
            check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stderr


class Figures(CampaignTest):
    out = None  # the campaign, which is made once

    def setUp(self):
        super().setUp()
        if Figures.out is None:
            self.campaign()
            Figures.out = tempfile.TemporaryDirectory()
            shutil.copytree(self.path("out"), Figures.out.name, dirs_exist_ok=True)
        else:
            shutil.copytree(Figures.out.name, self.path("out"))

    def test_each_scene_is_its_own_report(self):
        """The folders have the files of --report, byte for byte but for dates."""
        for scene in SCENES:
            files = [f"coded/{scene}/{codec}_{step}.png" for codec in CODECS for step in STEPS]
            arguments = ["--report", "--session", f"{scene}.json"]
            if scene == "bikes":
                arguments += ["--states", "eye*"]
            for file in files:
                arguments += ["--test", file]
            for codec in CODECS:
                own = [file for file in files if f"/{codec}_" in file]
                arguments += ["--group", f"{codec}={','.join(own)}"]
                for step, file in zip(STEPS, own):
                    arguments += ["--rate", f"{file}={self.rates[scene, f'{codec} q{step}']!r}"]
            moved = self.path("out", scene)
            campaign = files_in(moved)
            shutil.rmtree(moved)
            subprocess.run([PROGRAM, *arguments, "--output", f"out/{scene}", "--quiet"],
                           cwd=self.folder, check=True)
            alone = files_in(moved)
            self.assertEqual(sorted(campaign), sorted(alone))
            for name, data in campaign.items():
                self.assertEqual(data, alone[name], (scene, name))

    def test_rows_are_those_of_the_reports(self):
        rows = rows_of(self.path("out"), "campaign.csv")
        count = sum((SCENES[scene] + (scene != "bikes")) * 12 for scene in SCENES)
        self.assertEqual(len(rows), count)
        names = list(rows[0])
        self.assertEqual(len(names), len(set(names)))
        at = 0
        for scene in SCENES:
            report = rows_of(self.path("out", scene), "report.csv")
            metrics = rows_of(self.path("out", scene), "metrics.csv")
            self.assertEqual(names[:len(report[0]) + 1], ["scene", *report[0]])
            self.assertEqual(set(names), {"scene", *report[0], *metrics[0]})
            for one, other in zip(report, metrics):
                row = {**other, **one, "scene": scene}
                row["test"] = re.sub(r"coded/\w+/(\w)_(\d).png", r"\1 q\2", row["test"])
                self.assertEqual(rows[at], row)
                at += 1
        self.assertEqual(at, len(rows))

    def means(self, scene):
        """{test: {mean: value}} from the rows alone."""
        rows = [row for row in rows_of(self.path("out"), "campaign.csv")
                if row["scene"] == scene]
        means = {}
        for test in {row["test"] for row in rows}:
            own = [row for row in rows if row["test"] == test]
            psnr = np.array([float(row["psnr_seen"]) for row in own])
            mse = np.array([float(row["mse_seen"]) for row in own])
            means[test] = {
                "mean_psnr_seen": psnr[np.isfinite(psnr)].mean(),
                "psnr_of_mean_mse_seen": 10 * np.log10(255**2 / mse.mean()),
                "mean_ssim_seen": np.mean([float(row["ssim_seen"]) for row in own])}
        return means

    def test_means_over_scenes(self):
        summary = {(row["test"], row["figure"]): row
                   for row in rows_of(self.path("out"), "summary.csv")
                   if row["scene"] == "all scenes"}
        of_scenes = [self.means(scene) for scene in SCENES]
        self.assertEqual({test for test, _ in summary}, set(of_scenes[0]))
        for test in of_scenes[0]:
            self.assertEqual(summary[test, "scenes"]["value"], "3")
            for figure in of_scenes[0][test]:
                wanted = np.mean([scene[test][figure] for scene in of_scenes])
                row = summary[test, figure]
                self.assertLess(abs(float(row["value"]) / wanted - 1), 1e-12, (test, figure))
                self.assertLessEqual(float(row["low"]), wanted)
                self.assertGreaterEqual(float(row["high"]), wanted)

    def test_intervals_by_draws_of_our_own(self):
        """Scenes, then states in them: another generator's intervals, to a few per cent."""
        rows = rows_of(self.path("out"), "campaign.csv")
        random = np.random.default_rng(2)
        for test in ("A q1", "C q4"):
            values = [np.array([float(row["psnr_seen"]) for row in rows
                                if row["scene"] == scene and row["test"] == test])
                      for scene in SCENES]
            draws = [np.mean([random.choice(values[scene], len(values[scene])).mean()
                              for scene in random.integers(0, 3, 3)]) for _ in range(20000)]
            low, high = np.percentile(draws, [2.5, 97.5])
            own = next(row for row in rows_of(self.path("out"), "summary.csv")
                       if (row["scene"], row["test"], row["figure"]) ==
                       ("all scenes", test, "mean_psnr_seen"))
            for mine, theirs in ((low, own["low"]), (high, own["high"])):
                self.assertLess(abs(float(theirs) - mine), 0.08 * (high - low))

    def test_deltas_over_scenes(self):
        rows = rows_of(self.path("out"), "bd.csv")
        over = [row for row in rows if row["scene"] == "all scenes"]
        self.assertEqual(len(over), 3 * len({row["quality"] for row in rows}))
        for row in over:
            key = [row[name] for name in ("anchor", "group", "quality", "over", "means")]
            own = [other for other in rows if other["scene"] != "all scenes" and
                   [other[n] for n in ("anchor", "group", "quality", "over", "means")] == key]
            self.assertEqual([other["scene"] for other in own], list(SCENES))
            deltas = np.array([float(other["bd_rate_percent"]) for other in own])
            known = deltas[np.isfinite(deltas)]
            self.assertEqual((row["scenes"], row["scenes_better"]),
                             (str(len(known)), str((known < 0).sum())))
            if len(known) == 0:
                continue
            self.assertLess(abs(float(row["bd_rate_percent"]) - known.mean()), 1e-9)
            self.assertLess(abs(float(row["sign_test_p"]) - self.sign_test(known)), 1e-12)
            self.assertLess(abs(float(row["signed_rank_p"]) - self.rank_test(known)), 1e-12)
            if row["bd_rate_low"] != "nan":
                self.assertLessEqual(float(row["bd_rate_low"]), float(row["bd_rate_high"]))

    @staticmethod
    def sign_test(values):
        signs = (values > 0).sum()
        all_signs = [sum(chosen) for chosen in itertools.product((0, 1), repeat=len(values))]
        middle = len(values) / 2
        return np.mean([abs(number - middle) >= abs(signs - middle) for number in all_signs])

    @staticmethod
    def rank_test(values):
        ranks = 1 + np.argsort(np.argsort(np.abs(values)))
        middle = ranks.sum() / 2
        own = abs(ranks[values > 0].sum() - middle)
        return np.mean([abs(np.dot(chosen, ranks) - middle) >= own
                        for chosen in itertools.product((0, 1), repeat=len(values))])

    def test_the_page_opens_with_scenes_and_groups(self):
        page = read(self.path("out", "campaign.html"), mode="r")
        table = page[page.index("<table"):page.index("</table>")]
        for scene in SCENES:
            self.assertIn(f'<a href="{scene}/report.html">{scene}</a>', table)
        for codec in ("B", "C"):
            self.assertIn(f"{codec} against A", table)
        deltas = [row for row in rows_of(self.path("out"), "bd.csv")
                  if row["quality"] == "mean_psnr_seen" and row["anchor"] == "A"]
        for row in deltas:
            text = f"{float(row['bd_rate_percent']):.2f}".replace("-", "\N{MINUS SIGN}")
            self.assertIn(text + " %", table)
        self.assertNotIn("Missing", page)

    def test_from_python(self):
        made = hs.campaign(self.file, output=self.path("python"))
        wanted = rows_of(self.path("out"), "campaign.csv")
        self.assertEqual(len(made), len(wanted))
        for row, other in zip(made, wanted):
            self.assertEqual((row["scene"], row["test"], row["state"]),
                             (other["scene"], other["test"], other["state"]))
            self.assertEqual(row["psnr_seen"], float(other["psnr_seen"]))
        for table, rows in (("summary.csv", made.summary), ("bd.csv", made.bd)):
            self.assertEqual(read(self.path("python", table)), read(self.path("out", table)))
            self.assertEqual(len(rows), len(rows_of(self.path("out"), table)))
        self.assertEqual(made.missing, [])
        document = self.document(scenes={"shop": self.path("shop.json")}, rates=self.path(
            "rates.csv"), metrics=["ms-ssim"])
        for test in document["tests"]:
            test["file"] = self.path(test["file"])
        document.pop("rates")
        one = hs.campaign(document, output=self.path("dict"))
        self.assertEqual({row["scene"] for row in one}, {"shop"})
        self.assertIn("ms_ssim", one[0])


class Runs(CampaignTest):
    def test_the_state_of_a_run(self):
        self.campaign("out", "--shard", "1/2")
        for step in ("first", "again"):
            done = subprocess.run([PROGRAM, "--status", self.path("out")], capture_output=True,
                                  text=True, check=False)
            self.assertEqual(done.returncode, 1, step)
            self.assertIn("shop: ", done.stdout)
            self.assertIn("the campaign is not finished", done.stdout)
        self.campaign("out")
        done = subprocess.run([PROGRAM, "--status", self.path("out")], capture_output=True,
                              text=True, check=True)
        self.assertIn("the campaign is finished", done.stdout)

    def test_what_is_missing_is_named(self):
        for step in (1, 2):
            os.remove(self.path("coded", "bikes", f"B_{step}.png"))
        shutil.rmtree(self.path("coded", "tower"))
        dry = subprocess.run([PROGRAM, "--report", "--campaign", "campaign.json", "--output", "x",
                              "--dry-run"], cwd=self.folder, capture_output=True, text=True,
                             check=True).stdout
        self.assertIn("shop: 12 tests of 4 views\n", dry)
        self.assertIn("bikes: 10 tests of 2 views\n  B q1 is missing: coded/bikes/B_1.png is not "
                      "there\n", dry)
        self.assertIn("tower: no test is there\n", dry)
        self.assertIn("68 comparisons, about ", dry)
        self.assertFalse(os.path.exists(self.path("x")))
        said = self.campaign()
        self.assertIn("bikes: B q1 is missing: coded/bikes/B_1.png is not there", said)
        self.assertIn("bikes: B has 2 test(s), but a curve needs four or more", said)
        page = read(self.path("out", "campaign.html"), mode="r")
        self.assertIn("<td>tower: A q1 is missing: coded/tower/A_1.png is not there</td>", page)
        over = {row["group"]: row for row in rows_of(self.path("out"), "bd.csv")
                if row["scene"] == "all scenes" and row["quality"] == "mean_psnr_seen"
                and row["anchor"] == "A"}
        self.assertEqual((over["B"]["scenes"], over["C"]["scenes"]), ("1", "2"))

    def test_frames(self):
        """Rows of frames, with their numbers; {T} beside {scene}."""
        for scene in ("shop", "bikes"):
            for folder, name in (("", scene), ("coded/" + scene + "/", "A_1"),
                                 ("coded/" + scene + "/", "B_1")):
                source = self.path(*f"{folder}{name}.png".split("/"))
                for frame in range(3):
                    os.makedirs(self.path("time", folder), exist_ok=True)
                    shutil.copy(source, self.path("time", folder, f"{name}.{frame}.png"))
            self.session(scene, 1, file=f"time/{scene}.{{T}}.png", fps=10)
        file = self.write("time.json", {
            "scenes": {"shop": "shop.json", "bikes": "bikes.json"},
            "tests": [{"name": codec, "file": "time/coded/{scene}/" + codec + "_1.{T}.png"}
                      for codec in "AB"]})
        self.campaign("out", file=file)
        rows = rows_of(self.path("out"), "campaign.csv")
        self.assertEqual(len(rows), 2 * 2 * 3 * 2)
        self.assertEqual({row["frame"] for row in rows}, {"0", "1", "2"})
        self.assertEqual(rows[0]["test"], "A")
        self.assertFalse(os.path.exists(self.path("out", "bd.csv")))
        self.session("bikes", 1)
        done = refusal("--report", "--campaign", file, "--output", self.path("mixed"))
        self.assertIn("some have frames and some are stills", done)

    def test_chosen_columns(self):
        """The table of means has the columns that are named, in their order."""
        document = self.document(tables={"columns": ["mean_ssim_seen", "scenes"]})
        program("--report", "--campaign", self.write("c.json", document), "--output",
                self.path("chosen"), "--quiet")
        tex = read(self.path("chosen", "plots", "campaign.tex"), mode="r")
        heads = tex[tex.rindex("\\hline\ntest"):].split("\n")[1]
        self.assertEqual(heads, "test & mean SSIM & scenes \\\\")

    def test_refusals(self):
        def line(document, *more):
            file = self.write("c.json", document)
            text = refusal("--report", "--campaign", file, "--output", self.path("no"), *more)
            self.assertEqual(text.count("\n"), 0)
            return text.removeprefix(file + ": ")

        def test(**changes):
            return self.document(tests=[{"file": "coded/{scene}/A_{q}.png", "q": [1, 2],
                                         **changes}])

        self.assertIn("scenes: is not an object of scenes", line({"tests": []}))
        self.assertIn("tests: is not a list of tests", line(self.document(tests=[])))
        self.assertIn("scenes.a/b: is not the name of a folder",
                      line(self.document(scenes={"a/b": "shop.json"})))
        self.assertIn("tests[0].q: is not a list of numbers or texts", line(test(q=5)))
        self.assertIn("tests[0].file: has {r}, which is neither", line(test(file="{scene}{r}{q}")))
        self.assertIn("tests[0].p: is not in the file", line(test(p=[1])))
        self.assertIn('two have the name "x"', line(test(name="x")))
        self.assertIn("did you mean", line(self.document(metrcs=[])))
        for tables, words in ((5, "tables: is not an object"),
                              ({"columns": "mse"}, "tables.columns: is not a list of names"),
                              ({"columns": [5]}, "tables.columns: is not a list of names"),
                              ({"rows": []}, "tables.rows"),
                              ({"columns": ["mean_of"]}, 'tables.columns: "mean_of" is none of '
                                                         "scenes, mean_psnr")):
            self.assertIn(words, line(self.document(tables=tables)))
        without = {"scenes": {"shop": "none.json"}, "tests": self.document()["tests"]}
        self.assertIn(self.path("none.json") + ": cannot be read", line(without))
        self.assertIn("scenes.a: is neither a session's file", line(self.document(scenes={"a": 5})))
        with open(self.path("rates.csv"), "w", encoding="utf-8") as file:
            file.write("shop,A q1,zero\nshop,D,1\n")
        self.assertIn('line 2: "D" is no test of the campaign', line(self.document()))
        self.assertIn("--campaign: says what each scene compares: leave out --test", refusal(
            "--report", "--campaign", self.file, "--output", "x", "--test", "a.png"))
        self.assertIn("--dry-run: is for --campaign", refusal(
            "--report", "--session", "s.json", "--output", "x", "--test", "a.png", "--dry-run"))
        self.assertFalse(os.path.exists(self.path("no", "campaign.csv")))

    def test_no_input_is_overwritten(self):
        """A rate table of the name of a result, in the folder of the results."""
        os.makedirs(self.path("out"))
        shutil.copy(self.path("rates.csv"), self.path("out", "summary.csv"))
        before = read(self.path("out", "summary.csv"))
        file = self.write("own.json", self.document(rates="out/summary.csv"))
        refusal("--report", "--campaign", file, "--output", self.path("out"))
        self.assertEqual(read(self.path("out", "summary.csv")), before)


if __name__ == "__main__":
    unittest.main()
