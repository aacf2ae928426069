# SPDX-License-Identifier: BSD-3-Clause
"""Pupils, focus stacks and two eyes: numpy against the program's own pictures."""

import unittest

import numpy as np
from support import FolderTest, random_views, small_session

import hogelscope as hs


def linear(image):
    s = np.asarray(image, float) / 255
    return np.where(s <= 0.04045, s / 12.92, ((s + 0.055) / 1.055) ** 2.4)


def encoded(light):
    return 255 * np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)


class Eyes(FolderTest):
    def setUp(self):
        super().setUp()
        self.session = hs.Session(small_session())
        self.light = random_views(shape=(5, 6, 30, 40, 3))

    def test_pupil_is_the_sum_of_shifted_pinholes(self):
        state = {"eye": [0, 0, 0.6], "res": [60, 40], "intrinsics": {"fx": 60, "cx": 29.5, "cy": 19.5}}
        samples, diameter, focus = 7, 0.03, 0.5
        view = self.session.render(
            {**state, "pupil": {"diameter": diameter, "focus": focus, "samples": samples}}, self.light
        )
        total, seen = 0, True
        for k in range(samples):
            r = diameter / 2 * np.sqrt((k + 0.5) / samples)
            x, y = r * np.cos(2.39996 * k), r * np.sin(2.39996 * k)  # right and down
            shifted = {
                **state,
                "eye": [x, -y, 0.6],
                "lookat": [x, -y, 0],
                "intrinsics": {"fx": 60, "cx": 29.5 + 60 * x / focus, "cy": 19.5 + 60 * y / focus},
            }
            pinhole = self.session.render(shifted, self.light)
            total = total + linear(pinhole.values) / samples
            seen = seen & pinhole.seen
        self.assertLess(np.abs(encoded(total) - view.values).max(), 0.01)
        np.testing.assert_array_equal(seen, view.seen)

    def test_eyes(self):
        state = {"eye": [0, 0, 0.6], "res": [60, 40], "stereo": {"ipd": 0.06}, "fov": 50}
        focal = 20 / np.tan(np.radians(25))
        for eye, side in (("left", -1), ("right", 1)):
            view = self.session.render(state, self.light, eye=eye)
            self.assertEqual(view.state, "view 1/" + eye)
            own = {
                "eye": [side * 0.03, 0, 0.6],
                "lookat": [side * 0.03, 0, 0],
                "res": [60, 40],
                "intrinsics": {"fx": focal, "cx": 29.5 + side * focal * 0.06 / 1.2, "cy": 19.5},
            }
            same = self.session.render(own, self.light).image == view.image
            self.assertGreater(same.mean(), 0.995)
        head = self.session.render(state, self.light)
        np.testing.assert_array_equal(
            head.image, self.session.render({**state, "stereo": {"ipd": 0}}, self.light).image
        )

    def test_focus_stack(self):
        state = {"eye": [0, 0, 0.6], "res": [60, 40], "pupil": {"diameter": 0.02}}
        stack = self.session.render(state, self.light, focus_stack=3)
        self.assertEqual([view.state for view in stack], [f"view 1.focus0{k}" for k in (1, 2, 3)])
        dioptres = [1 / view.focus for view in stack]
        self.assertAlmostEqual(dioptres[0] + dioptres[2], 2 * dioptres[1])
        self.assertGreater(dioptres[0], 1 / 0.6)
        for view in stack:
            focused = {**state, "pupil": {"diameter": 0.02, "focus": view.focus}}
            np.testing.assert_array_equal(
                view.image, self.session.render(focused, self.light).image
            )
        self.assertIsNone(self.session.render(state, self.light).focus)
        self.assertEqual(len(self.session.render([state, state], self.light, focus_stack=2)), 4)

    def test_reports_have_both_eyes(self):
        state = {"name": "a", "eye": [0, 0, 0.6], "res": [60, 40], "stereo": {"ipd": 0.06}}
        session = hs.Session({**small_session(), "cameras": [state]})
        rows = hs.report(
            session,
            {"same": self.light, "dark": self.light // 2},
            light_field=self.light,
            output=self.path("out"),
        )
        self.assertEqual([row["state"] for row in rows], ["a/left", "a/left", "a/right", "a/right"])
        self.assertEqual({row["weight"] for row in rows}, {0.5})
        self.assertEqual([row["problem"] for row in rows], [""] * 4)

    def test_refusals(self):
        state = {"eye": [0, 0, 0.6], "res": [6, 4]}
        for wrong in (
            {"eye": "left"},
            {"eye": "middle"},
            {"focus_stack": 2},
            {"focus_stack": 1},
            {"focus_stack": 2.5},
        ):
            with self.assertRaises(hs.InputError):
                self.session.render(state, self.light, **wrong)
        for wrong in ({"pupil": {"diameter": -1}}, {"stereo": {"ipd": -1}}, {"pupil": {"width": 1}}):
            with self.assertRaises(hs.InputError):
                self.session.render({**state, **wrong}, self.light)


if __name__ == "__main__":
    unittest.main()
