# SPDX-License-Identifier: BSD-3-Clause
"""What a display can show, and whether content fits it."""

from __future__ import annotations

import csv
import io
import json
from typing import Any, Dict, List, Mapping, Optional, Sequence

from . import _hogelscope
from ._content import Path, Progress, json_text, path_text
from ._session import Session

Row = Dict[str, Any]  # texts, numbers, None


def rows_of(text: str, words: Sequence[str]) -> List[Row]:
    """The rows of a table; columns but those of `words` are numbers, None where a cell is empty."""
    return [
        {name: cell if name in words else float(cell) if cell else None
         for name, cell in row.items()}
        for row in csv.DictReader(io.StringIO(text))
    ]


def depth(
    session: Session,
    *,
    cameras: Optional[Sequence[Mapping[str, Any]]] = None,
    threads: int = 0,
    progress: Optional[Progress] = None,
) -> Dict[str, Any]:
    """Say whether a session's content fits its display in depth, as ``--depth`` does.

    Args:
        session: its "depth" has the share, the comfort (degrees), and the ipd and pupil (m) of
            states without their own.
        cameras: states instead of the session's own; the first one's limits are those that the
            proposal keeps.
        threads, progress: as in Session.render().

    Returns:
        The document depth.json: "limits" and "comfort" ({"front", "behind"} in metres, None for no
        limit), "inside" ({"display", "both"}, shares of the pixels whose depth is known),
        "interval" (m), "proposal", and more for each of "states". Besides "rows", those of
        depth.csv, and "fitted", the proposed Session or None. Raises InputError.
    """
    states = None if cameras is None else [dict(state) for state in cameras]
    text, table, fitted = _hogelscope.depth(session._document(states), threads, progress)
    figures: Dict[str, Any] = json.loads(text)
    figures["rows"] = rows_of(table, ["state"])
    figures["fitted"] = Session(fitted) if fitted else None
    return figures


def measure(
    session: Session,
    *,
    output: Path = "",
    cameras: Optional[Sequence[Mapping[str, Any]]] = None,
    threads: int = 0,
    progress: Optional[Progress] = None,
) -> List[Row]:
    """Measure what a session's display can show to the eye of its first state, as ``--measure`` does.

    Args:
        session: its light field is not read if "display" has hogels and directions.
        output: a folder for measure.csv, measure.html and plots; nothing is written without it.
        cameras: states instead of the session's own; the first one's eye, PSF and pupil count.
        threads, progress: as in Session.render().

    Returns:
        The rows of measure.csv: "figure", "value", "unit", "where", "closed_form", "difference"; None
        where there is no value. Raises InputError.
    """
    states = None if cameras is None else [dict(state) for state in cameras]
    table = _hogelscope.measure(session._document(states), path_text(output), threads, progress)
    return rows_of(table, ["figure", "unit", "where"])


def sweep(
    session: Session,
    table: Mapping[str, Any],
    *,
    output: Path = "",
    cameras: Optional[Sequence[Mapping[str, Any]]] = None,
    threads: int = 0,
    progress: Optional[Progress] = None,
) -> List[Row]:
    """Measure figures of many designs, as ``--sweep`` does.

    Args:
        session: what the designs vary.
        table: {"parameters": {"psf.sigma": [0.5, 1], …}, "sampling": "grid", "figures": […],
            "pareto": {…}}, as the table of the command line.
        output: a folder for sweep.csv, sweep.html and plots; nothing is written without it.
        cameras: states instead of the session's own.
        threads, progress: as in Session.render().

    Returns:
        The rows of sweep.csv: "design", the parameters (numbers, lists of them, or words), the
        figures (None where they cannot be measured), "pareto" (1 or 0), "problem". Raises
        InputError.
    """
    states = None if cameras is None else [dict(state) for state in cameras]
    text = json_text(table)
    made = _hogelscope.sweep(
        session._document(states), text, path_text(output), threads, progress
    )
    parameters = list(table.get("parameters", {}))
    rows = rows_of(made, ["problem", *parameters])
    return [{**row, **{name: json.loads(row[name]) for name in parameters}} for row in rows]
