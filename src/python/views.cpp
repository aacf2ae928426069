// SPDX-License-Identifier: BSD-3-Clause
// Rendering for Python: views as numpy arrays.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "core/base/error.h"
#include "core/optics/eyes.h"
#include "io/files/files_in_use.h"
#include "io/images/image_writer.h"
#include "python/bindings.h"
#include "python/picture_memory.h"
#include "python/pictures.h"
#include "python/session_views.h"
#include "python/stoppable.h"

namespace hogelscope {

namespace py = pybind11;

namespace {

std::vector<std::size_t> pictureShape(const std::array<int, 2>& res) {
  return {std::size_t(res[1]), std::size_t(res[0]), 3};
}

py::object valuesToBe(RenderedView& view) {
  if (!view.values.isEmpty()) return arrayOf<float>(std::move(view.values), pictureShape(view.res));
  return py::cast(view.unrounded);
}

py::tuple tupleOf(RenderedView view) {
  const py::array seen = arrayOf<std::uint8_t>(
      std::move(view.seen), {std::size_t(view.res[1]), std::size_t(view.res[0])});
  const py::object image = view.rgb.isEmpty()
                               ? py::object(py::none())
                               : arrayOf<std::uint8_t>(std::move(view.rgb), pictureShape(view.res));
  return py::make_tuple(view.state, image, seen.attr("view")(py::dtype::of<bool>()),
                        valuesToBe(view), view.focus, view.viewing.pixelsPerDegree,
                        view.viewing.distance);
}

/// Takes the memory of the arrays that the pictures are written into.
void setOut(ViewRequest& request, const std::vector<py::array>& arrays) {
  for (const py::array& array : arrays) {
    Bytes picture = writableBytesOf(array);
    request.out.push_back(picture.mutable_data());
    request.outSizes.push_back({int(picture.shape(1)), int(picture.shape(0))});
  }
}

py::tuple render(SessionViews& views, const Document& document,
                 const std::optional<std::vector<std::string>>& states, const LightChoice& light,
                 bool ideal, const std::string& eye, int focusStack,
                 const std::vector<py::array>& out, std::size_t first, bool isPart,
                 std::optional<int> frame, std::optional<double> time, int threads,
                 const py::object& progress) {
  const ThreadsOfCall limit(threads);
  ViewRequest request{document, states, light, ideal, {},    focusStack,
                      first,    isPart, {},    {},    frame, time};
  if (!eye.empty()) request.eye = eye == nameOf(Eye::left) ? Eye::left : Eye::right;
  setOut(request, out);
  RenderedViews rendered =
      stoppable(progress, [&](const Progress& hear) { return views.render(request, hear); });
  py::list result;
  for (RenderedView& view : rendered.views) result.append(tupleOf(std::move(view)));
  return py::make_tuple(result, rendered.inputs);
}

py::array unroundedValues(const UnroundedView& view) {
  PictureMemory values =
      stoppable(py::none(), [&](const Progress& hear) { return view.render(hear); });
  return arrayOf<float>(std::move(values), pictureShape(view.res()));
}

void write(const std::string& file, const py::array& picture,
           const std::optional<py::array>& unrounded, const std::vector<std::string>& inputs) {
  const Bytes image = bytesOf(picture);
  const std::optional<Floats> values =
      unrounded ? std::optional(valuesOf(*unrounded, picture)) : std::nullopt;
  const auto height = int(image.shape(0));
  const auto width = int(image.shape(1));
  const auto size = std::size_t(image.size());
  const std::uint8_t* const rgb = image.data();
  const float* const floats = values ? values->data() : nullptr;
  runStoppable(py::none(), [&](const Progress& hear) {
    const FilesInUse inUse({inputs.begin(), inputs.end()});
    if (floats != nullptr)
      writeImage(file, width, height, std::span(floats, size));
    else
      writeImage(file, width, height, std::span(rgb, size), hear);
  });
}

py::bytes png(const py::array& picture) {
  const Bytes image = bytesOf(picture);
  const std::span rgb(image.data(), std::size_t(image.size()));
  return encodedPng(int(image.shape(1)), int(image.shape(0)), rgb);
}

}  // namespace

void addViews(py::module_& module) {
  py::class_<UnroundedView, std::shared_ptr<UnroundedView>>(
      module, "UnroundedView", "Values of a view that are not rendered yet.")
      .def("values", &unroundedValues, "Renders them: (h, w, 3) of float32.");
  py::class_<SessionViews>(module, "SessionViews", "What a session keeps between views.")
      .def(py::init<>())
      .def("render", &render, py::arg("document"), py::arg("states"), py::arg("light_field"),
           py::arg("ideal"), py::arg("eye"), py::arg("focus_stack"), py::arg("out"),
           py::arg("first"), py::arg("is_part"), py::arg("frame"), py::arg("time"),
           py::arg("threads"), py::arg("progress"),
           "Renders states: (name, image, seen, values, focus, pixels per degree, distance) of "
           "each, and the files that were read. The image is None if it is in `out`; values are an "
           "array, None or an UnroundedView.");
  module.def("png", &png, py::arg("image"), "The bytes of a PNG of 8-bit RGB.");
  module.def("write", &write, py::arg("file"), py::arg("image"), py::arg("values"),
             py::arg("inputs"), "Writes 8-bit RGB, or values as EXR or TIFF, over no input.");
}

}  // namespace hogelscope
