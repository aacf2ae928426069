// SPDX-License-Identifier: BSD-3-Clause
// Lens tables against cv::undistortPoints, whose five iterations are not exact.
#include <opencv2/calib3d.hpp>

#include "core/engine/plan.h"
#include "core/lens/lens_table.h"
#include "study/stability.h"
#include "tests/benchmark/scene.h"

namespace benchmarks {

using namespace hogelscope;

namespace {

LensKey lensKey() {
  CameraState state;
  state.distortion = {0.6, 0.3, 0.2, 0.01, 0.2};  // the paper's Fig. 3, OpenCV's order
  LensKey key = lensKeyOf(state, {});
  key.hasStrips = true;
  return key;
}

void lensTableOf(benchmark::State& state, const LensKey& key) {
  setThreads(0);
  for (auto _ : state) {
    const LensTable table(key, parallelRows);
    benchmark::DoNotOptimize(table.x(300, {}));
  }
}

void lensTable(benchmark::State& state) {
  lensTableOf(state, lensKey());
}

/// One of hardLenses(), calibrated by others, in a picture of 600×600.
void lensTableOfCamera(benchmark::State& state, const char* name) {
  const std::vector<NamedLens> lenses = hardLenses();
  const auto found = std::ranges::find(lenses, std::string(name), &NamedLens::name);
  if (found == lenses.end()) return state.SkipWithError("no such lens");
  LensKey key = found->key;
  key.focalLength = {key.focalLength.x * 600 / key.res[0], key.focalLength.y * 600 / key.res[1]};
  key.centre = {key.centre.x * 600 / key.res[0], key.centre.y * 600 / key.res[1]};
  key.res = {600, 600};
  key.hasStrips = true;
  lensTableOf(state, key);
}

/// Most of the pixels lie behind a fold, many on segments that graze it.
void lensTableBehindAFold(benchmark::State& state, const DistortionParams& lens, double focal) {
  LensKey key = lensKey();
  key.distortion = lens;
  key.focalLength = {focal, focal};
  for (auto _ : state) {
    const LensTable table(key, serialRows);
    benchmark::DoNotOptimize(table.x(300, {}));
  }
}

void lensTableOpenCv(benchmark::State& state) {
  const LensKey key = lensKey();
  const cv::Mat camera = (cv::Mat_<double>(3, 3) << key.focalLength.x, 0, key.centre.x, 0,
                          key.focalLength.y, key.centre.y, 0, 0, 1);
  const std::vector<double> coefficients = vectorOf(key.distortion);
  std::vector<cv::Point2d> points;
  for (int y = 0; y < 600; ++y)
    for (int x = 0; x < 600; ++x) points.emplace_back(x, y);
  std::vector<cv::Point2d> ideal;
  for (auto _ : state) {
    cv::undistortPoints(points, ideal, camera, coefficients);
    benchmark::DoNotOptimize(ideal.data());
  }
}

}  // namespace

void addLens() {
  add("limit/lens table, cv::undistortPoints", lensTableOpenCv);
  add("lens table", lensTable);
  for (const char* camera : {"Azure Kinect colour", "Azure Kinect depth", "OAK-D Lite colour",
                             "TUM VI cam0", "fisheye k1 0.1 to 85°"})
    add("lens table, " + std::string(camera), lensTableOfCamera, camera);
  add("lens table, behind a fold, one thread", lensTableBehindAFold,
      DistortionParams{-5.14195, -7.85298, 5.40661, -2.98797, -6.24715}, 300 / 6.68814);
  add("lens table, beside a fold, one thread", lensTableBehindAFold,
      DistortionParams{0.163024, 0.00769362, 0.00359861, -0.372889, 0.185056}, 300 / 5.18985);
  add("lens table, a long valley before the fold, one thread", lensTableBehindAFold,
      DistortionParams{6.76502362, -6.54678706, 0.0803365880, 1.35738813, 3.26393743}, 300 / 26.26);
  add("lens table, a near fold, one thread", lensTableBehindAFold,
      DistortionParams{-0.4138192309484881, 0.11117772827646458, 0.00040812941370169125,
                       -0.84255396964284013, 0.00071436773639603631},
      300 / 0.14980698065784556);
  add("lens table, radial fold, one thread", lensTableBehindAFold,
      DistortionParams{-3.62126, 7.51604, 0, 0, -6.00146}, 300 / 1.87501);
  add("lens table, nearly a double fold, one thread", lensTableBehindAFold,
      DistortionParams{-1.39245, 1.16184, 2.29921e-05, -7.071e-06, -0.384119}, 300 / 1.49088);
}

}  // namespace benchmarks
