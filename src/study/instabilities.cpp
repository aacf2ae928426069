// SPDX-License-Identifier: BSD-3-Clause
#include "study/instabilities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>

#include "core/engine/renderer.h"
#include "core/light_field/light_field.h"
#include "core/metrics/summary.h"
#include "core/optics/psf.h"
#include "study/single_precision.h"

namespace hogelscope {

namespace {

/// Returns the gain of a simulated white hogel with leakage.
double normalisedGain(const PsfParams& params) {
  constexpr int side = 32;
  constexpr std::uint8_t white = 255;
  const LightFieldSize size{1, 1, side, side};
  const LightField field(size, std::vector<std::uint8_t>(3 * size.width() * size.height(), white));
  return Psf(params).leaked(field, {0, 0, side / 2, side / 2}).g / white;
}

double paperGain(const PsfParams& params) {
  const int n = (params.windowSize - 1) / 2;
  const double variance = params.sigma * params.sigma;
  double axis = 0;  // the Gaussian is the product of both axes
  for (int x = -n; x <= n; ++x) axis += std::exp(-x * x / (2 * variance));
  return axis * axis / (2 * std::numbers::pi * variance);
}

/// Two images with a PSNR of 35.0 dB: `fives` values differ by 5, the others by 4.
struct NoisyPair {
  NoisyPair() : reference(64, 64), test(64, 64) {
    constexpr std::size_t fives = 6231;  // of 12288: MSE 20.563
    for (std::size_t k = 0; k < reference.rgb.size(); ++k) {
      reference.rgb[k] = std::uint8_t(20 + 37 * k % 200);
      test.rgb[k] = std::uint8_t(reference.rgb[k] + (k < fives ? 5 : 4));
    }
  }
  Image reference;
  Image test;
};

double openCvsPsnr(Image& a, Image& b) {
  return cv::PSNR(cv::Mat(a.height, a.width, CV_8UC3, a.rgb.data()),
                  cv::Mat(b.height, b.width, CV_8UC3, b.rgb.data()));
}

// Errors in the directional pixels that a view's rays meet, with an eye near the panel, grazing
// rays, or large coordinates.

constexpr double paperDistance = 0.559;

/// Returns the paper's panel with fewer hogels and lenses with an angular field of almost 180°.
PanelParams panel() {
  PanelParams display;
  display.size = {0.5, 0.5};
  display.hogels = {64, 64};
  display.directions = {64, 64};
  display.fov = {179.5, 179.5};
  display.lens = HogelLensModel::equiangular;
  return display;
}

/// Returns a light field that encodes each directional pixel's number as its colour. There are 2^24
/// of them, as many as colours; those of neighbours are far apart.
std::shared_ptr<const LightField> numbered(const PanelParams& display,
                                           const ParallelRows& parallelRows) {
  const LightFieldSize size{display.hogels[0], display.hogels[1], display.directions[0],
                            display.directions[1]};
  const auto field = std::make_shared<LightField>(size, StoredType::uint8);
  const auto columns = unsigned(size.width());
  parallelRows(int(size.height()), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (unsigned x = 0; x < columns; ++x) {
        // Odd factors exchange the numbers of 24 bits.
        const unsigned number = (unsigned(y) * columns + x) * 0x9e3779U;
        const std::array rgb{std::uint8_t(number >> 16), std::uint8_t(number >> 8),
                             std::uint8_t(number)};
        field->set({int(x) / size.du, y / size.dv, int(x) % size.du, y % size.dv}, rgb.data());
      }
    }
  });
  return field;
}

RenderJob viewFrom(const std::shared_ptr<const LightField>& field, const Vec3& eye) {
  RenderJob job;
  job.lightField = field;
  job.display = panel();
  job.state.camera.fov = 60;
  job.state.camera.eye = eye;
  job.state.camera.res = {600, 600};
  return job;
}

RenderJob moved(RenderJob job, const Vec3& by) {
  CameraParams& camera = job.state.camera;
  for (Vec3* point : {&job.display.position, &camera.eye, &camera.lookat}) *point = *point + by;
  return job;
}

RenderJob scaled(RenderJob job, double factor) {
  CameraParams& camera = job.state.camera;
  for (Vec3* point : {&job.display.position, &camera.eye, &camera.lookat}) *point = factor * *point;
  for (double& side : job.display.size) side *= factor;
  return job;
}

RenderJob eyeAside(RenderJob job) {
  job.state.camera.eye.x += 1e-5;
  return job;
}

/// Returns the share of the pixels, among those seen in either image, that show another directional
/// pixel than the reference or are seen in only one of the images.
InstabilityRow row(const char* kind, const std::string& method, double x, const Image& reference,
                   const Image& image) {
  std::size_t points = 0;
  std::size_t others = 0;
  for (std::size_t p = 0; p < reference.pixelCount(); ++p) {
    if (reference.seen[p] == 0 && image.seen[p] == 0) continue;
    ++points;
    const auto* a = &reference.rgb[3 * p];
    const auto* b = &image.rgb[3 * p];
    if (reference.seen[p] != image.seen[p] || !std::equal(a, a + 3, b)) ++others;
  }
  return {kind, method, x, {}, points, points == 0 ? 0 : double(others) / double(points)};
}

constexpr int pupilSamples = 16;

/// Returns a view of fewer pixels through a pupil.
RenderJob throughPupil(RenderJob job, double diameter, double focus) {
  job.state.camera.res = {150, 150};
  job.state.pupil = {diameter, focus, pupilSamples};
  return job;
}

