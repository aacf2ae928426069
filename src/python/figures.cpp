// SPDX-License-Identifier: BSD-3-Clause
// Metrics and BD-rates for Python.
#include <pybind11/stl.h>

#include <optional>
#include <tuple>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/metrics/bd_rate.h"
#include "io/plugins/metric_plugins.h"
#include "python/bindings.h"
#include "python/pictures.h"
#include "python/stoppable.h"

namespace hogelscope {

namespace py = pybind11;

namespace {

/// Copies an image (h, w, 3) of uint8 or uint16 and a mask (h, w) of 0 and 1.
Image imageOf(const py::array& picture, const Bytes& seen, const std::optional<Floats>& unrounded) {
  checkPicture(picture);
  const bool isDeep = py::isinstance<Words>(picture);
  if (seen.ndim() != 2 || seen.shape(0) != picture.shape(0) || seen.shape(1) != picture.shape(1))
    throw InputError("seen", "has not the picture's height and width");
  Image image(int(picture.shape(1)), int(picture.shape(0)), isDeep ? 16 : 8);
  if (isDeep) {
    const auto* const values = static_cast<const std::uint16_t*>(picture.data());
    constexpr float unit = 257;
    std::vector<float> codeValues(values, values + picture.size());
    for (float& value : codeValues) value /= unit;
    setValues(image, 0, codeValues);
  } else {
    const auto* const values = static_cast<const std::uint8_t*>(picture.data());
    std::copy_n(values, picture.size(), image.rgb.begin());
  }
  for (std::size_t k = 0; k < image.seen.size(); ++k) image.seen[k] = seen.data()[k] != 0 ? 255 : 0;
  if (unrounded && unrounded->size() == picture.size())
    image.unrounded.assign(unrounded->data(), unrounded->data() + unrounded->size());
  return image;
}

using Parts = std::tuple<py::array, Bytes, std::optional<Floats>>;

py::dict compare(const Parts& reference, const Parts& test, const std::vector<std::string>& metrics,
                 double pixelsPerDegree, double distance, const std::string& state) {
  const Image a = std::apply(imageOf, reference);
  const Image b = std::apply(imageOf, test);
  if (a.width != b.width || a.height != b.height)
    throw InputError("test", "is " + pairText(b.width, b.height) + " px, but the reference is " +
                                 pairText(a.width, a.height));
  const MetricSet set = metricsOf(metrics);
  const std::vector<double> values = stoppable(py::none(), [&](const Progress& hear) {
    return set.compare(a, b, parallelRows, hear, {pixelsPerDegree, distance, state});
  });
  py::dict result;
  for (std::size_t k = 0; k < values.size(); ++k)
    result[py::str(set.columns()[k].name)] = values[k];
  return result;
}

std::vector<RatePoint> pointsOf(const std::vector<std::pair<double, double>>& pairs) {
  std::vector<RatePoint> points;
  points.reserve(pairs.size());
  for (const auto& [rate, quality] : pairs) points.push_back({rate, quality});
  return points;
}

py::dict bdRate(const std::vector<std::pair<double, double>>& anchor,
                const std::vector<std::pair<double, double>>& test) {
  const BdDelta delta = bdDelta(pointsOf(anchor), pointsOf(test));
  if (!delta.problem.empty()) throw InputError("rate-distortion curves", delta.problem);
  py::dict result;
  result["rate"] = delta.rate;
  result["quality"] = delta.quality;
  result["from"] = delta.from;
  result["to"] = delta.to;
  return result;
}

}  // namespace

void addFigures(py::module_& module) {
  module.def("compare", &compare, py::arg("reference"), py::arg("test"), py::arg("metrics"),
             py::arg("pixels_per_degree"), py::arg("distance"), py::arg("state"),
             "Metrics of two pictures: (picture, seen, values or None) each.");
  module.def(
      "read_values",
      [](const std::vector<std::string>& metrics) { return metricsOf(metrics).readUnrounded(); },
      py::arg("metrics"), "Whether compare() with these metrics reads values before rounding.");
  module.def("bd_rate", &bdRate, py::arg("anchor"), py::arg("test"),
             "Bjøntegaard's deltas of two lists of (rate, quality).");
}

}  // namespace hogelscope
