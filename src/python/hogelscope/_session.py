# SPDX-License-Identifier: BSD-3-Clause
"""Sessions: a display, its light field, and cameras."""

from __future__ import annotations

import copy
import json
import os
from numbers import Integral
from typing import (
    Any, Callable, Dict, Iterable, Iterator, List, Mapping, Optional, Sequence, Tuple, Union, overload
)

import numpy as np

from . import _hogelscope
from ._content import OwnMembers, Path, Progress, around, json_text, light_choice, path_text, warn
from ._hogelscope import InputError, LightField
from ._view import View

State = Union[str, int, Mapping[str, Any]]
Metric = Callable[
    [np.ndarray, np.ndarray, np.ndarray, Dict[str, Any]], Union[float, Mapping[str, float]]
]


def named_states(states: Iterable[Any]) -> List[Any]:
    """States with a name: "view N" for the N-th that has none, from 1, or the next free N."""
    named = list(states)
    known = {state["name"] for state in named if isinstance(state, Mapping) and "name" in state}
    for k, state in enumerate(named):
        if isinstance(state, Mapping) and "name" not in state:
            number = k + 1
            while f"view {number}" in known:
                number += 1
            known.add(f"view {number}")
            named[k] = {"name": f"view {number}", **state}
    return named


def _check_eye(eye: Optional[str]) -> None:
    if eye not in (None, "left", "right"):
        raise InputError(f'eye: "{eye}" is neither "left" nor "right"')


