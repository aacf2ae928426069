# SPDX-License-Identifier: BSD-3-Clause
"""Views are the program's own, byte for byte; comparisons are its reports'."""

import math
import os
import shutil
import unittest

import numpy as np
from support import TABLE1, FolderTest, program, random_views, small_session

import hogelscope as hs


class Render(FolderTest):
    def assert_as_program(self, session, file, *options, **named):
        """All states, pictures and masks."""
        program("--render", "--session", file, "--output", self.path("o"), "--masks", *options)
        for view in session.render(**named):
            for own, name in ((view, f"{view.state}.png"),
                              (hs.View("", np.repeat(view.seen[..., None], 3, 2) * np.uint8(255),
                                       view.seen), None)):
                own.save(self.path("own.png"))
                if name is None:
                    continue
                with open(self.path("own.png"), "rb") as a, open(self.path("o", name), "rb") as b:
                    self.assertEqual(a.read(), b.read(), view.state)
            mask = hs.open(self.path("o", view.state + ".mask.png"), "hogels", display={
                "hogels": [1, 1], "directions": [view.seen.shape[1], view.seen.shape[0]]}).array()
            self.assertSame(mask[:, :, 0, 0, 0] == 255, view.seen)

    def test_table1(self):
        self.assert_as_program(hs.Session(TABLE1), TABLE1)

    def test_tolerance_interpolation(self):
        for document in ({"tolerance": 2.0}, {"reconstruction": "quadrilinear"},
                         {"samplesPerPixel": 2}):
            file = self.write("s.json", small_session(
                display={"hogels": [32, 32], "directions": [20, 20]}, sampling=document,
                lightField={"file": os.path.abspath("tests/data/scene.png")}))
            self.assert_as_program(hs.Session(file), file)

    def test_live_and_ideal(self):
        file = self.write("live.json", small_session(
            display={"hogels": [64, 48], "directions": [16, 12]},
            lightField={"layout": "live", "source": "scene"}))
        s = hs.Session(file)
        self.assert_as_program(s, file)
        self.assert_as_program(s, file, "--ideal", ideal=True)
        self.assertRefuses("only a 3-D scene", hs.Session(TABLE1).render, 0, ideal=True)

    def test_lens_sheet(self):
        """A live scene on a sheet: as the program, and its wrong calibration, spot and unit too."""
        file = self.write("sheet.json", small_session(
            display={"kind": "sheet", "hogels": [40, 30], "directions": [8, 1], "calibration": {
                "pitch": 5, "slope": -6, "center": 0.1, "cone": 40, "dpi": 50,
                "panel": [180, 120]}},
            lightField={"layout": "live", "source": "scene"}))
        no_leakage = "psf.windowSize=1"
        self.assertRefuses("psf.windowSize: must be 1 for a lens sheet", hs.Session, file)
        first = hs.Session(file, overrides=[no_leakage])
        self.assert_as_program(first, file, "--set", no_leakage)
        for change in ("lightField.calibration.center=0.4", "display.spot=0.001",
                       "twin.lensArray.offset=[0.001, 0]"):
            other = hs.Session(file, overrides=[no_leakage, change])
            self.assertTrue(np.any(other.render(0).image != first.render(0).image), change)
            self.assert_as_program(other, file, "--set", no_leakage, "--set", change)

    def test_twin(self):
        document = small_session(display={"hogels": [32, 32], "directions": [20, 20]},
                                 lightField={"file": os.path.abspath("tests/data/scene.png")})
        designed = self.write("designed.json", document)
        document["twin"] = {"lensArray": {"rotation": 0.5}, "colour": {"scale": [-0.02, 0, 0.02]}}
        file = self.write("built.json", document)
        self.assert_as_program(hs.Session(file), file)
        self.assertTrue(np.any(hs.Session(file).render(0).image
                               != hs.Session(designed).render(0).image))

    def test_plugins(self):
        """Content and metrics of plugins, found beside the package."""
        s = hs.Session("data/room.json")
        for state in s["cameras"]:
            state["res"] = [80, 60]
        s.save(self.path("room.json"))
        self.assert_as_program(s, self.path("room.json"))
        a, b = s.render(0), s.render(1)
        a.image = np.tile(a.image, (4, 4, 1))  # it wants 176 px
        b.image = np.tile(b.image, (4, 4, 1))
        figures = hs.compare(a.image, b.image, metrics=["ms-ssim"])
        self.assertTrue(0 < figures["ms_ssim"] < 1)
        self.assertRefuses("is not a folder", hs.add_plugin_folder, self.path("none"))

    def test_what_metrics_are_told(self):
        """Values before rounding where a view has them, and from where it was seen."""
        hs.add_plugin_folder(self.write_plugins("reference", "pixels"))
        v = hs.Session(TABLE1).render("Fig 1")
        told = hs.compare(v, v, metrics=["reference", "pixels"])
        self.assertAlmostEqual(told["reference"], v.values.mean(dtype=float), places=9)
        self.assertNotAlmostEqual(told["reference"], v.image.mean(), places=6)
        self.assertEqual(told["pixels"], v.pixels_per_degree)
        told = hs.compare(v.image, v.image, metrics=["reference", "pixels"])
        self.assertAlmostEqual(told["reference"], v.image.mean(), places=9)
        self.assertTrue(math.isnan(told["pixels"]))
        for pair in ((v, v.image), (v.image, v)):
            told = hs.compare(*pair, metrics="pixels")  # one name
            self.assertEqual(told["pixels"], v.pixels_per_degree)

    def test_values_and_formats(self):
        s = hs.Session(TABLE1)
        v = s.render("Fig 1")
        self.assertSame(np.clip(np.floor(v.values.astype(float) + 0.5), 0, 255), v.image)
        self.assertFalse(v.image[~v.seen].any())
        program("--render", "--session", TABLE1, "--states", "Fig 1", "--format", "exr", "--output",
                self.path("o"))
        v.save(self.path("own.exr"))
        sizes = {"hogels": [1, 1], "directions": [600, 600]}
        self.assertSame(hs.open(self.path("own.exr"), "hogels", display=sizes).array(),
                        hs.open(self.path("o", "Fig 1.exr"), "hogels", display=sizes).array())
        self.assertRefuses("", v.save, self.path("none", "a.png"))
        self.assertRefuses("", v.save, self.path("a.notapicture"))
        self.assertEqual(os.listdir(self.folder).count("a.notapicture"), 0)

    def test_no_input_is_replaced(self):
        """Under no name and by no link."""
        file = self.write("s.json", small_session(lightField={"file": "lf.png"}))
        shutil.copy("tests/data/scene.png", self.path("lf.png"))
        os.link(self.path("lf.png"), self.path("link.tif"))
        os.symlink("lf.png", self.path("symbolic.json"))
        session = hs.Session(file, overrides=["display.hogels=[32,32]", "display.directions=[20,20]"])
        view = session.render(0)
        for name in ("lf.png", "link.tif", "s.json", "symbolic.json"):
            with open(self.path(name), "rb") as file:
                before = file.read()
            with self.assertRaises(hs.InputError):
                view.save(self.path(name))
            if name != "s.json":
                with self.assertRaises(hs.InputError):
                    session.save(self.path(name))
            with open(self.path(name), "rb") as file:
                self.assertEqual(file.read(), before)
        with self.assertRaisesRegex(hs.InputError, "ends in .hogelscope or .json"):
            session.save(self.path("new.png"))
        session.save(self.path("s.json"))  # its own document may be
        for save in (session.save, view.save):
            with self.assertRaisesRegex(hs.InputError, "NUL"):
                save(self.path("x\0y.json"))
        self.assertEqual(sorted(os.listdir(self.path())),
                         ["lf.png", "link.tif", "s.json", "symbolic.json"])

    def test_larger_than_memory(self):
        """A picture of hogels is read once from the top, and gives no values; a store gives them."""
        s = hs.Session("data/table1.json")
        whole = s.render(["Fig 1", "Fig 6"])
        program("--pack", "data/scene.png", "--session", "data/table1.json", "--output", self.path("p.tif"))
        self.addCleanup(hs.allow_memory, 4e9)
        hs.allow_memory(20e6)  # of 26 MB
        for views in (s.copy().render(["Fig 1", "Fig 6"]),
                      s.render(["Fig 1", "Fig 6"], hs.open(self.path("p.tif")))):
            for view, same in zip(views, whole):
                self.assertSame(view.image, same.image)
                self.assertSame(view.seen, same.seen)
        self.assertIsNotNone(views[0].values)
        passed = s.copy().render("Fig 1")
        self.assertIsNone(passed.values)
        self.assertRefuses("write a PNG", passed.save, self.path("a.exr"))
        for wrong in (0, -1, float("nan"), 1e30):
            self.assertRefuses("bytes: is not between", hs.allow_memory, wrong)

    def test_states(self):
        s = hs.Session(TABLE1)
        named = s.render("Fig 3")
        self.assertEqual(named.state, "Fig 3")
        self.assertIn("600×600", repr(named))
        for same in (s.render(2), s.render(-4), s.render(np.int64(2)), s.render(s["cameras"][2]),
                     s.render(["Fig 3"])[0], s.render((2,))[0]):
            self.assertSame(same.image, named.image)
        self.assertEqual([v.state for v in s.render(["Fig 5", 0])], ["Fig 5", "Fig 1"])
        self.assertEqual(s.render([]), [])
        self.assertRefuses('^tests/data/table1.json: "Fig 9": is none of the states: Fig 1, Fig 2',
                           s.render, "Fig 9")
        self.assertRefuses(r"cameras\[0\].naem: is not known here; did you mean", s.render,
                           {"naem": "x"})
        self.assertRefuses("out of range", s.render, {"res": [100000, 100000]})
        for wrong in (3.5, [3.5], {1, 2.5}):
            with self.assertRaises(TypeError):
                s.render(wrong)
        with self.assertRaises(hs.InputError):
            s.render(17)
        with self.assertRaises(TypeError):
            s.render(0, lightfield=None)
        with self.assertRaises(TypeError):
            s.render(0, threads=10**12)
        self.assertRefuses("threads: -1 is below 0", s.render, 0, threads=-1)
        self.assertRefuses("list of camera states", hs.Session({"cameras": [5]}, check=False).render,
                           [0])

    def test_states_that_are_none(self):
        session = hs.Session(TABLE1)
        for state, error in ((b"one", TypeError), (["Fig 1", 9], hs.InputError),
                             (["Fig 1", b"x"], TypeError), (-7, hs.InputError), (6, hs.InputError)):
            with self.assertRaises(error):
                session.render(state)

    def test_files_that_change(self):
        """A session reads its light field once, and again when its file was written again."""
        views = random_views()
        folder = self.write_views(views)
        s = hs.Session(small_session(lightField={"file": folder, "layout": "views"}))
        before = s.render("middle").image
        self.assertSame(s.render("middle").image, before)
        inverted = 255 - views
        for v in range(3):
            for u in range(4):
                hs.View("", inverted[v, u], np.ones((12, 10), bool)).save(
                    os.path.join(folder, f"{v:02}_{u:02}.png"))
        self.assertSame(s.render("middle").image, s.render("middle", inverted).image)
        self.assertFalse((s.render("middle").image == before).all())

    def test_compare(self):
        s = hs.Session(small_session())
        views = random_views()
        a, b = s.render("middle", views), s.render("middle", views // 2)
        figures = hs.compare(a, b)
        error = (a.image.astype(float) - b.image) ** 2
        self.assertAlmostEqual(figures["mse"], error.mean(), 9)
        self.assertAlmostEqual(figures["mse_seen"], error[a.seen & b.seen].mean(), 9)
        self.assertAlmostEqual(figures["psnr"], 10 * math.log10(255**2 / error.mean()), 9)
        whole = hs.compare(a.image, b.image)
        self.assertEqual(whole["mse"], figures["mse"])
        self.assertAlmostEqual(whole["mse_seen"], error.mean(), 9)  # arrays are seen everywhere
        self.assertEqual(hs.compare(a, a)["ssim"], 1)
        self.assertTrue(math.isinf(hs.compare(a, a)["psnr"]))
        self.assertEqual(hs.compare(a.image[::-1], a.image[::-1])["mse"], 0)
        deep = np.full((20, 20, 3), 1000, np.uint16)
        self.assertAlmostEqual(hs.compare(deep, deep + 1)["mse_of_bits"], 1, 9)
        self.assertRefuses("60×40 px, but the reference is 50×50", hs.compare,
                           s.render("left", views), a)
        for wrong in (a.image[..., :2], a.values, a.image[0], a.image[:0], np.zeros(4, np.uint8)):
            self.assertRefuses("picture: is ", hs.compare, a.image, wrong)
        self.assertRefuses("plugin ms-sim: is not installed", hs.compare, a, b, metrics=["ms-sim"])
        with self.assertRaises(TypeError):
            hs.compare(a, 5)

    def test_views_are_pictures(self):
        """For numpy, and for notebooks; matplotlib shows them."""
        view = hs.Session(small_session()).render(0, random_views())
        self.assertIs(np.asarray(view), view.image)
        self.assertEqual(np.asarray(view, np.float32).dtype, np.float32)
        copied = np.array(view)
        self.assertIsNot(copied, view.image)
        self.assertSame(copied, view.image)
        view.save(self.path("view.png"))
        with open(self.path("view.png"), "rb") as file:
            self.assertEqual(view._repr_png_(), file.read())
        self.assertEqual(hs.compare(view, np.asarray(view))["psnr"], math.inf)
        try:
            from matplotlib import pyplot
        except ImportError:
            self.skipTest("needs python3-matplotlib")
        view.show()
        shown = pyplot.gcf().axes[0].images[0].get_array()
        self.assertSame(np.asarray(shown), view.image)
        pyplot.close("all")

    def test_views_know_how_they_are_seen(self):
        view = hs.Session(small_session()).render("middle", random_views())
        focal = 20 / math.tan(math.radians(25))  # pixels, of 40 down 50 degrees
        self.assertAlmostEqual(view.pixels_per_degree, math.radians(focal), 2)
        self.assertAlmostEqual(view.distance, 0.6, 9)
        bare = hs.View("", view.image, view.seen)
        self.assertTrue(math.isnan(bare.pixels_per_degree) and math.isnan(bare.distance))

    def test_changed_views_are_checked(self):
        """Arrays that users changed are not read beyond their ends."""
        view = hs.Session(small_session()).render("middle", random_views())
        good, png, exr = view.image, self.path("a.png"), self.path("a.exr")
        view.image = good // 2
        view.save(png)
        with open(png, "rb") as file:
            self.assertEqual(view._repr_png_(), file.read())
        for wrong in (good[..., 0], good[..., :2], good[0], good[:0], np.zeros((9000, 9000), np.uint8),
                      good.astype(np.uint16), good / 255, None, "picture"):
            view.image = wrong
            self.assertRefuses("picture: is ", view._repr_png_)
            self.assertRefuses("picture: is ", view.save, self.path("b.png"))
        view.image, values = good[3:], view.values
        self.assertRefuses("values: is ", view.save, exr)
        for wrong in (values[:1, :1], values[..., 0], values.reshape(-1), values.astype(float),
                      np.zeros((40, 60, 3, 1), np.float32)):
            view.image, view.values = good, wrong
            self.assertRefuses("values: is ", view.save, exr)
        self.assertEqual(os.listdir(self.folder), ["a.png"])
        view.image, view.values = good[::2], values[::2]
        view.save(exr)
        sizes = {"hogels": [1, 1], "directions": [60, 20]}
        saved = hs.open(exr, "hogels", display=sizes).array()
        self.assertSame(saved.reshape(20, 60, 3), values[::2] / np.float32(255))

    def test_bd_rate(self):
        anchor = [(1, 30), (2, 33), (4, 36), (8, 39)]
        half = [(rate / 2, quality) for rate, quality in anchor]
        delta = hs.bd_rate(anchor, half)
        self.assertAlmostEqual(delta["rate"], -50)
        self.assertAlmostEqual(delta["quality"], 3, 6)
        self.assertEqual((delta["from"], delta["to"]), (30, 39))
        self.assertRefuses("four are needed", hs.bd_rate, anchor[:3], half)
        self.assertRefuses("nan", hs.bd_rate, [(math.nan, 3)] * 4, half)
        with self.assertRaises(TypeError):
            hs.bd_rate([1], [2])


if __name__ == "__main__":
    unittest.main()
