# SPDX-License-Identifier: BSD-3-Clause
"""Campaigns: the same tests on several scenes."""

from __future__ import annotations

import fnmatch
import os
from typing import Any, Dict, Iterable, List, Mapping, Optional, Union

from . import _hogelscope
from ._content import OwnMembers, Path, Progress, json_text, path_text, warn
from ._measure import Row, rows_of
from ._session import Session, report

_WORDS = ("scene", "state", "test", "problem", "figure", "over", "anchor", "group", "quality",
          "unit", "means")


class Campaign(list[Dict[str, Any]], metaclass=OwnMembers):
    """The rows of campaign.csv, with what follows from them.

    Attributes:
        summary: the rows of summary.csv, of each scene and, as the scene "all scenes", over them.
        bd: the rows of bd.csv, in the same way.
        missing: sentences on tests and groups that a scene does not have.
    """

    def __init__(
        self, rows: Iterable[Row], summary: List[Row], bd: List[Row], missing: List[str]
    ) -> None:
        super().__init__(rows)
        self.summary = summary
        self.bd = bd
        self.missing = missing


def campaign(
    document: Union[Path, Mapping[str, Any]],
    *,
    output: Path,
    images: bool = False,
    threads: int = 0,
    progress: Optional[Progress] = None,
) -> Campaign:
    """Compare the same tests on several scenes, as ``--report --campaign`` does.

    Args:
        document: the campaign's file, or a dict as in it, {"scenes": {name: session}, "tests": […]}
            with paths beside the current folder.
        output: a folder, which gets a report for each scene, OUTPUT/SCENE, and campaign.html,
            campaign.csv, summary.csv and bd.csv over the scenes.
        images: keep every picture.
        threads, progress: as in Session.render().

    Returns:
        A Campaign, which is a list with a row for each scene, state and test: "scene", "state",
        "test", and the columns of report.csv and metrics.csv, None where a cell is empty.
        pandas.DataFrame(rows).set_index(["scene", "test", "state"]).to_xarray() makes a cube.
        Raises InputError.
    """
    is_mapping = isinstance(document, Mapping)
    text = json_text(document) if is_mapping else ""  # of the file
    file = "campaign.json" if is_mapping else path_text(document)
    folder = path_text(output)
    metrics, scenes = _hogelscope.campaign_scenes(text, file, folder)
    for number, scene in enumerate(scenes):
        if not scene["tests"]:
            continue
        session = Session(scene["session"])
        if metrics:
            session["metrics"] = list(metrics)
        pattern = scene["states"] or "*"
        cameras = [state for state in session["cameras"]
                   if fnmatch.fnmatchcase(state["name"], pattern)]

        def heard(done: float, first: int = number) -> object:
            return None if progress is None else progress((first + done) / len(scenes))

        report(session, scene["tests"], output=scene["folder"], cameras=cameras,
               groups=scene["groups"], images=images, threads=threads, progress=heard)
    rows, summary, bd, missing = _hogelscope.campaign_tables(text, file, folder)
    warn(missing)
    return Campaign(rows_of(rows, _WORDS), rows_of(summary, _WORDS), rows_of(bd, _WORDS), missing)