class Session(dict[str, Any], metaclass=OwnMembers):
    """A session document as a dict: "display", "lightField", "sampling", "metrics", "cameras".

    Args:
        source: a session file; a folder of views, a picture or a mesh, around which a new session
            is made as on the command line; a mapping; or the text of a document (begins with {).
        folder: what the file names of a mapping or a text are relative to; the current folder.
        overrides: changes as ``--set`` takes them: ["display.fov=[50,50]", "psf.sigma=0"].
        calibration: a file of cameras, one of which every state gets, as ``--calibration``.
        camera: which of them, as ``--camera``.
        progress: called with the fraction done while views are looked at.
        check: whether a mapping is checked now, as files are.

    Lengths are metres, angles degrees; all fields are in the manual's parameters.md. Camera states
    without a name get one. What is changed afterwards is checked when it is used. Raises
    InputError.

    The light field is read by the first view and kept in memory with the session, until its files
    or its settings change.
    """

    def __init__(
        self,
        source: Union[Path, Mapping[str, Any]],
        *,
        folder: Path = "",
        overrides: Sequence[str] = (),
        calibration: Optional[Path] = None,
        camera: str = "",
        progress: Optional[Progress] = None,
        check: bool = True,
    ) -> None:
        self.folder = path_text(folder)
        self.name = ""
        self._views: Optional[_hogelscope.SessionViews] = None
        changes = list(overrides)
        if camera and calibration is None:
            raise InputError(f"camera {camera}: needs a calibration, of which it is a camera")
        if isinstance(source, Mapping):
            document = copy.deepcopy(dict(source))
            document.setdefault("hogelscope", 1)
            if isinstance(document.get("cameras"), (list, tuple)):
                document["cameras"] = named_states(document["cameras"])
            super().__init__(document)
            if isinstance(source, Session):
                self.folder, self.name = source.folder, source.name
            if changes or calibration is not None:
                raise InputError("overrides and calibration are for files; change the mapping")
            if check:
                self._check_mapping()
            return
        text = path_text(source)
        if text.lstrip().startswith("{"):
            self._read(text)
            if changes or calibration is not None:
                raise InputError("overrides and calibration are for files; change the session")
        elif os.path.isdir(text) or not text.lower().endswith((".json", ".hogelscope")):
            if calibration is not None:
                raise InputError(f"{text}: a calibration is for a session file")
            found, lines = around(text, changes, progress)
            self._read(found)
            warn(lines)
        elif changes or calibration is not None:
            given = "" if calibration is None else path_text(calibration)
            self.name = text
            found, lines = _hogelscope.load(text, changes, given, camera)
            self._read(found)
            warn(lines)
        else:
            self.name = text
            self.folder = os.path.dirname(text)
            _hogelscope.load(text, [], "", "")  # its words for what is wrong
            with open(text, encoding="utf-8") as file:
                self._read(file.read())

    def _check_mapping(self) -> None:
        """A mapping may lack its light field, which calls can give, and its states."""
        states = [{"name": "any"}] if self.get("cameras", []) == [] else None
        _hogelscope.check(self._document(states, "lightField" in self))

    def _read(self, text: str) -> None:
        _hogelscope.check(_hogelscope.Document(text, self.folder, self.name))
        super().__init__(json.loads(text))

    def __getstate__(self) -> Dict[str, Any]:
        return {"folder": self.folder, "name": self.name, "_views": None}

    def copy(self) -> "Session":
        """Return a session of its own, whose parts may be changed."""
        return Session(json.loads(json_text(self)), folder=self.folder, check=False)._named(self.name)

    def _named(self, name: str) -> "Session":
        self.name = name
        return self

    def _document(
        self, cameras: Optional[Sequence[Any]] = None, has_light: bool = True
    ) -> _hogelscope.Document:
        """Without its light field it needs none, but keeps how its views converge."""
        parts: Dict[str, Any] = dict(self)
        if cameras is not None:
            parts["cameras"] = list(cameras)
        if isinstance(parts.get("cameras"), list):
            parts["cameras"] = named_states(parts["cameras"])
        if not has_light:
            own = self.get("lightField")
            parts["lightField"] = {"file": "none", "layout": "views"}
            if isinstance(own, Mapping) and "viewingDistance" in own:
                parts["lightField"]["viewingDistance"] = own["viewingDistance"]
        return _hogelscope.Document(json_text(parts), self.folder, self.name)

    def check(self) -> None:
        """Raise InputError if the session is not right; its files are not opened."""
        _hogelscope.check(self._document())

    def text(self) -> str:
        """Return the document as the program writes it, with all fields, its files relative to
        the current folder. Raises InputError."""
        return _hogelscope.normal(self._document())

    def save(self, file: Path) -> None:
        """Write a session file, NAME.json or NAME.hogelscope, its files relative to it; complete or
        not at all, and never over a file that the session reads. Raises InputError."""
        _hogelscope.save(self._document(), path_text(file))

    def light_field(self, *, progress: Optional[Progress] = None) -> LightField:
        """Open the session's own light field; ``.array()`` of it is what numpy code needs, of live
        scenes too. Raises InputError."""
        return _hogelscope.open(self._document(), [], progress)

    @overload
    def render(
        self,
        state: State,
        light_field: Any = None,
        *,
        ideal: bool = False,
        eye: Optional[str] = None,
        out: Optional[np.ndarray] = None,
        frame: Optional[int] = None,
        time: Optional[float] = None,
        threads: int = 0,
        progress: Optional[Progress] = None,
    ) -> View: ...

    @overload
    def render(
        self,
        state: State,
        light_field: Any = None,
        *,
        ideal: bool = False,
        eye: Optional[str] = None,
        focus_stack: int,
        out: Optional[Sequence[np.ndarray]] = None,
        frame: Optional[int] = None,
        time: Optional[float] = None,
        threads: int = 0,
        progress: Optional[Progress] = None,
    ) -> List[View]: ...

    @overload
    def render(
        self,
        state: Optional[Sequence[State]] = None,
        light_field: Any = None,
        *,
        ideal: bool = False,
        eye: Optional[str] = None,
        focus_stack: Optional[int] = None,
        out: Optional[Sequence[np.ndarray]] = None,
        frame: Optional[int] = None,
        time: Optional[float] = None,
        threads: int = 0,
        progress: Optional[Progress] = None,
    ) -> List[View]: ...

    def render(
        self,
        state: Any = None,
        light_field: Any = None,
        *,
        ideal: bool = False,
        eye: Optional[str] = None,
        focus_stack: Optional[int] = None,
        out: Any = None,
        frame: Optional[int] = None,
        time: Optional[float] = None,
        threads: int = 0,
        progress: Optional[Progress] = None,
    ) -> Any:
        """Render what a camera sees: a View, or a list of Views.

        Args:
            state: a state's name, its index, or a mapping such as those of cameras() (a name may be
                left out); a sequence
                of them, or None for all states of the session, gives a list.
            light_field: instead of the session's: a LightField, a numpy array (dv, du, ny, nx, 3),
                or a file as ``--test`` takes it.
            ideal: the scene itself, without the display; of a live scene alone.
            eye: "left" or "right" of states with "stereo"; without it the view of the head, from
                between the eyes.
            focus_stack: a list of so many views of each state, two or more, instead of one: focused
                evenly in dioptres over the depths that the display can show, the nearest first.
                ``focus`` of each is its distance in metres. The states need a pupil.
            out: an array (h, w, 3) of uint8 that the picture is written into, which is then the
                View's ``image``; of a list of Views a sequence of them, or one (n, h, w, 3).
                Without it each View has a picture of its own, in memory of Views that are no
                longer used.
            frame: of a light field in time, for states without a "time": by default the first.
            time: the same in seconds from the first frame on.
            threads: 0 for one per core; of the whole process while the call lasts.
            progress: called with the fraction done, 0 to 1.

        Other threads run meanwhile; Ctrl-C stops it. Raises InputError.
        """
        _check_eye(eye)
        if focus_stack is not None and not (
            isinstance(focus_stack, Integral) and 2 <= focus_stack <= 9999
        ):
            raise InputError(f"focus_stack: {focus_stack} is not a whole number from 2 to 9999")
        is_one = isinstance(state, (str, bytes, Integral, Mapping))
        wanted = None if state is None else [state] if is_one else list(state)
        if wanted == []:
            return []
        if frame is not None and time is not None:
            raise InputError("frame, time: give one of them")
        is_picture = is_one and focus_stack is None
        document, names = self._of_states(wanted, light_field)
        arrays = [] if out is None else [out] if is_picture else list(out)
        for array in arrays:
            if not isinstance(array, np.ndarray):
                raise TypeError(f"out: {type(array).__name__} is no numpy array")
        views = self._rendered(
            document, names, light_choice(light_field), ideal, eye or "", int(focus_stack or 0),
            arrays, 0, False, frame, time, threads, progress
        )
        for view, array in zip(views, arrays):
            view.image = array
        return views[0] if is_picture else views

    def render_all(
        self,
        states: Optional[Sequence[State]] = None,
        light_field: Any = None,
        *,
        ideal: bool = False,
        eye: Optional[str] = None,
        frame: Optional[int] = None,
        time: Optional[float] = None,
        threads: int = 0,
    ) -> Iterator[View]:
        """Render many states, some for each core at a time, and yield their Views in order: for
        more pictures than fit in memory. The arguments are those of render(). Changes of the
        session meanwhile do not count. Raises InputError.
        """
        _check_eye(eye)
        wanted = None if states is None else list(states)
        document, names = self._of_states(wanted, light_field)
        light = light_choice(light_field)
        total = len(self.get("cameras", []) if wanted is None else wanted)
        done = 0
        while done < total:
            views = self._rendered(
                document, names, light, ideal, eye or "", 0, [], done, True, frame, time, threads,
                None,
            )
            done += len(views)
            while views:
                yield views.pop(0)

    def _of_states(
        self, states: Optional[List[Any]], light_field: Any
    ) -> Tuple[_hogelscope.Document, Optional[List[str]]]:
        """The document with the states that are wanted, and their names if these were given."""
        names: Optional[List[str]] = None
        cameras: Optional[List[Any]] = None
        if states is not None and all(isinstance(one, str) for one in states):
            names = states
            own = self.get("cameras")
            if isinstance(own, list) and all(isinstance(one, Mapping) for one in own):
                cameras = [one for one in own if one.get("name") in names]
                if {one["name"] for one in cameras} != set(names):
                    cameras = None  # the program says which there are
        elif states is not None:
            cameras = [self._state(one) for one in states]
        is_array = light_field is not None and not isinstance(light_field, (str, os.PathLike))
        return self._document(cameras, not is_array), names

    def _rendered(self, document: _hogelscope.Document, *arguments: Any) -> List[View]:
        if self._views is None:
            self._views = _hogelscope.SessionViews()
        rendered, inputs = self._views.render(document, *arguments)
        views = [View(*one) for one in rendered]
        for view in views:
            view._inputs = [*inputs, self.name]
        return views

    def _state(self, state: Any) -> Any:
        if isinstance(state, Mapping):
            return state
        own = self.get("cameras", [])
        if not isinstance(own, list) or not all(isinstance(one, Mapping) for one in own):
            raise InputError("cameras: is not a list of camera states: [ { … }, … ]")
        if isinstance(state, str):
            for one in own:
                if one.get("name") == state:
                    return one
            raise InputError(f'"{state}" is none of the session\'s states')
        if isinstance(state, Integral):
            if not -len(own) <= state < len(own):
                raise InputError(f"state {state}: the session has {len(own)}, numbered from 0")
            return own[int(state)]
        raise TypeError(f"a state is a name, an index or a mapping, not {type(state).__name__}")