/// Returns the share of the pixels with light that differ: sums are rounded, so by more than 1.
InstabilityRow pupilRow(const char* kind, const std::string& method, double x,
                        const Image& reference, const Image& image) {
  std::size_t points = 0;
  std::size_t others = 0;
  for (std::size_t p = 0; p < reference.pixelCount(); ++p) {
    const auto* a = &reference.rgb[3 * p];
    const auto* b = &image.rgb[3 * p];
    const auto isLit = [](const std::uint8_t* rgb) { return (rgb[0] | rgb[1] | rgb[2]) != 0; };
    if (!isLit(a) && !isLit(b)) continue;
    ++points;
    const bool isNear =
        std::equal(a, a + 3, b, [](int one, int other) { return std::abs(one - other) <= 1; });
    if (reference.seen[p] != image.seen[p] || !isNear) ++others;
  }
  return {kind,   method,
          x,      double(pupilSamples),
          points, points == 0 ? 0 : double(others) / double(points)};
}

void addPupil(const char* kind, double x, const RenderJob& job, const Progress& progress,
              std::vector<InstabilityRow>& rows) {
  throwIfCancelled(progress);
  const Image reference = simulate(job);
  rows.push_back(pupilRow(kind, "fast engine", x, reference, Renderer(serialRows).render(job)));
  throwIfCancelled(progress);
  rows.push_back(pupilRow(kind, "eye 10 um aside", x, reference, simulate(eyeAside(job))));
}

void addEye(const char* kind, double x, const RenderJob& job, const Progress& progress,
            std::vector<InstabilityRow>& rows) {
  throwIfCancelled(progress);
  const Image reference = simulate(job);
  throwIfCancelled(progress);
  rows.push_back(row(kind, "fast engine", x, reference, Renderer(serialRows).render(job)));
  rows.push_back(row(kind, "float", x, reference, pictureIn<float>(job)));
  throwIfCancelled(progress);
  rows.push_back(row(kind, "eye 10 um aside", x, reference, simulate(eyeAside(job))));
}

}  // namespace

std::vector<InstabilityRow> psfGains() {
  std::vector<InstabilityRow> rows;
  for (const double sigma : {0.1, 0.2, 0.3, 0.408, 0.5, 0.67, 0.946, 1.25, 1.5, 2.0, 3.0, 5.0}) {
    for (const int window : {1, 3, 5, 7, 9, 15, 31}) {
      const PsfParams params{sigma, window, PsfBorder::renormalise, LightModel::encoded};
      rows.push_back({"psf_gain", "normalised", sigma, window, {}, normalisedGain(params)});
      rows.push_back({"psf_gain", "paper eq. 5", sigma, window, {}, paperGain(params)});
    }
  }
  return rows;
}

std::vector<InstabilityRow> psnrMeans() {
  constexpr int views = 6;  // as in the paper's Table I
  NoisyPair pair;
  std::vector<InstabilityRow> rows;
  for (int identical = 0; identical < views; ++identical) {
    const MetricSet metrics;
    std::vector<ReportRow> report;
    double openCv = 0;
    for (int view = 0; view < views; ++view) {
      Image& test = view < identical ? pair.reference : pair.test;
      openCv += openCvsPsnr(pair.reference, test) / views;
      report.push_back({"", "", metrics.compare(pair.reference, test), {}});
    }
    const ReportSummary summary = summariseRows(report, metrics);
    const auto add = [&](const char* method, double value) {
      rows.push_back({"psnr_mean", method, double(views), double(identical), {}, value});
    };
    add("mean of cv::PSNR", openCv);
    add("mean of finite", summary.means[meanPsnr]);
    add("of mean MSE", summary.means[psnrOfMeanMse]);
  }
  return rows;
}

std::vector<InstabilityRow> viewErrors(const ParallelRows& parallelRows, const Progress& progress) {
  const auto field = numbered(panel(), parallelRows);
  const RenderJob paper = viewFrom(field, {0, 0, paperDistance});
  const Image unmoved = simulate(paper);
  std::vector<InstabilityRow> rows;
  for (const double distance : {1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    addEye("near_panel", distance, viewFrom(field, {0, 0, distance}), part(progress, 0.4, 0.4),
           rows);
  }
  for (const double angle : {0.0, 30.0, 60.0, 75.0, 80.0, 85.0, 87.0, 88.0, 89.0, 89.5}) {
    const Vec3 eye{paperDistance * std::sin(radians(angle)), 0,
                   paperDistance * std::cos(radians(angle))};
    addEye("grazing", angle, viewFrom(field, eye), part(progress, 0.6, 0.6), rows);
  }
  for (int power = -3; power <= 6; ++power) {
    const double metres = std::stod("1e" + std::to_string(power));  // as read from a file
    for (const auto& [kind, job] : {std::pair{"scale", scaled(paper, metres)},
                                    std::pair{"origin", moved(paper, {metres, metres, metres})}}) {
      reportProgress(progress, 0.8);
      rows.push_back(row(kind, "fast engine", metres, unmoved, Renderer(serialRows).render(job)));
      rows.push_back(row(kind, "float", metres, unmoved, pictureIn<float>(job)));
    }
  }
  for (const double focus : {10.0, 1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-9})
    addPupil("pupil_focus", focus, throughPupil(paper, 0.004, focus), part(progress, 0.9, 0.9),
             rows);
  for (const double diameter : {1e-4, 1e-3, 4e-3, 1e-2, 0.1, 0.5, 1.0})
    addPupil("pupil_width", diameter, throughPupil(paper, diameter, 0), part(progress, 0.9, 0.9),
             rows);
  return rows;
}

std::vector<InstabilityRow> measureInstabilities(const ParallelRows& parallelRows,
                                                 const Progress& progress) {
  std::vector<InstabilityRow> all = psfGains();
  for (const auto& rows : {psnrMeans(), viewErrors(parallelRows, progress)})
    all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

}  // namespace hogelscope
