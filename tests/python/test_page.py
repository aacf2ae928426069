# SPDX-License-Identifier: BSD-3-Clause
"""page() writes what --export page does, and a notebook's cell holds it."""
import html
import os
import re
import unittest

import hogelscope as hs
import numpy as np
from support import FolderTest, program


class Pages(FolderTest):
    def setUp(self):
        super().setUp()
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)

    def session(self):
        from PIL import Image
        values = np.random.default_rng(2).integers(0, 256, (6 * 5, 8 * 4, 3), dtype=np.uint8)
        Image.fromarray(values).save("a.png")
        return hs.Session({
            "display": {"size": [0.2, 0.15], "hogels": [8, 6], "directions": [4, 5], "fov": [40, 40]},
            "lightField": {"file": "a.png"},
            "cameras": [{"name": "א <b>", "eye": [0, 0, 0.4], "res": [40, 30]}],
        })

    def made(self, call):
        try:
            return call()
        except hs.InputError as error:
            if "built without the engine" in str(error):
                self.skipTest("there is no engine for pages")
            raise

    def test_program_writes_the_same(self):
        session = self.session()
        session.save("s.json")
        page = self.made(lambda: hs.page(hs.Session("s.json"), "out/page.html"))
        program("--export", "page", "--session", "s.json", "--output", "b.html")
        with open("b.html", encoding="utf-8") as file:
            self.assertEqual(file.read(), page.html)
        with open(page.file, encoding="utf-8") as file:
            self.assertEqual(file.read(), page.html)
        self.assertIn("exact", page.notes[0])
        self.assertNotIn(os.getcwd(), page.html)

    def test_cells(self):
        page = self.made(lambda: hs.page(self.session(), quality="small", title="x & y"))
        self.assertIn("<title>x &amp; y</title>", page.html)
        self.assertIn("compressed", page.notes[0])
        cell = page._repr_html_()
        self.assertEqual(html.unescape(re.search(r'srcdoc="([^"]*)"', cell)[1]), page.html)
        large = hs.Page("x" * 2_000_000, [], "out/p.html")
        self.assertIn('src="out/p.html"', large._repr_html_())
        self.assertIn("give page() a file", hs.Page("x" * 2_000_000, [], "")._repr_html_())

    def test_refusals(self):
        with self.assertRaisesRegex(hs.InputError, "neither"):
            hs.page(self.session(), quality="best")
        self.made(lambda: hs.page(self.session()))
        with self.assertRaisesRegex(hs.InputError, "a.png"):
            hs.page(self.session(), "a.png")


if __name__ == "__main__":
    unittest.main()