def cameras(
    session: Session,
    what: Path = "random",
    *,
    region: Optional[Mapping[str, Any]] = None,
    trace: Optional[Mapping[str, Any]] = None,
    **settings: Any,
) -> List[Dict[str, Any]]:
    """Make a set of camera states, as the job ``--make-cameras`` does; a list of dicts, as in a
    session's "cameras".

    Args:
        session: whose display they look at, and whose first state gives lens, PSF, resolution and
            field of view.
        what: "uniform" (a regular grid; "grid" is the same), "random", "normal", or a file of
            poses, a path, a viewer's trace, or cameras of another program.
        region: fields of cameraRegion, such as {"region": "arc", "distance": [0.4, 0.8]} (m).
        trace: fields of trace.
        settings: fields of cameraSet: count, seed, name, template, place, scale.

    The session is not changed: session["cameras"] += cameras(…) adds them. Raises InputError.
    """
    kind = path_text(what)
    changes = [
        f"{section}.{name}={json_text(value)}"
        for section, values in (("cameraSet", settings), ("cameraRegion", region), ("trace", trace))
        for name, value in (values or {}).items()
    ]
    document = session._document(None, False)
    text = _hogelscope.cameras(document, "uniform" if kind == "grid" else kind, changes)
    states: List[Dict[str, Any]] = json.loads(text)["cameras"]
    return states


