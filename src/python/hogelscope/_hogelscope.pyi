# SPDX-License-Identifier: BSD-3-Clause
# Types of the extension module; tests/python/test_stubs.py compares them with it.
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

version: str
plugin_abi: int

class InputError(ValueError): ...
class Stopped(KeyboardInterrupt): ...

class Document:
    def __init__(self, text: str, folder: str, name: str) -> None: ...

class LightField:
    def __init__(
        self, array: Any, *, progress: Optional[Callable[[float], object]] = None
    ) -> None: ...
    @property
    def shape(self) -> Tuple[int, ...]: ...
    @property
    def dtype(self) -> np.dtype[Any]: ...
    @property
    def files(self) -> List[str]: ...
    @property
    def warnings(self) -> List[str]: ...
    @property
    def frames(self) -> range: ...
    @property
    def fps(self) -> Optional[float]: ...
    def array(
        self,
        *,
        frame: Optional[int] = None,
        progress: Optional[Callable[[float], object]] = None,
    ) -> np.ndarray: ...

class SessionViews:
    def __init__(self) -> None: ...
    def render(
        self,
        document: Document,
        states: Optional[Sequence[str]],
        light_field: Union[None, LightField, str],
        ideal: bool,
        eye: str,
        focus_stack: int,
        out: Sequence[np.ndarray],
        first: int,
        is_part: bool,
        frame: Optional[int],
        time: Optional[float],
        threads: int,
        progress: Optional[Callable[[float], object]],
    ) -> Tuple[
        List[
            Tuple[
                str,
                Optional[np.ndarray],
                np.ndarray,
                Union[None, np.ndarray, UnroundedView],
                Optional[float],
                float,
                float,
            ]
        ],
        List[str],
    ]: ...

class UnroundedView:
    def values(self) -> np.ndarray: ...

def add_plugin_folder(folder: str) -> None: ...
def allow_memory(bytes: float) -> None: ...
def around(
    file: str, overrides: Sequence[str], progress: Optional[Callable[[float], object]]
) -> Tuple[str, List[str]]: ...
def bd_rate(
    anchor: Sequence[Tuple[float, float]], test: Sequence[Tuple[float, float]]
) -> Dict[str, float]: ...
def cameras(document: Document, what: str, overrides: Sequence[str]) -> str: ...
def check(document: Document) -> None: ...
def compare(
    reference: Tuple[np.ndarray, np.ndarray, Optional[np.ndarray]],
    test: Tuple[np.ndarray, np.ndarray, Optional[np.ndarray]],
    metrics: Sequence[str],
    pixels_per_degree: float,
    distance: float,
    state: str,
) -> Dict[str, float]: ...
def depth(
    document: Document, threads: int, progress: Optional[Callable[[float], object]]
) -> Tuple[str, str, str]: ...
def info(
    file: str, overrides: Sequence[str], progress: Optional[Callable[[float], object]]
) -> str: ...
def load(
    file: str, overrides: Sequence[str], calibration: str, camera: str
) -> Tuple[str, List[str]]: ...
def measure(
    document: Document,
    output: str,
    threads: int,
    progress: Optional[Callable[[float], object]],
) -> str: ...
def png(image: np.ndarray) -> bytes: ...
def normal(document: Document) -> str: ...
def open(
    document: Document, warnings: Sequence[str], progress: Optional[Callable[[float], object]]
) -> LightField: ...
def optimise(
    document: Document,
    layout: str,
    output: str,
    threads: int,
    progress: Optional[Callable[[float], object]],
) -> Tuple[str, List[str]]: ...
def page(
    document: Document,
    title: str,
    output: str,
    is_exact: Optional[bool],
    threads: int,
    progress: Optional[Callable[[float], object]],
) -> Tuple[str, List[str]]: ...
def read_values(metrics: Sequence[str]) -> bool: ...
def campaign_scenes(
    text: str, file: str, output: str
) -> Tuple[List[str], List[Dict[str, Any]]]: ...
def campaign_tables(text: str, file: str, output: str) -> Tuple[str, str, str, List[str]]: ...
def report(
    document: Document,
    light_field: Union[None, LightField, str],
    tests: Sequence[Tuple[str, Union[None, LightField, str]]],
    groups: Sequence[Tuple[str, Sequence[Tuple[str, Optional[float]]]]],
    metrics: Sequence[Tuple[str, Callable[..., Any]]],
    output: str,
    against: str,
    units: Sequence[Tuple[str, Document]],
    images: bool,
    frames: str,
    threads: int,
    progress: Optional[Callable[[float], object]],
) -> Tuple[
    List[Dict[str, Any]],
    Dict[str, Dict[str, float]],
    Dict[str, Dict[str, Tuple[float, float]]],
    List[Dict[str, Any]],
    List[str],
]: ...
def save(document: Document, file: str) -> None: ...
def sweep(
    document: Document,
    table: str,
    output: str,
    threads: int,
    progress: Optional[Callable[[float], object]],
) -> str: ...
def write(
    file: str, image: np.ndarray, values: Optional[np.ndarray], inputs: List[str]
) -> None: ...
