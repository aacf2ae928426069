# SPDX-License-Identifier: BSD-3-Clause
"""The notebooks are their scripts, and the scripts run."""

import contextlib
import importlib.util
import io
import json
import os
import re
import runpy
import sys
import unittest

sys.path.insert(0, "packaging")
import notebooks  # noqa: E402


def has(*modules):
    return all(importlib.util.find_spec(name) for name in modules)


class Notebooks(unittest.TestCase):
    def test_have_the_code_of_their_scripts(self):
        for name in ("notebook", "notebook_pyvista"):
            with open(f"docs/{name}.py", encoding="utf-8") as file:
                cells = notebooks.cells_of(file.read())
            with open(f"docs/{name}.ipynb", encoding="utf-8") as file:
                notebook = json.load(file)
            self.assertEqual(
                [(cell["cell_type"], "".join(cell["source"])) for cell in notebook["cells"]], cells,
                f"run packaging/notebooks.py {name}")
            self.assertGreater(len(cells), 6)
            self.assertLess(os.path.getsize(f"docs/{name}.ipynb"), 300000)

    def test_outputs_are_of_this_code(self):
        with open("docs/notebook.ipynb", encoding="utf-8") as file:
            cells = json.load(file)["cells"]
        outputs = [output for cell in cells if cell["cell_type"] == "code"
                   for output in cell["outputs"]]
        self.assertFalse([one for one in outputs if one["output_type"] == "error"])
        self.assertTrue([one for one in outputs if "image/png" in one.get("data", {})])

    @unittest.skipUnless(has("PIL", "matplotlib"), "no python3-matplotlib")
    def test_codecs(self):
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            names = runpy.run_path("docs/notebook.py")
        found = re.findall(r"(views|perceived): WebP needs ([-+.0-9]+) %", said.getvalue())
        self.assertEqual([how for how, _ in found], ["views", "perceived"])
        for how, percent in found:
            self.assertTrue(-70 < float(percent) < -5, (how, percent))  # WebP is the later codec
        self.assertEqual(len(names["reference"]), 20)
        for view in names["reference"]:
            self.assertGreater(view.seen.mean(), 0.3)
        for points in names["curves"].values():
            self.assertEqual(points, sorted(points))  # quality rises with the rate
            self.assertTrue(all(15 < quality < 60 for _, quality in points))

    @unittest.skipUnless(has("pyvista"), "no PyVista")
    def test_pyvista(self):
        runpy.run_path("docs/notebook_pyvista.py")

    def test_pyvista_compiles(self):
        with open("docs/notebook_pyvista.py", encoding="utf-8") as file:
            compile(file.read(), "docs/notebook_pyvista.py", "exec")


if __name__ == "__main__":
    unittest.main()
