# SPDX-License-Identifier: BSD-3-Clause
"""A session as a page with the engine in it, for a browser or a notebook."""

from __future__ import annotations

import html
import os
from typing import Any, List, Mapping, Optional, Sequence

from . import _hogelscope
from ._content import Path, Progress, path_text
from ._hogelscope import InputError
from ._session import Session

_LARGEST_CELL = 1_000_000  # bytes of a page that stands in the notebook itself


class Page:
    """A page that page() has made: ``html``, ``notes`` and ``file``, "" if it was not written.

    A notebook shows it live; a page above 1 MB has to be in a file beside the notebook.
    """

    def __init__(self, text: str, notes: List[str], file: str) -> None:
        self.html = text
        self.notes = notes
        self.file = file

    def __repr__(self) -> str:
        return f"<hogelscope.Page of {len(self.html) / 1e6:.2f} MB, {self.file or 'not written'}>"

    def _repr_html_(self) -> str:
        style = 'style="width: 100%; height: 760px; border: 0"'
        if len(self.html) <= _LARGEST_CELL:
            return f'<iframe {style} srcdoc="{html.escape(self.html)}"></iframe>'
        if not self.file:
            return ("<p>This page has more than 1 MB: give page() a file beside the notebook, which "
                    "is then shown here.</p>")
        return f'<iframe {style} src="{html.escape(os.path.relpath(self.file))}"></iframe>'


def page(
    session: Session,
    output: Path = "",
    *,
    quality: Optional[str] = None,
    title: str = "",
    cameras: Optional[Sequence[Mapping[str, Any]]] = None,
    threads: int = 0,
    progress: Optional[Progress] = None,
) -> Page:
    """Make one HTML file in which anyone moves around the display, as ``--export page`` does.

    Args:
        session: its whole light field is in the page.
        output: the file to write; without it the page is only returned.
        quality: "exact" or "small"; exact up to 8 MB if not given.
        title: the heading; the session's name if not given.
        cameras: states instead of the session's own.
        threads, progress: as in Session.render().

    Returns:
        The Page, which a notebook shows. Raises InputError.
    """
    if quality not in (None, "exact", "small"):
        raise InputError(f"quality: {quality!r} is neither 'exact' nor 'small'")
    states = None if cameras is None else [dict(state) for state in cameras]
    name = os.path.splitext(os.path.basename(session.name))[0] or "hogelscope"
    file = path_text(output)
    text, notes = _hogelscope.page(session._document(states), title or name, file,
                                   None if quality is None else quality == "exact", threads, progress)
    return Page(text, notes, file)
