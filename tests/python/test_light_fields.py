# SPDX-License-Identifier: BSD-3-Clause
"""Light fields from numpy and from files: order, types, memory, lifetime, hostile input."""

import gc
import os
import subprocess
import sys
import threading
import unittest
import warnings

import numpy as np
from support import TABLE1, FolderTest, program, random_views, small_session

import hogelscope as hs


def resident_bytes():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


class LightFields(FolderTest):
    def setUp(self):
        super().setUp()
        self.session = hs.Session(small_session())

    def test_array_is_views(self):
        """The same pictures as of a folder of views, and of the pixel itself."""
        views = random_views()
        q = hs.open(self.write_views(views), layout="views")
        self.assertEqual(q.shape, (3, 4, 12, 10, 3))
        self.assertEqual(q.dtype, np.uint8)
        self.assertEqual(len(q.files), 12)
        self.assertSame(q.array(), views)
        lf = hs.LightField(views)
        self.assertEqual((lf.shape, lf.dtype, lf.files), (q.shape, q.dtype, []))
        self.assertSame(lf.array(), views)
        for state in ("middle", "left"):
            view = self.session.render(state, lf)
            self.assertTrue(view.seen.any())
            self.assertSame(view.image, self.session.render(state, q).image)
            self.assertSame(view.image, self.session.render(state, views).image)

    def test_direction(self):
        """From the right the last column of views is seen, from above the first row."""
        views = np.zeros((3, 3, 8, 8, 3), np.uint8)
        views[:, 2, :, :, 0] = 200
        views[0, :, :, :, 1] = 100
        far = {"lookat": [0, 0, 0], "fov": 30, "res": [9, 9]}
        for eye, colour in (([0.25, 0, 0.5], [200, 0, 0]), ([0, 0.25, 0.5], [0, 100, 0]),
                            ([-0.25, 0, 0.5], [0, 0, 0]), ([0.25, 0.25, 0.5], [200, 100, 0])):
            view = self.session.render({"eye": eye, **far}, views)
            self.assertEqual(list(view.image[4, 4]), colour, eye)
        views[:] = 0
        views[:, :, 0, 7] = 250  # the top right hogel
        view = self.session.render({"eye": [0, 0, 0.5], "fov": 60, "res": [90, 90]}, views)
        y, x = np.argwhere(view.image[:, :, 0] > 0).mean(axis=0)
        self.assertTrue(y < 30 and x > 60, (y, x))

    def test_types(self):
        views = random_views(np.uint16)
        deep = hs.LightField(views)
        real = hs.LightField((views / np.float32(65535)).astype(np.float32))
        self.assertEqual((deep.dtype, real.dtype), (np.uint16, np.float32))
        self.assertSame(deep.array(), views)
        first, second = (self.session.render("left", one) for one in (deep, real))
        np.testing.assert_allclose(first.values, second.values, atol=1e-3)
        bytes_ = random_views()
        same = hs.LightField(bytes_.astype(np.uint16) * 257)
        self.assertSame(self.session.render("left", same).image,
                        self.session.render("left", bytes_).image)

    def test_any_strides(self):
        views = random_views(shape=(6, 8, 24, 20, 3))
        image = self.session.render("left", np.ascontiguousarray(views[::2, ::-2, ::3, 1::2, ::-1]))
        for array in (views[::2, ::-2, ::3, 1::2, ::-1],
                      np.asfortranarray(views[::2, ::-2, ::3, 1::2, ::-1])):
            self.assertFalse(array.flags.c_contiguous)
            self.assertSame(self.session.render("left", array).image, image.image)
            self.assertSame(hs.LightField(array).array(), array)
        np.save(self.path("views.npy"), views)
        mapped = np.load(self.path("views.npy"), mmap_mode="r")
        self.assertSame(hs.LightField(mapped).array(), views)
        packed = np.zeros(views.size * 2 + 1, np.uint8)[1:].view(np.uint16).reshape(views.shape)
        self.session.render("left", packed)  # not aligned
        grey = np.broadcast_to(views[..., :1], views.shape)
        self.assertSame(hs.LightField(grey).array(), grey)

    def test_memory(self):
        """300 MB of numpy are rendered from where they lie, after numpy has let go of them."""
        self.session.render("left", random_views())  # threads and tables
        before = resident_bytes()
        array = np.full((16, 16, 625, 625, 3), 90, np.uint8)
        references = sys.getrefcount(array)
        lf = hs.LightField(array)
        size = array.nbytes
        self.assertEqual(sys.getrefcount(array), references + 1)  # the light field's
        del array
        gc.collect()
        view = self.session.render("left", lf)
        self.assertEqual(view.image.max(), 90)
        self.assertLess(resident_bytes() - before, 1.1 * size)
        del lf
        gc.collect()
        self.assertLess(resident_bytes() - before, 0.1 * size)
        self.assertEqual(view.image.max(), 90)

    def test_large_is_as_small(self):
        """Slices of an array of 117 MB give the picture of the same file in memory."""
        views = np.tile(random_views(shape=(4, 4, 50, 50, 3)), (3, 3, 6, 6, 1))
        views = np.repeat(views, 3, axis=3)
        state = {"eye": [0.05, 0, 0.6], "res": [120, 90], "psf": {"sigma": 0.7, "windowSize": 3}}
        self.assertGreater(views.nbytes, 100e6)
        large = self.session.render(state, views)
        self.assertTrue(large.seen.any())
        hogels = np.ascontiguousarray(views.transpose(2, 0, 3, 1, 4)).reshape(
            views.shape[2] * views.shape[0], -1, 3)
        hs.View("", hogels, np.ones(hogels.shape[:2], bool)).save(self.path("hogels.png"))
        ny, nx, dv, du = views.shape[2], views.shape[3], views.shape[0], views.shape[1]
        whole = hs.open(self.path("hogels.png"), "hogels",
                        display={"hogels": [nx, ny], "directions": [du, dv]})
        self.assertSame(large.image, self.session.render(state, whole).image)

    def test_lifetime(self):
        view = hs.Session(small_session()).render("middle", random_views())
        values = view.values
        image = view.image.copy()
        del view
        gc.collect()
        self.assertSame(np.clip(np.floor(values.astype(float) + 0.5), 0, 255), image)
        lf = hs.LightField(random_views())
        threads = [threading.Thread(target=self.session.render, args=("left", lf)) for _ in range(4)]
        for thread in threads:
            thread.start()
        del lf  # given up by whichever thread is last
        for thread in threads:
            thread.join()

    def test_threads_share_a_file(self):
        """A picture's decoder has a state, so one thread at a time reads it."""
        views = random_views(shape=(8, 8, 60, 60, 3))
        hogels = np.ascontiguousarray(views.transpose(2, 0, 3, 1, 4)).reshape(480, 480, 3)
        hs.View("", hogels, np.ones(hogels.shape[:2], bool)).save(self.path("hogels.png"))
        lf = hs.open(self.path("hogels.png"), "hogels",
                     display={"hogels": [60, 60], "directions": [8, 8]})
        expected = self.session.render("left", views).image
        wrong = []

        def work():
            try:
                if not np.array_equal(lf.array(), views):
                    wrong.append("array")
                if not np.array_equal(hs.Session(small_session()).render("left", lf).image, expected):
                    wrong.append("picture")
            except hs.InputError as error:
                wrong.append(error)

        threads = [threading.Thread(target=work) for _ in range(6)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])

    def test_layouts(self):
        """Each layout that the program exports is opened as the same light field."""
        document = small_session(
            display={"size": [0.4, 0.4], "hogels": [12, 10], "directions": [4, 3]},
            lightField={"layout": "live", "source": "scene"})
        file = self.write("live.json", document)
        live = hs.Session(file)
        views = live.light_field().array()
        self.assertEqual(views.shape, (3, 4, 10, 12, 3))
        self.assertGreater(len(np.unique(views)), 50)
        display = {"hogels": [12, 10], "directions": [4, 3]}
        for layout, name in (("views", "v"), ("mosaic", "m.png"), ("hogels", "h.png"),
                             ("pack", "p.tif")):
            program("--export", layout, "--session", file, "--output", self.path(name))
            lf = hs.open(self.path(name), layout, display=display)
            self.assertSame(lf.array(), views)
            for state in ("middle", "left"):
                self.assertSame(live.render(state, lf).image, live.render(state).image)
                if layout == "mosaic":  # which a name does not say
                    continue
                self.assertSame(live.render(state, self.path(name)).image, live.render(state).image)
        program("--export", "quilt", "--session", file, "--set", "display.directions=[4,1]",
                "--output", self.path("q_qs4x1a1.png"))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            quilt = hs.open(self.path("q_qs4x1a1.png"))  # found by its name
            store = hs.open(self.path("p.tif"))
            found = hs.open(self.path("v"))
        self.assertEqual(quilt.shape, (1, 4, 10, 12, 3))
        self.assertEqual(store.shape, views.shape)
        self.assertEqual(found.shape, views.shape)

    def test_codecs_are_loaded_by_a_jpeg(self):
        program("--generate", "scene", "--session", TABLE1, "--set", "display.hogels=[8,6]",
                "--output", self.path("h.jpg"))
        opened = """
import os, sys
import hogelscope as hs
def has_codecs():
    with open("/proc/self/maps", encoding="utf-8") as file: return "libOpenImageIO" in file.read()
before = has_codecs()
sys.path.clear()
os.chdir("/")  # they are found from wherever the module was imported
lf = hs.open(sys.argv[1], "hogels", display={"hogels": [8, 6], "directions": [20, 20]})
print(before, has_codecs(), lf.array().shape, lf.array().std() > 20)
"""
        package = os.path.dirname(os.path.dirname(hs.__file__))
        done = subprocess.run([sys.executable, "-c", opened, os.path.abspath(self.path("h.jpg"))],
                              env={**os.environ, "PYTHONPATH": os.path.relpath(package)},
                              capture_output=True, text=True, check=False)
        self.assertEqual((done.stdout, done.stderr), ("False True (20, 20, 6, 8, 3) True\n", ""))

    def test_open_is_what_info_finds(self):
        views = random_views()
        folder = self.write_views(views)
        os.remove(os.path.join(folder, "01_02.png"))
        with self.assertWarnsRegex(UserWarning, "01_02|missing"):
            lf = hs.open(folder)
        self.assertEqual(lf.shape, views.shape)
        self.assertFalse(lf.array()[1, 2].any())
        self.assertTrue(lf.warnings)
        turned = hs.open(folder, "views", rows="bottom-up", columns="right-left")
        self.assertSame(turned.array()[2, 3], views[0, 0])

    def test_what_numpy_makes_an_array_of(self):
        views = random_views()

        class Wrapped:
            def __array__(self, dtype=None, copy=None):
                return views

        for other in (Wrapped(), list(views), tuple(views)):
            self.assertSame(hs.LightField(other).array(), views)

    def test_settings_of_a_layout_that_is_found(self):
        """Those of a mosaic, which is taken for a picture of hogels at first."""
        program("--export", "mosaic", "--session", "data/table1.json", "--output", self.path("m.png"))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = hs.open(self.path("m.png"))
            sheared = hs.open(self.path("m.png"), shear=[1, 2])
            turned = hs.open(self.path("m.png"), rows="bottom-up")
        given = {"layout": "mosaic", "display": {"directions": [20, 20]}}
        self.assertEqual(found.shape, (20, 20, 128, 128, 3))
        self.assertSame(sheared.array(), hs.open(self.path("m.png"), shear=[1, 2], **given).array())
        self.assertFalse(np.array_equal(turned.array(), found.array()))
        self.assertEqual(hs.info(self.path("m.png"), overrides=["lightField.shear=[1,2]"])["shear"], [1, 2])
        self.assertRefuses("lightField.sheer: is not known", hs.open, self.path("m.png"), sheer=[1, 2])

    def test_hostile(self):
        good = random_views()
        shape = r"array: shape: is .*\(dv, du, ny, nx, 3\)"
        for wrong in (good[0], good[..., :2], np.zeros((2, 2, 3, 4, 4), np.uint8),
                      np.zeros(5, np.uint8), np.zeros((), np.uint8)):
            self.assertRefuses(shape, hs.LightField, wrong)
        self.assertRefuses("no size may be 0", hs.LightField, good[:, :, :0])
        for dtype in (float, bool, np.int8, np.int32, ">u2", ">f4", "S1", complex, np.float16, object):
            self.assertRefuses("array: dtype: is .* allowed are uint8", hs.LightField,
                               good.astype(dtype))
        for value in (np.nan, np.inf, -np.inf):
            real = random_views(np.float32)
            real[1, 2, 3, 4, 1] = value
            self.assertRefuses(r"array: \[1, 2, 3, 4\]: ", hs.LightField, real)
        for other in (None, "views", 5, {"a": good}):
            with self.assertRaisesRegex(TypeError, "made of a numpy array, not of"):
                hs.LightField(other)
        self.assertRefuses(shape, hs.LightField, [1, 2])
        self.assertRefuses("shape: is that of no array", hs.LightField, [[1, 2], [3]])
        self.assertRefuses("dtype: is int64; allowed", hs.LightField, good.tolist())
        with self.assertRaises(TypeError):
            hs.LightField(good, layuot=3)
        with self.assertRaises(TypeError):
            self.session.render("left", 5)
        huge = np.broadcast_to(np.uint8(7), (30000, 30000, 30000, 30000, 3))
        self.assertEqual(self.session.render("left", huge).image.max(), 7)
        wide = self.session.copy()
        wide["display"]["hogels"] = [9, 9]
        self.assertRefuses("display.hogels: is 9×9, but", wide.render, "left", good)
        self.assertRefuses("there is no such file", hs.open, self.path("none"))
        self.assertRefuses("there is no such folder", hs.open, self.path("none"), "views")
        self.assertRefuses("lightField.rwos: is not known", hs.open, self.folder, "views", rwos=3)
        self.assertRefuses('"vews" is not one of', hs.open, self.folder, "vews")


if __name__ == "__main__":
    unittest.main()
