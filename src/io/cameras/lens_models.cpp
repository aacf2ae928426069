// SPDX-License-Identifier: BSD-3-Clause
// The lens models that files name, and what is modelled of them.
#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/cameras/camera_formats.h"

namespace hogelscope {

namespace {

// As distortionModelNames() has them.
constexpr const char* brownModel = "brown";
constexpr const char* rationalModel = "rational";
constexpr const char* fisheyeModel = "fisheye";

struct LensName {
  std::string_view plain;  ///< as plainKey() gives it
  const char* model;
};

/// The names of the models that OpenCV, ROS, Kalibr, COLMAP, nerfstudio and others write. Those of
/// a pinhole stand for Brown's model without coefficients.
constexpr LensName lensNames[]{{"", brownModel},
                               {"plumbbob", brownModel},
                               {"radtan", brownModel},
                               {"radialtangential", brownModel},
                               {"brown", brownModel},
                               {"brownconrady", brownModel},
                               {"opencv", brownModel},
                               {"standard", brownModel},
                               {"pinhole", brownModel},
                               {"simplepinhole", brownModel},
                               {"simpleradial", brownModel},
                               {"radial", brownModel},
                               {"perspective", brownModel},
                               {"none", brownModel},
                               {"pinholeradtan", brownModel},
                               {"pinholeradialtangential", brownModel},
                               {"radtan4", brownModel},
                               {"radtan5", brownModel},
                               {"radtan8", rationalModel},
                               {"rationalpolynomial", rationalModel},
                               {"rational", rationalModel},
                               {"fullopencv", rationalModel},
                               {"equidistant", fisheyeModel},
                               {"equi", fisheyeModel},
                               {"fisheye", fisheyeModel},
                               {"fisheye4", fisheyeModel},
                               {"kannalabrandt", fisheyeModel},
                               {"kannalabrandt4", fisheyeModel},
                               {"kannalabrandt8", fisheyeModel},
                               {"kb4", fisheyeModel},
                               {"kb8", fisheyeModel},
                               {"opencvfisheye", fisheyeModel}};

}  // namespace

std::string lensModelOf(const FileCamera& camera) {
  const auto* const found = std::ranges::find(lensNames, plainKey(camera.model), &LensName::plain);
  return found == std::end(lensNames) ? "" : found->model;
}

Calibration calibrationOf(const FileCamera& camera) {
  std::string model = lensModelOf(camera);
  std::vector<double> d = camera.coefficients;
  while (!d.empty() && d.back() == 0) d.pop_back();
  constexpr std::size_t ofBrown = 5;
  // OpenCV's own files name no model: a vector of 8, 12 or 14 begins with the rational one's.
  static constexpr std::array<std::size_t, 3> ofRational{8, 12, 14};
  const bool isOpenCvs = camera.model.empty() && camera.lensPath == "distortion_coefficients" &&
                         std::ranges::count(ofRational, camera.coefficients.size()) > 0;
  if (isOpenCvs && d.size() > ofBrown) model = rationalModel;
  const auto names = distortionModelNames();
  const auto found = std::ranges::find(names, model);
  if (found == names.end())
    throw InputError(camera.modelKey,
                     valueText(camera.model) + " is " +
                         (model.empty() ? "a lens model" : "a " + model + " lens") +
                         " that is not modelled; calibrate with k1, k2, p1, p2, k3 "
                         "(Brown–Conrady), the rational or the fisheye model");
  const auto own = coefficientsOf(DistortionModel(found - names.begin()));
  if (!camera.coefficients.empty() && camera.coefficients.size() < 4)
    throw InputError(camera.lensPath,
                     std::string("are fewer than ") +
                         (model == fisheyeModel ? "k1, k2, k3, k4" : "k1, k2, p1, p2"));
  if (d.size() > own.size())
    throw InputError(camera.lensPath,
                     "are more than the " + std::to_string(own.size()) + " of the " + model +
                         " model; calibrate without the thin prism and tilted models");
  Json values{{"model", model}};
  for (std::size_t k = 0; k < d.size(); ++k) values[own[k].name] = d[k];
  Calibration calibration = camera.calibration;
  JsonReader reader(values,
                    camera.lensPath == "distortion_coefficients" ? "distortion" : camera.lensPath);
  describe(reader, calibration.distortion);
  if (model == rationalModel && d.size() <= ofBrown)
    calibration.distortion.model = DistortionModel::brown;
  return calibration;
}

}  // namespace hogelscope
