// SPDX-License-Identifier: BSD-3-Clause
#include "python/pictures.h"

#include <algorithm>

#include "core/base/error.h"

namespace hogelscope {

namespace py = pybind11;

std::string shapeText(const py::array& array) {
  return py::str(array.attr("shape")).cast<std::string>();
}

namespace {

[[noreturn]] void refuse(const char* what, const py::array& array, const std::string& allowed) {
  throw InputError(what, "is " + shapeText(array) + " of " +
                             py::str(array.dtype()).cast<std::string>() + "; " + allowed);
}

}  // namespace

void checkPicture(const py::array& picture) {
  if ((!py::isinstance<Words>(picture) && !py::isinstance<Bytes>(picture)) || picture.ndim() != 3 ||
      picture.shape(2) != 3)
    refuse("picture", picture, "pictures are (height, width, 3) of uint8 or uint16");
  constexpr py::ssize_t most = 1000000;
  if (picture.size() == 0 || picture.shape(0) > most || picture.shape(1) > most)
    throw InputError("picture", "is " + shapeText(picture) + "; sizes are 1 to 1000000");
}

Bytes bytesOf(const py::array& picture) {
  checkPicture(picture);
  if (!py::isinstance<Bytes>(picture))
    refuse("picture", picture, "pictures of a view are (height, width, 3) of uint8");
  return py::cast<Bytes>(picture);
}

Bytes writableBytesOf(const py::array& out) {
  if (!py::isinstance<Bytes>(out) || out.ndim() != 3 || out.shape(2) != 3)
    refuse("out", out, "a picture is written into (height, width, 3) of uint8, in C order");
  if (!out.writeable()) throw InputError("out", "is a numpy array that may not be written");
  return py::cast<Bytes>(out);
}

Floats valuesOf(const py::array& values, const py::array& picture) {
  if (!py::isinstance<Floats>(values) || values.ndim() != picture.ndim() ||
      !std::equal(values.shape(), values.shape() + values.ndim(), picture.shape()))
    refuse("values", values, "those of this picture are " + shapeText(picture) + " of float32");
  return py::cast<Floats>(values);
}

}  // namespace hogelscope
