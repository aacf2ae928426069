# SPDX-License-Identifier: BSD-3-Clause
"""Light fields: opening files, and what may stand for one in a call."""

from __future__ import annotations

import json
import os
import warnings
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Set, Tuple, Union

import numpy as np

from . import _hogelscope
from ._hogelscope import InputError, LightField

Path = Union[str, "os.PathLike[str]"]
Progress = Callable[[float], object]


class OwnMembers(type):
    """Has help() and dir() list what a class adds to the list or dict that it is."""

    def __dir__(cls) -> List[str]:
        own = [base for base in cls.__mro__ if base.__module__ != "builtins"]
        return sorted({name for base in own for name in vars(base)})


def path_text(file: Path) -> str:
    """The name of a file, which has no NUL: the system would end the name there."""
    name = os.fspath(file)
    if not isinstance(name, str):
        raise TypeError(f"a file's name is a str or a path, not {type(name).__name__}")
    if "\0" in name:
        raise InputError(f"{name!r}: is no file's name: it contains NUL")
    return name


def json_text(value: Any) -> str:
    """The text of JSON, with numpy's numbers and arrays, and paths."""

    def plain(other: Any) -> Any:
        if isinstance(other, (np.ndarray, np.generic)):
            return other.tolist()
        if isinstance(other, os.PathLike):
            return os.fspath(other)
        raise TypeError(f"{type(other).__name__} {other!r} cannot stand in a session")

    try:
        return json.dumps(value, default=plain, allow_nan=False)
    except ValueError as error:
        raise InputError(f"a number is not finite, or a value contains itself: {error}") from None


def overrides_of(section: str, values: Mapping[str, Any]) -> List[str]:
    """As --set takes them."""
    return [f"{section}.{name}={json_text(value)}" for name, value in values.items()]


_warned: Set[str] = set()


def warn(lines: List[str]) -> None:
    """Each line once in a process: the same light field may be opened many times."""
    for line in lines:
        if line not in _warned:
            _warned.add(line)
            warnings.warn(line, UserWarning, stacklevel=3)


def array_of(value: Any) -> np.ndarray:
    """What numpy makes of xarray's arrays, lists and the like."""
    if isinstance(value, np.ndarray):
        return value
    if isinstance(value, (list, tuple)) or hasattr(value, "__array__"):
        return np.asarray(value)
    raise TypeError(f"{type(value).__name__} is no array")


def around(
    file: str, overrides: List[str], progress: Optional[Progress]
) -> Tuple[str, List[str]]:
    """A new session's text around a folder, a picture or a mesh, and warnings."""
    text, lines = _hogelscope.around(file, overrides, progress)
    return text, [f"{file}: {line}" for line in lines]


def open(  # noqa: A001: as in hogelscope.open
    file: Path,
    layout: Optional[str] = None,
    *,
    display: Optional[Mapping[str, Any]] = None,
    progress: Optional[Progress] = None,
    **settings: Any,
) -> LightField:
    """Open a light field of any layout, in memory only when a view needs it.

    Args:
        file: a picture, a folder or %-pattern of views, a video, an HDF5 file, a store, a mesh.
        layout: "hogels", "views", "quilt", "mosaic", "lenslets" or "pack", read as a session with
            these settings says. None: what ``--info`` finds; the order of views is found from their
            pictures.
        display: the display's fields that the file does not say, such as
            {"hogels": [128, 128], "directions": [20, 20]} of layout "hogels",
            {"directions": [15, 15]} of layout "mosaic".
        settings: fields of a session's lightField, such as rows="bottom-up", shear=[1, 1].
        progress: called with the fraction done, 0 to 1.

    Stores larger than memory are read where views need them. What the light field lacks is a
    UserWarning. Raises InputError.
    """
    name = path_text(file)
    lines: List[str] = []
    if layout is None:
        overrides = overrides_of("lightField", settings) + overrides_of("display", display or {})
        text, lines = around(name, overrides, progress)
    else:
        own = {"file": name, "layout": layout, **settings}
        text = json_text({"hogelscope": 1, "display": dict(display or {}), "lightField": own,
                          "cameras": [{"name": "any"}]})
    try:
        light = _hogelscope.open(_hogelscope.Document(text, "", ""), lines, progress)
    except InputError as error:
        if name in str(error):
            raise
        raise InputError(f"{name}: {error}") from None
    warn(light.warnings)
    return light


def light_choice(light: Any) -> Any:
    """What stands for a light field: None, a LightField, an array, or a file as --test takes it."""
    if light is None or isinstance(light, LightField):
        return light
    if isinstance(light, (str, os.PathLike)):
        return path_text(light)
    return LightField(light)


def info(
    file: Path, *, overrides: Sequence[str] = (), progress: Optional[Progress] = None
) -> Dict[str, Any]:
    """Return what ``--info --json`` says of a light field or of a session's file.

    Returns:
        {"layout", "hogels": [nx, ny], "directions": [du, dv], "rows", "columns": the order of
        views, "shear": pixels for each view, "confidence": "sure", "likely" or "unknown",
        "warnings": sentences, and "lenslets" of that layout}. Nothing is assumed silently: look at
        the confidence before the light field is used. ``overrides`` are those of ``--set``.
        Raises InputError.
    """
    found: Dict[str, Any] = json.loads(_hogelscope.info(path_text(file), list(overrides), progress))
    return found
