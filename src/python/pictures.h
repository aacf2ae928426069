// SPDX-License-Identifier: BSD-3-Clause
// Pictures of Python: arrays (height, width, 3), which users may have changed.
#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <string>

namespace hogelscope {

using Bytes = pybind11::array_t<std::uint8_t, pybind11::array::c_style>;
using Words = pybind11::array_t<std::uint16_t, pybind11::array::c_style>;
using Floats = pybind11::array_t<float, pybind11::array::c_style>;

/// Returns "(40, 60, 3)".
std::string shapeText(const pybind11::array& array);

/// Throws InputError unless the array is a picture of uint8 or uint16, in C order.
void checkPicture(const pybind11::array& picture);

/// Returns a picture of uint8. Throws InputError.
Bytes bytesOf(const pybind11::array& picture);

/// Returns an array that a picture may be written into. Throws InputError.
Bytes writableBytesOf(const pybind11::array& out);

/// Returns the picture's values before rounding. Throws InputError unless they are float32 of its
/// shape.
Floats valuesOf(const pybind11::array& values, const pybind11::array& picture);

}  // namespace hogelscope
