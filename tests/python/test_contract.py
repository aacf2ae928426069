# SPDX-License-Identifier: BSD-3-Clause
"""The ten lines by which the package is known, each as it is written there."""

import doctest
import math
import os
import pydoc
import sys
import unittest

import numpy as np
from support import TABLE1, FolderTest

import hogelscope as hs


class Contract(FolderTest):
    def test_ten_lines(self):
        s = hs.Session(TABLE1)
        with self.assertRaises(hs.InputError):
            hs.Session({"display": {"fov": [50]}}).check()
        s["display"]["fov"] = [50, 50]
        views = s.light_field().array()
        lf = hs.LightField(views)
        q40 = hs.open(self.write_views(views[::, ::, ::, ::] // 32 * 32), layout="views")
        v = s.render("Fig 4", light_field=lf)
        self.assertEqual((v.image.shape, v.image.dtype), ((600, 600, 3), np.uint8))
        self.assertEqual((v.seen.shape, v.seen.dtype), ((600, 600), bool))
        self.assertEqual((v.values.shape, v.values.dtype), ((600, 600, 3), np.float32))
        figures = hs.compare(v.image, s.render("Fig 4", q40).image)
        self.assertLessEqual({"mse", "psnr", "psnr_yuv", "ssim"}, set(figures))
        self.assertTrue(20 < figures["psnr"] < 40)
        cams = hs.cameras(s, "random", count=20, seed=3)
        self.assertEqual(len(cams), 20)
        for state in cams:
            state["res"] = [60, 60]
        told = []
        rows = hs.report(s, {"q40": q40, "lf": lf}, cameras=cams, output=self.path("out"),
                         threads=8, progress=told.append)
        self.assertEqual(told, sorted(told))
        self.assertEqual(told[-1], 1)
        self.assertEqual([row["test"] for row in rows[:2]], ["q40", "lf"])
        self.assertEqual(len(rows), 40)
        self.assertTrue(all(math.isinf(row["psnr"]) for row in rows[1::2]))
        try:
            import pandas as pd
        except ImportError:
            return
        df = pd.DataFrame(rows)
        table = pd.read_csv(self.path("out", "report.csv"))
        self.assertLessEqual(set(table.columns), set(df.columns))
        np.testing.assert_allclose(table["mse"], df["mse"])

    def test_vtk(self):
        try:
            from vtkmodules.util.numpy_support import vtk_to_numpy
        except ImportError:
            self.skipTest("no python3-vtk9")
        v = hs.Session(TABLE1).render("Fig 2")
        img = v.to_vtk()
        self.assertEqual(img.GetClassName(), "vtkImageData")
        self.assertEqual(img.GetDimensions(), (600, 600, 1))
        scalars = img.GetPointData().GetScalars()
        self.assertEqual(scalars.GetName(), "image")
        rows = vtk_to_numpy(scalars).reshape(600, 600, 3)
        self.assertSame(rows[::-1], v.image)  # VTK's rows begin at the bottom
        bottom_left = [img.GetScalarComponentAsDouble(0, 0, 0, c) for c in range(3)]
        self.assertEqual(bottom_left, list(v.image[599, 0]))
        seen = vtk_to_numpy(img.GetPointData().GetArray("seen")).reshape(600, 600)
        self.assertSame(seen[::-1].astype(bool), v.seen)

    def test_help_teaches(self):
        for name in hs.__all__:
            self.assertGreater(len(getattr(hs, name).__doc__), 60, name)
        for words in ("metres", "(dv, du, ny, nx, 3)", "InputError", "Ctrl-C"):
            self.assertIn(words, hs.__doc__)
        for name in ("Session", "Report"):  # without what every dict and list has
            shown = pydoc.render_doc(getattr(hs, name))
            self.assertNotIn("inherited from", shown)
            self.assertNotIn("setdefault", shown)
        self.assertIn("focus_stack", pydoc.render_doc(hs.Session))
        self.assertEqual(hs.InputError.__module__, "hogelscope")
        self.assertTrue(issubclass(hs.InputError, ValueError))
        self.assertTrue(os.path.exists(os.path.join(os.path.dirname(hs.__file__), "py.typed")))

    def test_manual(self):
        """What the manual's chapter shows is what Python says."""
        found = doctest.testfile(os.path.abspath("resources/manual/14-python.md"),
                                 module_relative=False, optionflags=doctest.ELLIPSIS)
        self.assertGreater(found.attempted, 10)
        self.assertEqual(found.failed, 0)


if __name__ == "__main__":
    sys.exit(unittest.main())
