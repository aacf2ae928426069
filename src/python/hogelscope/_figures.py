# SPDX-License-Identifier: BSD-3-Clause
"""Metrics and BD-rates."""

from __future__ import annotations

import math
from typing import Any, Dict, Iterable, Optional, Sequence, Tuple, Union

import numpy as np

from . import _hogelscope
from ._content import array_of
from ._view import View

Picture = Any  # a View, or what numpy makes an array of


_Parts = Tuple[np.ndarray, np.ndarray, Optional[np.ndarray]]


def _parts(picture: Picture, needs_values: bool) -> _Parts:
    if isinstance(picture, View):
        image, seen = np.ascontiguousarray(picture.image), np.ascontiguousarray(picture.seen)
        return image, seen, picture.values if needs_values else None
    array = array_of(picture)
    return np.ascontiguousarray(array), np.ones(array.shape[:2], np.uint8), None


def compare(
    reference: Picture, test: Picture, *, metrics: Union[str, Sequence[str]] = ()
) -> Dict[str, float]:
    """Return the figures of a report for two pictures.

    Args:
        reference, test: Views, or arrays (h, w, 3) of uint8 or uint16 of one size. Arrays count as
            seen everywhere, so the columns "…_seen" are for Views.
        metrics: names of plugins whose figures are wanted, too, or one name. They know from where
            a picture is seen by the View that is the reference, or else by that of the test; of
            two arrays what needs that is NaN.

    Returns:
        {"mse": (code values of 0 to 255) squared, "psnr": dB, "psnr_yuv": dB, "ssim": 0 to 1, …};
        PSNRs of equal pictures are infinite, NaN where nothing is to be compared. Raises
        InputError.
    """
    names = [metrics] if isinstance(metrics, str) else list(metrics)
    seen_as = next((one for one in (reference, test) if isinstance(one, View)), None)
    viewing = (
        (math.nan, math.nan, "")
        if seen_as is None
        else (seen_as.pixels_per_degree, seen_as.distance, seen_as.state)
    )
    unrounded = _hogelscope.read_values(names)
    figures: Dict[str, Any] = _hogelscope.compare(
        _parts(reference, unrounded), _parts(test, unrounded), names, *viewing
    )
    return figures


def bd_rate(
    anchor: Iterable[Tuple[float, float]], test: Iterable[Tuple[float, float]]
) -> Dict[str, float]:
    """Return Bjøntegaard's deltas of two rate-distortion curves.

    Args:
        anchor, test: four or more points (rate, quality) each; rates in bits of any kind,
            qualities such as PSNRs in dB, which rise with the rate.

    Returns:
        {"rate": percent that the test needs more at equal quality (below 0: fewer), "quality":
        what it is better by at equal rate, "from", "to": the qualities that both reach}. Raises
        InputError.
    """
    figures: Dict[str, float] = _hogelscope.bd_rate(list(anchor), list(test))
    return figures
