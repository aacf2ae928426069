# SPDX-License-Identifier: BSD-3-Clause
"""What a camera sees."""

from __future__ import annotations

import math
import os
import sys
from typing import Any, List, Optional, Union

import numpy as np

from . import _hogelscope
from ._content import path_text


class View:
    """The picture of one camera state. It needs neither its session nor its light field any more.

    Attributes:
        state: name of the camera state.
        image: (h, w, 3) uint8, R, G, B; row 0 is the top. The pixels of ``--render``'s PNG.
        seen: (h, w) bool, whether the display is seen there; the others are black. With a pupil,
            whether all of it sees the display; where a part does, the picture has its light.
        values: (h, w, 3) float32, the image before rounding, in code values (0 to 255, not
            limited to them). They are rendered when they are first asked for; if a file of the
            session has changed since, that raises InputError. None if the light field is larger
            than the memory and could only be read once from the top (a PNG); pack it into a store
            then.
        focus: distance of focus of a picture of a focus stack, in metres; None for others.
        pixels_per_degree: of the eye's field, in the middle of the picture; NaN if not known.
        distance: from the eye to the panel's centre, in metres; NaN if not known.
    """

    __slots__ = (
        "state", "image", "seen", "_values", "focus", "pixels_per_degree", "distance", "_inputs"
    )

    def __init__(
        self,
        state: str,
        image: np.ndarray,
        seen: np.ndarray,
        values: Optional[np.ndarray] = None,
        focus: Optional[float] = None,
        pixels_per_degree: float = math.nan,
        distance: float = math.nan,
    ) -> None:
        self.state = state
        self.image = image
        self.seen = seen
        self._values: Union[None, np.ndarray, _hogelscope.UnroundedView] = values
        self.focus = focus
        self.pixels_per_degree = pixels_per_degree
        self.distance = distance
        self._inputs: List[str] = []  # files that it was made of

    @property
    def values(self) -> Optional[np.ndarray]:
        """The image before rounding: see View."""
        if isinstance(self._values, _hogelscope.UnroundedView):
            self._values = self._values.values()
        return self._values

    @values.setter
    def values(self, values: Optional[np.ndarray]) -> None:
        self._values = values

    def __getstate__(self) -> Any:
        """With its values, for pickle and copy."""
        _ = self.values
        return None, {name: getattr(self, name) for name in self.__slots__}

    def __repr__(self) -> str:
        height, width = self.seen.shape
        return f"<View {self.state!r}: {width}×{height} px, {self.seen.mean():.0%} see the display>"

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> np.ndarray:
        """The image, for np.asarray(view); a copy only where one is asked for or needed."""
        image = self.image if dtype is None else self.image.astype(dtype, copy=False)
        return image.copy() if copy else image

    def _repr_png_(self) -> bytes:
        """The picture, for notebooks."""
        return _hogelscope.png(np.ascontiguousarray(self.image))

    def show(self) -> None:
        """Show the picture: in a notebook below the cell, otherwise in matplotlib's window. Needs
        IPython or matplotlib (Debian: python3-matplotlib). Raises ImportError."""
        if "IPython" in sys.modules:
            from IPython import get_ipython
            from IPython.display import display

            if get_ipython() is not None:
                display(self)
                return
        from matplotlib import pyplot

        figure, axes = pyplot.subplots(num=self.state)
        axes.imshow(self.image)
        axes.set_axis_off()
        figure.tight_layout()
        figure.show()

    def save(self, file: Union[str, "os.PathLike[str]"]) -> None:
        """Write the picture: .png as ``--render`` does, .exr and .tif from ``values``, as its
        ``--format`` does. The file is complete or not there, and never replaces one that the view
        was made of. A changed ``image`` is uint8, changed ``values`` are float32 of its shape.
        Raises InputError."""
        name = path_text(file)
        is_float = name.lower().endswith((".exr", ".tif", ".tiff"))
        if is_float and self.values is None:
            raise _hogelscope.InputError(f"{name}: the view has no values: write a PNG")
        values = np.ascontiguousarray(self.values) if is_float else None
        _hogelscope.write(name, np.ascontiguousarray(self.image), values, self._inputs)

    def to_vtk(self) -> Any:
        """Return a new vtkImageData of the picture, for VTK and PyVista.

        Point data: the scalars "image" (3 components, unsigned char) and the array "seen" (0 or
        1). One pixel is one unit; VTK's rows begin at the bottom, so (0, 0) is the picture's
        bottom left pixel. Needs Debian's python3-vtk9, or VTK of pip. Raises ImportError.
        """
        from vtkmodules.util.numpy_support import numpy_to_vtk
        from vtkmodules.vtkCommonDataModel import vtkImageData

        height, width = self.seen.shape
        data = vtkImageData()
        data.SetDimensions(width, height, 1)
        for name, rows in (("image", self.image), ("seen", self.seen.astype(np.uint8))):
            flat = np.ascontiguousarray(rows[::-1]).reshape(height * width, -1)
            array = numpy_to_vtk(flat, deep=True)
            array.SetName(name)
            data.GetPointData().AddArray(array)
        data.GetPointData().SetActiveScalars("image")
        return data
