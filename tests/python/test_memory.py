# SPDX-License-Identifier: BSD-3-Clause
"""Memory of views: values that are made late, pictures in arrays of the user, many views."""

import copy
import gc
import os
import pickle
import threading
import unittest

import numpy as np
from support import TABLE1, FolderTest, program, random_views, small_session

import hogelscope as hs


def rounded(values):
    return np.clip(np.floor(values.astype(float) + 0.5), 0, 255)


class LateValues(FolderTest):
    def session(self, name="views", views=None):
        folder = self.write_views(random_views() if views is None else views, name)
        return hs.Session(small_session(lightField={"file": folder, "layout": "views"}))

    def assert_values(self, view):
        self.assertEqual((view.values.dtype, view.values.shape), (np.float32, view.image.shape))
        self.assertSame(rounded(view.values), view.image)
        self.assertIs(view.values, view.values)
        self.assertGreater(np.abs(view.values - view.image).max(), 0.01)  # really unrounded

    def test_are_those_of_the_picture(self):
        """Also after the session has changed or is gone, and its light field was closed."""
        s = self.session()
        own = s.render()
        of_array = s.render(None, random_views(np.uint16))
        of_file = s.render(None, s["lightField"]["file"])
        of_light = s.render(None, hs.open(s["lightField"]["file"], "views"))
        s["lightField"]["file"] = self.session("others", 255 - random_views())["lightField"]["file"]
        s["display"]["size"] = [0.3, 0.3]
        s.render()
        del s
        gc.collect()
        for view in [*own, *of_array, *of_file, *of_light]:
            if view.state == "left":  # the other copies texels, which have no fractions
                self.assert_values(view)
            self.assertSame(rounded(view.values), view.image)

    def test_need_their_files(self):
        """What a view was made of is not replaced by another picture without a word."""
        s = self.session()
        known, late = s.render(["left", "left"])
        self.assertIsNotNone(known.values)
        white = np.full((12, 10, 3), 255, np.uint8)
        hs.View("", white, white[..., 0] > 0).save(os.path.join(s["lightField"]["file"], "00_00.png"))
        self.assertIsNotNone(known.values)
        message = self.assertRefuses("has changed since \"left\" was rendered", lambda: late.values)
        self.assertIn("views", message)
        self.assertRefuses("has changed since", late.save, self.path("a.exr"))
        late.save(self.path("a.png"))  # needs none

    def test_arrays_that_change(self):
        """A small array is copied; a large one is not, so its values are made at once."""
        base = random_views(shape=(1, 1, 1, 600, 3))
        for shape in ((2, 2, 30, 600, 3), (20, 20, 300, 600, 3)):
            light = np.broadcast_to(base, shape)
            session = hs.Session(small_session())
            view = session.render("left", light)
            same = session.render("left", light).values
            base.setflags(write=True)
            before = base.copy()
            base[:] = 255 - base
            self.assertSame(view.values, same)
            self.assertSame(rounded(view.values), view.image)
            base[:] = before

    def test_are_kept_by_copies(self):
        for make in (copy.copy, copy.deepcopy, lambda view: pickle.loads(pickle.dumps(view))):
            view = self.session(f"views of {make}").render("left")
            other = make(view)
            self.assert_values(other)
            self.assertSame(other.image, view.image)
            self.assertSame(other.seen, view.seen)
            self.assertEqual((other.state, other.distance), (view.state, view.distance))

    def test_metrics_that_need_them(self):
        """FLIP reads values; what is compared is what hs.report() compares."""
        s = self.session()
        test = self.write_views(random_views() // 2, "test")
        s["cameras"] = [{**s["cameras"][1], "fov": 20, "res": [200, 200]}]
        figures = hs.compare(s.render(0), s.render(0, test), metrics=["flip", "ms-ssim"])
        s["metrics"] = ["flip", "ms-ssim"]
        row = hs.report(s, [test], output=self.path("o"))[0]
        for name in ("flip", "ms_ssim"):
            self.assertEqual(figures[name], row[name])

    def test_many_threads(self):
        """Of one session, in any order."""
        s = self.session()
        views = [s.render(k % 2) for k in range(12)]
        threads = [threading.Thread(target=lambda view=view: view.values) for view in views]
        for thread in threads:
            thread.start()
        s.render()
        for thread in threads:
            thread.join()
        for view in views:
            self.assertSame(rounded(view.values), view.image)


class Pictures(FolderTest):
    def test_stay_valid(self):
        """Memory is used again only when nobody has the array any more."""
        s = hs.Session(small_session())
        views = random_views()
        kept = [s.render("left", views // k) for k in range(1, 9)]
        copies = [(view.image.copy(), view.seen.copy()) for view in kept]
        part = s.render("middle", views).image[10:20, 5:50]  # outlives its View
        part_copy = part.copy()
        for k in range(60):
            s.render(None, views // (1 + k % 5))
        for view, (image, seen) in zip(kept, copies):
            self.assertSame(view.image, image)
            self.assertSame(view.seen, seen)
        self.assertSame(part, part_copy)
        part[:] = 0  # may be written

    def test_hold_nothing_of_earlier_ones(self):
        """Every pixel is written, whatever the memory had, in every kind of view."""
        sessions = [f"tests/scenes/{name}.json" for name in (
            "direct_mapping", "eyes", "interpolated", "lenses", "live_room", "live_scene", "table1",
            "turned_panel", "twin")]
        behind = {"name": "behind", "eye": [0, 0, -0.5], "lookat": [0, 0, -1], "res": [90, 60]}
        for source in [*sessions, {**hs.Session(TABLE1), "cameras": [behind]}]:
            folder = "tests/data" if isinstance(source, dict) else ""
            s = hs.Session(source, folder=folder)
            for tolerance in (0,) if "interpolated" in str(source) else (0, 3):
                s["sampling"] = {**s.get("sampling", {}), "tolerance": tolerance}
                for state in s["cameras"][-1:]:
                    width, height = s.render(state).image.shape[1::-1]
                    white, black = (np.full((height, width, 3), k, np.uint8) for k in (255, 0))
                    self.assertIs(s.render(state, out=white).image, white)
                    self.assertSame(s.render(state, out=black).image, white)
                    first = s.render(state)
                    first.seen[:] = True
                    del first
                    self.assertSame(s.render(state).seen, s.render(state, out=black).seen)

    def test_in_arrays_of_the_user(self):
        s = hs.Session(small_session(cameras=[
            {"name": "a", "eye": [0, 0, 0.6], "res": [40, 30]},
            {"name": "b", "eye": [0.1, 0, 0.6], "res": [40, 30], "pupil": {"diameter": 0.004}}]))
        light = hs.LightField(random_views())
        plain = s.render(None, light)
        many = np.zeros((2, 30, 40, 3), np.uint8)
        for view, own in zip(s.render(None, light, out=many), plain):
            self.assertTrue(np.shares_memory(view.image, many))
            self.assertSame(view.image, own.image)
            self.assertSame(view.values, own.values)
        stack = [np.zeros((30, 40, 3), np.uint8) for _ in range(3)]
        for view, own in zip(s.render("b", light, focus_stack=3, out=stack),
                             s.render("b", light, focus_stack=3)):
            self.assertSame(view.image, own.image)
        one = stack[0]
        for k in range(2):  # the same array again
            self.assertSame(s.render(k, light, out=one).image, plain[k].image)
        fixed = one.copy()
        fixed.setflags(write=False)
        before = one.copy()
        for wrong, line in ((one.astype(float), "out: is .*float64"), (one[:15], "out: is .15, 40"),
                            (np.zeros((40, 30, 3), np.uint8), "\"a\" is .30, 40, 3"),
                            (fixed, "may not be written"), (many[0][:, ::2], "in C order"), (one[0], "in C order")):
            self.assertRefuses(line, s.render, "a", light, out=wrong)
        for wrong in (5, [], "ab", one.tolist()):
            with self.assertRaisesRegex(TypeError, "^out: .* is no numpy array$"):
                s.render("a", light, out=wrong)
        self.assertRefuses("has 1 arrays for 2 pictures", s.render, None, light, out=[one])
        self.assertRefuses("one array for several", s.render, None, light, out=[one, one])
        self.assertSame(one, before)

    def test_many(self):
        """render_all() gives what render() gives, in order, for each kind of light field."""
        states = [{"eye": [k / 200, 0, 0.5], "res": [60, 40 + k % 3]} for k in range(37)]
        states[20]["res"] = [1300, 1000]  # on all cores
        s = hs.Session({**hs.Session("data/table1.json"), "cameras": states}, folder="data")
        whole = s.render()
        self.assertEqual(len(whole), 37)

        def assert_whole(views, count=37):
            views = list(views)
            self.assertEqual(len(views), count)
            for view, same in zip(views, whole):
                self.assertEqual(view.state, same.state)
                self.assertSame(view.image, same.image)
                self.assertSame(view.seen, same.seen)

        assert_whole(s.render_all())
        assert_whole(s.render_all(threads=1))
        assert_whole(s.render_all(range(5)), 5)
        assert_whole(s.render_all([f"view {k + 1}" for k in range(9)]), 9)
        assert_whole(s.render_all(None, s.light_field()))
        program("--export", "views", "--session", "data/table1.json", "--output", self.path("views"))
        assert_whole(s.render_all(None, self.path("views")))
        self.assertSame(next(s.render_all()).values, whole[0].values)
        self.assertEqual(list(s.render_all([])), [])
        running = s.render_all()
        next(running)
        s["cameras"] = []  # does not count
        self.assertEqual(len(list(running)), 36)
        self.addCleanup(hs.allow_memory, 4e9)
        hs.allow_memory(20e6)  # the picture is read once, for all
        s["cameras"] = states
        assert_whole(s.render_all())
        self.assertRefuses("neither \"left\" nor", list, s.render_all(eye="third"))
        self.assertRefuses("is none of the", list, s.render_all(["nobody"]))


if __name__ == "__main__":
    unittest.main()
