// SPDX-License-Identifier: BSD-3-Clause
// The lens models that files name, and what is modelled of them.
#include <algorithm>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/cameras/camera_formats.h"

namespace hogelscope {

namespace {

constexpr const char* brown = "Brown–Conrady";
constexpr const char* rational = "rational";

struct LensName {
  std::string_view plain;  ///< as plainKey() gives it
  const char* model;
};

/// The names of the models that OpenCV, ROS, Kalibr, COLMAP, nerfstudio and others write. Those of
/// a pinhole stand for Brown's model without coefficients.
constexpr LensName lensNames[]{{"", brown},
                               {"plumbbob", brown},
                               {"radtan", brown},
                               {"radialtangential", brown},
                               {"brown", brown},
                               {"brownconrady", brown},
                               {"opencv", brown},
                               {"standard", brown},
                               {"pinhole", brown},
                               {"simplepinhole", brown},
                               {"simpleradial", brown},
                               {"radial", brown},
                               {"perspective", brown},
                               {"none", brown},
                               {"pinholeradtan", brown},
                               {"pinholeradialtangential", brown},
                               {"radtan4", brown},
                               {"radtan5", brown},
                               {"radtan8", rational},
                               {"rationalpolynomial", rational},
                               {"rational", rational},
                               {"fullopencv", rational},
                               {"equidistant", "fisheye"},
                               {"equi", "fisheye"},
                               {"fisheye", "fisheye"},
                               {"fisheye4", "fisheye"},
                               {"kannalabrandt", "fisheye"},
                               {"kannalabrandt4", "fisheye"},
                               {"kannalabrandt8", "fisheye"},
                               {"kb4", "fisheye"},
                               {"kb8", "fisheye"},
                               {"opencvfisheye", "fisheye"}};

}  // namespace

std::string lensModelOf(const FileCamera& camera) {
  const auto* const found = std::ranges::find(lensNames, plainKey(camera.model), &LensName::plain);
  return found == std::end(lensNames) ? "" : found->model;
}

Calibration calibrationOf(const FileCamera& camera) {
  const std::string model = lensModelOf(camera);
  const std::vector<double>& d = camera.coefficients;
  constexpr std::ptrdiff_t ofBrown = 5;
  const bool hasMore = std::ssize(d) > ofBrown &&
                       std::any_of(d.begin() + ofBrown, d.end(), [](double k) { return k != 0; });
  // A rational lens whose further coefficients are 0 is Brown's; a fisheye lens never is.
  if (model != brown && (model != rational || hasMore))
    throw InputError(camera.modelKey,
                     valueText(camera.model) + " is " +
                         (model.empty() ? "a lens model" : "a " + model + " lens") +
                         " that is not modelled; calibrate with k1, k2, p1, p2, k3 "
                         "(Brown–Conrady)");
  if (!d.empty() && d.size() < 4)
    throw InputError(camera.lensPath, "are fewer than k1, k2, p1, p2");
  if (hasMore)
    throw InputError(camera.lensPath,
                     "are more than k1, k2, p1, p2, k3; calibrate without the rational, thin prism "
                     "and tilted models");
  const auto at = [&d](std::size_t k) { return k < d.size() ? d[k] : 0.0; };
  const Json values{{"k1", at(0)}, {"k2", at(1)}, {"p1", at(2)}, {"p2", at(3)}, {"k3", at(4)}};
  Calibration calibration = camera.calibration;
  JsonReader reader(values,
                    camera.lensPath == "distortion_coefficients" ? "distortion" : camera.lensPath);
  describe(reader, calibration.distortion);
  return calibration;
}

}  // namespace hogelscope
