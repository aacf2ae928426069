// SPDX-License-Identifier: BSD-3-Clause
// Python's LightField: from numpy, from files, and back to numpy.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "io/scene/view_source.h"
#include "python/array_light_field.h"
#include "python/bindings.h"
#include "python/content.h"
#include "python/pictures.h"
#include "python/stoppable.h"

namespace hogelscope {

namespace py = pybind11;

namespace {

constexpr const char* wantedShape =
    "views in rows and columns are (dv, du, ny, nx, 3): rows of views from the top, columns from "
    "the left, then the pixels of a view; with frames in front (T, dv, du, ny, nx, 3)";

StoredType typeOf(const py::array& array) {
  if (py::isinstance<py::array_t<std::uint8_t>>(array)) return StoredType::uint8;
  if (py::isinstance<py::array_t<std::uint16_t>>(array)) return StoredType::uint16;
  if (py::isinstance<py::array_t<float>>(array)) return StoredType::real;
  throw InputError("array", "dtype",
                   "is " + py::str(array.dtype()).cast<std::string>() +
                       "; allowed are uint8, uint16, and float32 from 0 to 1, in the machine's "
                       "byte order: array.astype(…) makes one");
}

/// Returns the number of the first axis of a frame: 1 if the array has several.
int frameAxis(const py::array& array) {
  return array.ndim() == 6 ? 1 : 0;
}

LightFieldSize sizeOf(const py::array& array) {
  const int first = frameAxis(array);
  if (array.ndim() != 5 + first || array.shape(4 + first) != 3)
    throw InputError("array", "shape", "is " + shapeText(array) + "; " + wantedShape);
  const auto axis = [&](int k) {
    if (array.shape(k) < 1 || array.shape(k) > std::numeric_limits<std::int32_t>::max())
      throw InputError("array", "shape",
                       "is " + shapeText(array) + "; no size may be 0 or above 2^31");
    return int(array.shape(k));
  };
  if (first > 0) (void)axis(0);
  return {axis(3 + first), axis(2 + first), axis(1 + first), axis(first)};
}

/// Owns a reference that any thread may release.
std::shared_ptr<const void> ownerOf(const py::object& object) {
  PyObject* held = object.inc_ref().ptr();
  return {held, [](PyObject* reference) {
            const py::gil_scoped_acquire lock;
            Py_DECREF(reference);
          }};
}

/// Whether something has parts that follow each other, such as a generator's frames.
bool isSequence(const py::object& value) {
  return py::hasattr(value, "__iter__") && !py::isinstance<py::str>(value) &&
         !py::isinstance<py::bytes>(value) && !py::isinstance<py::dict>(value) &&
         !py::isinstance<py::set>(value);
}

/// Returns what numpy makes of lists and other sequences, and of objects that are arrays to it,
/// such as xarray's.
py::array arrayOf(const py::object& value) {
  if (py::isinstance<py::array>(value)) return value;
  const bool isArray = py::hasattr(value, "__array__");
  if (!isArray && !isSequence(value))
    throw py::type_error("a light field is made of a numpy array, not of " +
                         py::type::of(value).attr("__name__").cast<std::string>());
  try {
    const py::object list = isArray ? value : py::object(py::list(value));
    return py::module_::import("numpy").attr("asarray")(list);
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_ValueError)) throw;
    throw InputError("array", "shape", std::string("is that of no array; ") + wantedShape);
  }
}

std::shared_ptr<Content> fromArray(const py::object& value, const py::object& progress) {
  const py::array array = arrayOf(value);
  ViewArray views{sizeOf(array),
                  typeOf(array),
                  static_cast<const std::byte*>(array.data()),
                  {},
                  ownerOf(array)};
  const int first = frameAxis(array);
  std::copy_n(array.strides() + first, 5, views.strides.begin());
  if (first > 0) {
    views.frames = int(array.shape(0));
    views.frameStride = array.strides(0);
  }
  runStoppable(progress, [&](const Progress& hear) {
    for (int k = 0; k < views.frames; ++k) checkFinite(views.frame(k), hear);
  });
  LightFieldParams params;
  params.file = "array";
  auto file = std::make_shared<ArrayLightField>(std::move(views));
  const bool isKept = file->isCopied() && file->frames().isStill();
  const auto kind = isKept ? Content::Kind::copiedArray : Content::Kind::borrowedArray;
  return std::make_shared<Content>(params, DisplayParams{}, std::move(file),
                                   std::vector<std::string>{}, kind);
}

std::shared_ptr<Content> openContent(const Document& document,
                                     const std::vector<std::string>& warnings,
                                     const py::object& progress) {
  return stoppable(progress, [&](const Progress& hear) {
    const Session session = sessionOf(document);
    return std::make_shared<Content>(session.lightField, session.display,
                                     openLightField(session.lightField, session.display, hear),
                                     warnings);
  });
}

/// Returns (dv, du, ny, nx, 3), of a light field in time with its frames in front.
std::vector<std::size_t> shapeOf(const Content& content, bool isOneFrame = false) {
  const auto [nx, ny, du, dv] = content.file()->size();
  std::vector<std::size_t> shape{std::size_t(dv), std::size_t(du), std::size_t(ny), std::size_t(nx),
                                 3};
  const FrameNumbers frames = content.file()->frames();
  if (!isOneFrame && !frames.isStill()) shape.insert(shape.begin(), frames.count());
  return shape;
}

py::object rangeOf(const FrameNumbers& frames) {
  return py::module_::import("builtins").attr("range")(frames.first, frames.last + 1, frames.step);
}

