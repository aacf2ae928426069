// SPDX-License-Identifier: BSD-3-Clause
#include "study/undistortion.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "core/engine/renderer.h"
#include "core/light_field/light_field.h"
#include "core/metrics/squared_error.h"

namespace hogelscope {

namespace {

/// Returns a light field whose colours change smoothly over the panel and not with the direction.
std::shared_ptr<const LightField> waves(const PanelParams& display) {
  const LightFieldSize size{display.hogels[0], display.hogels[1], 1, 1};
  const auto field = std::make_shared<LightField>(size, StoredType::uint8);
  const auto wave = [](double phase) { return std::uint8_t(127.5 + 100 * std::sin(phase)); };
  for (int j = 0; j < size.ny; ++j) {
    for (int i = 0; i < size.nx; ++i) {
      const double x = 50.0 * i / size.nx, y = 50.0 * j / size.ny;
      const std::array rgb{wave(x), wave(y), wave(x + y)};
      field->set({i, j, 0, 0}, rgb.data());
    }
  }
  return field;
}

/// Returns the view of the paper's figures with its Fig. 3 lens, its coefficients times `factor`.
RenderJob paperView(const std::shared_ptr<const LightField>& field, const PanelParams& display,
                    double factor, LensMapping mapping) {
  RenderJob job;
  job.lightField = field;
  job.display = display;
  job.sampling.mapping = mapping;
  job.state.camera.eye = {0, 0, 0.559};
  job.state.camera.fov = 60;
  job.state.camera.res = {600, 600};
  job.state.distortion = {factor * 0.6, factor * 0.3, factor * 0.2, factor * 0.01, factor * 0.2};
  return job;
}

void blacken(Image& image, const std::vector<std::uint8_t>& others) {
  for (std::size_t p = 0; p < image.pixelCount(); ++p)
    if (image.seen[p] == 0 || others[p] == 0)
      std::fill_n(image.rgb.begin() + std::ptrdiff_t(3 * p), 3, std::uint8_t{0});
}

}  // namespace

Image undistortedByOpenCv(const Image& distorted, const CameraState& state) {
  const Camera camera(state.camera, state.intrinsics);
  const auto [fx, fy] = camera.focalLength();
  const auto [cx, cy] = camera.centre();
  const cv::Matx33d matrix(fx, 0, cx, 0, fy, cy, 0, 0, 1);
  const std::vector<double> lens = vectorOf(state.distortion);
  Image result(distorted.width, distorted.height);
  const auto undistort = [&](const std::vector<std::uint8_t>& from, std::vector<std::uint8_t>& to,
                             int type) {
    // OpenCV takes its input as writable memory, and does not write to it.
    const cv::Mat in(distorted.height, distorted.width, type,
                     const_cast<std::uint8_t*>(from.data()));  // NOLINT(*-const-cast)
    cv::Mat out(distorted.height, distorted.width, type, to.data());
    if (state.distortion.model == DistortionModel::fisheye)
      cv::fisheye::undistortImage(in, out, matrix, lens, matrix);
    else
      cv::undistort(in, out, matrix, lens);
  };
  undistort(distorted.rgb, result.rgb, CV_8UC3);
  undistort(distorted.seen, result.seen, CV_8UC1);
  constexpr std::uint8_t whole = 255;
  for (std::uint8_t& seen : result.seen)
    if (seen != whole) seen = 0;
  return result;
}

Undistortion compareUndistortion(const Image& distorted, const Image& undistorted,
                                 const CameraState& state) {
  Undistortion result{undistortedByOpenCv(distorted, state), {}};
  const SquaredError error = squaredError(undistorted, result.openCvs);
  result.psnr = psnr(error.mseSeen);
  result.points = std::size_t(std::lround(error.seen * double(undistorted.pixelCount())));
  Image reference = undistorted, test = result.openCvs;
  blacken(reference, result.openCvs.seen);
  blacken(test, undistorted.seen);
  result.difference = differenceImage(reference, test);
  return result;
}

std::vector<InstabilityRow> undistortionErrors(const ParallelRows& parallelRows,
                                               const Progress& progress) {
  PanelParams display;
  display.size = {0.5, 0.5};
  display.hogels = {1024, 1024};
  display.directions = {1, 1};
  display.fov = {179, 179};
  const auto field = waves(display);
  Renderer renderer(parallelRows);
  std::vector<InstabilityRow> rows;
  for (const double factor : {1.0, 0.3, 0.1, 0.03, 0.01}) {
    for (const auto& [method, mapping] :
         {std::pair{"exact", LensMapping::exact}, std::pair{"direct", LensMapping::direct}}) {
      throwIfCancelled(progress);
      const RenderJob job = paperView(field, display, factor, mapping);
      RenderJob plain = job;
      plain.state.distortion = {};
      const Undistortion result =
          compareUndistortion(renderer.render(job), renderer.render(plain), job.state);
      rows.push_back({"undistortion", method, factor, {}, result.points, result.psnr});
    }
  }
  return rows;
}

}  // namespace hogelscope
