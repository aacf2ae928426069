#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes docs/NAME.ipynb of docs/NAME.py, run with its outputs: packaging/notebooks.py [NAME ...].

Needs Debian's python3-nbconvert, python3-ipykernel, python3-matplotlib and a built package:
    PYTHONPATH=build/release/lib/python3/dist-packages /usr/bin/python3 packaging/notebooks.py notebook
A notebook whose modules are missing is written without outputs.
"""

import json
import os
import sys


def cells_of(text):
    """[(kind, source)] of a script with "# %%" before code and "# %% [markdown]" before words."""
    cells = []
    for line in text.splitlines():
        if line.startswith("# %%"):
            cells.append(("markdown" if "[markdown]" in line else "code", []))
        elif cells:
            cells[-1][1].append(line)
    return [
        (kind, "\n".join(line[2:] if kind == "markdown" else line for line in lines).strip())
        for kind, lines in cells
    ]


def notebook_of(cells):
    """A notebook without outputs."""
    written = []
    for k, (kind, source) in enumerate(cells):
        cell = {"cell_type": kind, "id": f"cell-{k + 1}", "metadata": {},
                "source": source.splitlines(keepends=True)}
        if kind == "code":
            cell.update(execution_count=None, outputs=[])
        written.append(cell)
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return {"cells": written, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}


def run(notebook):
    """The same with its outputs."""
    import nbformat
    from nbconvert.preprocessors import ExecutePreprocessor

    node = nbformat.from_dict(notebook)
    for cell in node.cells:
        cell.source = "".join(cell.source)
    ExecutePreprocessor(timeout=600).preprocess(node, {"metadata": {"path": "docs"}})
    for cell in node.cells:
        cell.metadata.pop("execution", None)  # the times
    node.metadata.pop("language_info", None)
    return json.loads(nbformat.writes(node))


def main(names):
    for name in names or ("notebook", "notebook_pyvista"):
        with open(f"docs/{name}.py", encoding="utf-8") as file:
            notebook = notebook_of(cells_of(file.read()))
        try:
            if name == "notebook_pyvista":
                import pyvista  # noqa: F401
            notebook = run(notebook)
        except ImportError as error:
            print(f"{name}: without outputs: {error}")
        with open(f"docs/{name}.ipynb", "w", encoding="utf-8") as file:
            json.dump(notebook, file, indent=1, ensure_ascii=False)
            file.write("\n")


if __name__ == "__main__":
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    main(sys.argv[1:])