py::dtype dtypeOf(StoredType type) {
  if (type == StoredType::uint8) return py::dtype::of<std::uint8_t>();
  return type == StoredType::uint16 ? py::dtype::of<std::uint16_t>() : py::dtype::of<float>();
}

/// Puts a hogel row's directions (·, v) at their places among views.
template <class T>
void putRow(const LightFieldSize& size, int j, int v, const T* rgb, T* views) {
  const auto [nx, ny, du, dv] = size;
  for (int i = 0; i < nx; ++i)
    for (int u = 0; u < du; ++u, rgb += 3) {
      const std::size_t view = std::size_t(v) * std::size_t(du) + std::size_t(u);
      const std::size_t pixel = (view * std::size_t(ny) + std::size_t(j)) * std::size_t(nx);
      std::copy_n(rgb, 3, views + 3 * (pixel + std::size_t(i)));
    }
}

/// Throws InputError if the light field has no such frame.
void requireFrame(const FrameNumbers& frames, int frame) {
  if (frames.has(frame)) return;
  throw InputError("frame", std::to_string(frame) + " is not there: the frames are " +
                                std::string(py::str(rangeOf(frames))));
}

py::array toArray(Content& content, const std::optional<int>& frame, const py::object& progress) {
  const LightFieldSize size = content.file()->size();
  const FrameNumbers all = content.file()->frames();
  if (frame) requireFrame(all, *frame);
  const FrameNumbers wanted = frame ? FrameNumbers{*frame, *frame, 1} : all;
  const StoredType type = content.file()->type();
  py::array result(dtypeOf(type), shapeOf(content, frame.has_value()));
  const std::size_t ofFrame = 3 * size.width() * size.height();
  void* const data = result.mutable_data();
  runStoppable(progress, [&](const Progress& hear) {
    for (std::size_t k = 0; k < wanted.count(); ++k) {
      const auto count = double(wanted.count());
      content.stream(
          wanted.number(k),
          [&](int j, int v, const StoredRows& row) {
            std::visit(
                [&](const auto* rgb) {
                  using T = std::remove_cvref_t<decltype(*rgb)>;
                  putRow(size, j, v, rgb, static_cast<T*>(data) + k * ofFrame);
                },
                row);
          },
          part(hear, double(k) / count, double(k + 1) / count));
    }
  });
  return result;
}

std::vector<std::string> fileNames(const Content& content) {
  std::vector<std::string> names;
  for (const std::filesystem::path& file : content.file()->files()) names.push_back(file.string());
  return names;
}

void allow(double bytes) {
  constexpr double least = 1e6;
  if (!(bytes >= least) || bytes > double(machineMemory()))
    throw InputError("bytes", "is not between 1e6 and this machine's memory");
  allowMemory(std::size_t(bytes));
}

}  // namespace

void addLightFields(py::module_& module) {
  py::class_<Content, std::shared_ptr<Content>>(
      module, "LightField",
      "A display's content: views (sub-aperture images) in rows and columns, or files.\n\n"
      "LightField(array) takes a numpy array of shape (dv, du, ny, nx, 3): dv rows of views from\n"
      "the top, du columns from the left, each view ny by nx pixels of R, G, B. dtype uint8,\n"
      "uint16 (65535 is white) or float32 (1.0 is white). View [v, u], pixel [y, x] is the light\n"
      "that hogel (x, y) sends into direction (u, v). Any strides will do, numpy.memmap too.\n"
      "(T, dv, du, ny, nx, 3) is a light field in time, of T frames, and so are frames one after\n"
      "another of a list or a generator, which are copied. Arrays above 100 MB, and\n"
      "those with frames, are not copied; do not change them while the LightField is used.\n"
      "Lists, and what numpy.asarray makes an array of, will do, too.\n\n"
      "hogelscope.open() opens files. Raises InputError.")
      .def(py::init(&fromArray), py::arg("array"), py::kw_only(), py::arg("progress") = py::none())
      .def_property_readonly(
          "shape", [](const Content& content) { return py::tuple(py::cast(shapeOf(content))); },
          "(dv, du, ny, nx, 3); of a light field in time (T, dv, du, ny, nx, 3)")
      .def_property_readonly(
          "dtype", [](const Content& content) { return dtypeOf(content.file()->type()); },
          "numpy.dtype of its values: uint8, uint16 or float32")
      .def_property_readonly("files", &fileNames, "Names of its files; none of an array.")
      .def_property_readonly(
          "warnings", [](const Content& content) { return content.warnings(); },
          "Lines on what it lacks, such as missing views.")
      .def_property_readonly(
          "frames", [](const Content& content) { return rangeOf(content.file()->frames()); },
          "A range of the numbers of its frames; of a still one.")
      .def_property_readonly(
          "fps",
          [](const Content& content) -> std::optional<double> {
            const double rate = frameRateOf(content.lightField(), *content.file());
            return rate > 0 ? std::optional(rate) : std::nullopt;
          },
          "Frames that are shown in a second; None if it is not known.")
      .def("array", &toArray, py::kw_only(), py::arg("frame") = py::none(),
           py::arg("progress") = py::none(),
           "Returns all of it as a new numpy array (dv, du, ny, nx, 3), of a light field in time\n"
           "(T, dv, du, ny, nx, 3), or one frame. Raises InputError.");
  module.def("allow_memory", &allow, py::arg("bytes"),
             "Set how many bytes light fields may take, in the whole process: a quarter of the "
             "machine's memory at first. What needs more is read piece by piece, or once from the "
             "top. Raises InputError.");
  module.def("open", &openContent, py::arg("document"), py::arg("warnings"), py::arg("progress"),
             "Opens a session's own light field.");
}

}  // namespace hogelscope
