# SPDX-License-Identifier: BSD-3-Clause
"""Hogelscope: what a viewer, or a camera with a real lens, sees in front of a light field display.

    import hogelscope as hs

    s = hs.Session("table1.json")               # display, light field, cameras: a dict, as in JSON
    s["display"]["fov"] = [50, 50]              # checked when it is used
    view = s.render("Fig 4")                    # .image (h, w, 3) uint8, .seen (h, w) bool, .values

    lf = hs.LightField(views)                   # numpy (dv, du, ny, nx, 3): uint8, uint16, float32
    q40 = hs.open("decoded/q40")                # or files of any layout, larger than memory too
    coded = s.render("Fig 4", q40)
    hs.compare(view, coded)["psnr_seen"]        # dB

    cams = hs.cameras(s, "random", count=200, seed=3)
    rows = hs.report(s, {"q40": q40}, cameras=cams, output="out")    # for pandas.DataFrame(rows)

The line that everything follows is LightField → Display → Camera → Distortion → PSF → Image →
Metrics → Report. Lengths are metres, angles degrees. The display stands at its position, +x right,
+y up, +z to the viewer. Pictures are (height, width, 3) with row 0 at the top; light fields are
(dv, du, ny, nx, 3), views in rows from the top and columns from the left.

What is wrong with an input is an InputError (a ValueError) with one line of text that says where,
and what to change. Long work lets other threads run, calls progress=… with a fraction, and stops
at Ctrl-C with nothing half-written. Each function's help() has its shapes and units.
"""

import glob as _glob
import os as _os

from . import _hogelscope
from ._campaign import Campaign, campaign
from ._content import info, open
from ._figures import bd_rate, compare
from ._hogelscope import InputError, LightField, add_plugin_folder, allow_memory
from ._measure import depth, measure, sweep
from ._optimise import optimise
from ._page import Page, page
from ._session import Report, Session, cameras, report
from ._view import View

__version__: str = _hogelscope.version
__all__ = [
    "Campaign",
    "InputError",
    "LightField",
    "Page",
    "Report",
    "Session",
    "View",
    "add_plugin_folder",
    "allow_memory",
    "bd_rate",
    "cameras",
    "campaign",
    "compare",
    "depth",
    "info",
    "measure",
    "open",
    "optimise",
    "page",
    "report",
    "sweep",
]


def _add_own_plugins() -> None:
    """The program finds its plugins beside itself; here the program is Python."""
    name = f"plugins-{_hogelscope.plugin_abi}"
    prefix = _os.path.abspath(__file__)
    own = _os.path.join(_os.path.dirname(prefix), "lib", "hogelscope", name)  # as pip installs it
    for _ in "PREFIX/lib/python3/dist-packages/hogelscope/__init__.py".split("/")[1:]:
        prefix = _os.path.dirname(prefix)
    found = [own, _os.path.join(prefix, name)]  # of a build
    for libraries in ("lib", "lib/*"):
        found += _glob.glob(_os.path.join(_glob.escape(prefix), libraries, "hogelscope", name))
    for folder in found:
        if _os.path.isdir(folder):
            add_plugin_folder(folder)


_add_own_plugins()
