# SPDX-License-Identifier: BSD-3-Clause
"""Content that makes up for a display's leakage."""

from __future__ import annotations

from typing import Any, List, Mapping, Optional, Sequence

from . import _hogelscope
from ._content import Path, Progress, path_text, warn
from ._measure import Row, rows_of
from ._session import Session


def optimise(
    session: Session,
    output: Path,
    *,
    layout: str = "hogels",
    cameras: Optional[Sequence[Mapping[str, Any]]] = None,
    threads: int = 0,
    progress: Optional[Progress] = None,
) -> List[Row]:
    """Write the content that makes up for a display's leakage, as ``--optimise`` does.

    Args:
        session: its "optimise" has the target ("light", "ideal" or "views") and the solver's limits;
            the "psf" of its states says how much the display leaks.
        output: the file, for "views" the folder. FILE.csv and FILE.html are written beside it.
        layout: "hogels", "views", "quilt" or "pack".
        cameras: states instead of the session's own.
        threads, progress: as in Session.render().

    Returns:
        The rows of FILE.csv: "view", "held_out" (1 or 0), "reference" ("display", "ideal" or
        "views"), and PSNR (dB) and SSIM of the views before, prefiltered and after; the rows of view
        "mean" also "iterations", "open_db", "black" and "white". None where there is no value. What
        the result may suffer from is a Python warning. hs.open(output) reads the content. Raises
        InputError.
    """
    states = None if cameras is None else [dict(state) for state in cameras]
    table, warnings = _hogelscope.optimise(
        session._document(states), layout, path_text(output), threads, progress
    )
    warn(warnings)
    return rows_of(table, ["view", "reference"])