class Report(list[Dict[str, Any]], metaclass=OwnMembers):
    """The rows of a report, with what follows from them.

    Attributes:
        summary: {test: {mean: value}}, the names of summary.csv, such as "mean_psnr_seen"; where
            states have weights also "weighted_mean_psnr_seen" and others.
        intervals: {test: {mean: (low, high)}}, 95 % bootstrap intervals over the states.
        bd: a dict for each comparison of two groups by one mean: "anchor", "group", "quality",
            "over", "means", "rate" in percent, "rate_interval", "gain", "gain_interval", "from",
            "to", "problem".
    """

    def __init__(
        self,
        rows: Iterable[Dict[str, Any]],
        summary: Dict[str, Dict[str, float]],
        intervals: Dict[str, Dict[str, Tuple[float, float]]],
        bd: List[Dict[str, Any]],
    ) -> None:
        super().__init__(rows)
        self.summary = summary
        self.intervals = intervals
        self.bd = bd


def _named_tests(tests: Any) -> List[Tuple[str, Any]]:
    """Names and light fields: those of a mapping; files by their names; others "test N"."""
    if isinstance(tests, Mapping):
        return [(str(name), light) for name, light in tests.items()]
    is_one = isinstance(tests, (str, os.PathLike, LightField)) or hasattr(tests, "__array__")
    return [
        (path_text(one) if isinstance(one, (str, os.PathLike)) else f"test {k}", one)
        for k, one in enumerate([tests] if is_one else tests, 1)
    ]


def _rates(group: Any) -> List[Tuple[str, Optional[float]]]:
    """The tests of a group with their rates; None for that of the files."""
    if isinstance(group, Mapping):
        return [(str(test), None if rate is None else float(rate)) for test, rate in group.items()]
    tests = [group] if isinstance(group, str) else group
    return [(path_text(test), None) for test in tests]


def _units(
    session: Session, twins: Any, states: Optional[Sequence[Any]], has_light: bool
) -> List[Tuple[str, _hogelscope.Document]]:
    """Names, and the session with each twin; files are relative to the current folder."""
    named: Dict[str, Any] = {}
    if isinstance(twins, Mapping):
        named = {str(name): twin for name, twin in twins.items()}
    elif twins is not None:
        for file in [twins] if isinstance(twins, (str, os.PathLike)) else twins:
            name = os.path.basename(path_text(file))
            if name in named:
                raise InputError(f"twins: {name} is there twice: use a mapping with other names")
            named[name] = file
    units = []
    for name, twin in named.items():
        built = session.copy()
        if isinstance(twin, (str, os.PathLike)):
            file = path_text(twin)
            built["twin"] = os.path.abspath(file) if session.folder else file
        else:
            built["twin"] = twin
        units.append((name, built._document(states, has_light)))
    return units


def _frames_text(frames: Union[None, int, str, range]) -> str:
    """Frames as ``--frames`` has them; "" for all."""
    if frames is None:
        return ""
    if isinstance(frames, range):
        if len(frames) == 0 or frames.step < 1:
            raise InputError(f"frames: {frames} has no frame, or runs backwards")
        return f"{frames[0]}:{frames[-1]}:{frames.step}"
    return str(frames)


def report(
    session: Session,
    tests: Union[Mapping[str, Any], Iterable[Any]] = (),
    *,
    output: Path,
    light_field: Any = None,
    cameras: Optional[Sequence[Mapping[str, Any]]] = None,
    groups: Optional[Mapping[str, Union[Mapping[str, Optional[float]], Iterable[str]]]] = None,
    metrics: Optional[Mapping[str, Metric]] = None,
    against: Optional[str] = None,
    twins: Union[None, Path, Mapping[str, Any], Iterable[Any]] = None,
    images: bool = False,
    frames: Union[None, int, str, range] = None,
    threads: int = 0,
    progress: Optional[Progress] = None,
) -> Report:
    """Compare light fields over camera states, as ``--report`` does, and write its page and tables.

    Args:
        session: the reference.
        tests: {name: light field}, each a LightField, an array or a file; or a list of these.
        light_field: the reference, instead of the session's own, as in Session.render().
        output: the folder of report.html, report.csv, metrics.csv, summary.csv and others.
        cameras: states instead of the session's own.
        groups: {codec: {test: rate}}, rates in bits per directional pixel, four tests or more
            each: BD-rates of every codec against each earlier one, in the page and in bd.csv. The
            rate None, or {codec: [test, …]}, is that of the size of the test's files.
        metrics: {name: function}, called as function(reference, test, seen, info) for each state
            and test, one call at a time: two pictures, (h, w, 3) float32 from 0 to 1 (the values
            that are compared, over 255), the pixels that both see, (h, w) bool, and {"state",
            "pixels_per_degree" in the middle of the picture, "distance" in metres from the eye to
            the panel's centre, "light": "encoded", as sRGB is}. It returns a number, which becomes
            the column NAME, or a dict of numbers, columns NAME_KEY; NaN where nothing is defined.
            Columns, means and BD-rates follow as those of plugins do. A report that goes on does
            not call it again for what is done, so a changed function needs a new name.
        against: "ideal" compares a live scene's display with the scene itself, too; "design" the
            display as designed with units as they were built, of which "move_rms" and "move_rest"
            say how far rays move, in pixels, and how far beside the mean.
        twins: the units of against="design": a twin document, a list of them, or {name: unit},
            where a unit may be a dict such as session["twin"], too; without them the session's own.
        images: keep every picture.
        frames: of a light field in time: a frame, a range such as range(0, 100, 10), or a text as
            of ``--frames``; by default all. States with a time keep the frame of that time.
        threads, progress: as in Session.render().

    Returns:
        A Report, which is a list with a row for each frame, state and test: "state", "test", the columns of report.csv and metrics.csv
        ("mse", "psnr", "psnr_seen", "ssim", …; NaN where there is nothing to compare), "eye_x",
        "eye_y", "eye_z" (m), "weight", "problem" ("" if there is none) and, of a light field in
        time, "frame".
        pandas.DataFrame(rows) makes a table.

    A report that was stopped, by Ctrl-C or otherwise, goes on in the same folder when it is asked
    for again with the same light fields. Raises InputError.
    """
    if against not in (None, "ideal", "design"):
        raise InputError(f'against: "{against}" is neither "ideal" nor "design"')
    if twins is not None and against != "design":
        raise InputError('twins: are for against="design"')
    choices = []
    for name, light in _named_tests(tests):
        if light is None:
            raise TypeError(f"test {name!r} is None, not a light field")
        choices.append((name, light_choice(light)))
    rates = [(str(name), _rates(group)) for name, group in (groups or {}).items()]
    states = None if cameras is None else [dict(state) for state in cameras]
    light = light_choice(light_field)
    document = session._document(states, not isinstance(light, LightField))
    functions = list((metrics or {}).items())
    for name, function in functions:
        if not callable(function):
            raise TypeError(f"metric {name!r} is no function: {type(function).__name__}")
    *made, lines = _hogelscope.report(
        document, light, choices, rates, functions, path_text(output), against or "",
        _units(session, twins, states, not isinstance(light, LightField)), images,
        _frames_text(frames), threads, progress,
    )
    warn(lines)
    return Report(*made)
