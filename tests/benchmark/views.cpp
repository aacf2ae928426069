// SPDX-License-Identifier: BSD-3-Clause
// How fast views are, against limits measured in the same run. `limit/…` reads the same texels from
// addresses worked out before.
#include <opencv2/imgproc.hpp>
#include <random>

#include "core/base/multiversioned.h"
#include "core/base/parallel.h"
#include "core/content/capture_content.h"
#include "core/engine/fast_simulation.h"
#include "core/metrics/panel_error.h"
#include "core/optics/stereo_image.h"
#include "core/panel/twin.h"
#include "tests/benchmark/scene.h"

namespace benchmarks {

using namespace hogelscope;

namespace {

RenderJob plain(int pose) {
  return viewOf(pose);
}

RenderJob large(int pose) {
  RenderJob job = viewOf(pose);
  job.state.camera.res = {3840, 2160};
  return job;
}

RenderJob distorted(int pose) {
  RenderJob job = viewOf(pose);
  job.state.distortion = {0.6, 0.3, 0.2, 0.01, 0.2};  // the paper's Fig. 3, OpenCV's order
  return job;
}

/// Through the lens of TUM VI's cam0.
RenderJob distortedByAFisheye(int pose) {
  RenderJob job = viewOf(pose);
  job.state.distortion = {0.0034823894,
                          0.0007150348,
                          0,
                          0,
                          -0.0020532361,
                          0.00020293673,
                          0,
                          0,
                          DistortionModel::fisheye};
  return job;
}

/// Through the lens of an Azure Kinect's colour camera.
RenderJob distortedByARationalLens(int pose) {
  RenderJob job = viewOf(pose);
  job.state.distortion = {0.722746,  -2.88559, 0.000783,
                          -0.000143, 1.632723, 0.602199,
                          -2.719626, 1.565053, DistortionModel::rational};
  return job;
}

RenderJob leaking(int pose, double sigma, int windowSize) {
  RenderJob job = viewOf(pose);
  job.state.psf = {sigma, windowSize};
  return job;
}
RenderJob leaking5(int pose) {
  return leaking(pose, 0.67, 5);
}
RenderJob leaking7(int pose) {
  return leaking(pose, 0.946, 7);
}

/// Samples of a pupil of 4 mm that focuses on the panel.
template <int samples>
RenderJob through(int pose) {
  RenderJob job = viewOf(pose);
  job.state.pupil = {0.004, 0, samples};
  return job;
}
RenderJob through16Distorted(int pose) {
  RenderJob job = distorted(pose);
  job.state.pupil = {0.004, 0, 16};
  return job;
}
RenderJob leaking5Through64(int pose) {
  RenderJob job = leaking5(pose);
  job.state.pupil = {0.004, 0, 64};
  return job;
}
/// The same, focused 0.2 m behind the panel.
RenderJob behindThrough64(int pose) {
  RenderJob job = through<64>(pose);
  job.state.pupil.focus = axisDistance(job.state.camera, job.display) + 0.2;
  return job;
}

RenderJob quadrilinear(int pose) {
  RenderJob job = viewOf(pose);
  job.sampling.reconstruction = Reconstruction::quadrilinear;
  return job;
}

class Silent : public plugin::Progress {
 public:
  [[nodiscard]] bool go(double) const override { return true; }
};

/// The same light field as a scene, on a display of other hogels and directions: each texel that a
/// view reads is interpolated between 16 of the capture.
RenderJob ofACapture(int pose) {
  RenderJob job = viewOf(pose);
  PanelParams other = job.display;
  for (auto* counts : {&other.hogels, &other.directions})
    for (int& count : *counts) count = 3 * count / 4;
  static std::shared_ptr<const LightFieldSource> source;
  if (source == nullptr) {
    auto content = std::make_shared<CaptureContent>();
    // Not owned: another block's light field takes the memory of this one.
    content->take({job.lightField.get(), [](const LightFieldSource*) {}}, job.display, {});
    content->open({}, {".", 1}, Silent());
    source = std::make_shared<const LiveSource>(content, other, LiveParams(), StoredType::uint8,
                                                std::size_t{1} << 32);
  }
  job.lightField = source;
  job.display = other;
  return job;
}

enum class Unit { zero, affine, hogels, directions };

/// A unit as it was built; each is made once.
std::shared_ptr<const Twin> unitOf(Unit unit) {
  static std::array<std::shared_ptr<const Twin>, 4> known;
  auto& twin = known[std::size_t(unit)];
  if (twin) return twin;
  TwinParams params;
  TwinMaps maps;
  if (unit != Unit::zero) {
    params.lensArray.rotation = 0.02;
    params.lensArray.offset = {1e-5, 0};
    params.lensArray.gapError = 0.01;
  }
  if (unit == Unit::hogels) params.random.shift.sigma = 3e-6;
  if (unit == Unit::directions) {
    maps.moveU = maps.moveV = {directions, directions, {}};
    for (int k = 0; k < directions * directions; ++k) {
      maps.moveU.values.push_back(0.1F * std::sin(0.3F * float(k % directions)));
      maps.moveV.values.push_back(0.1F * std::cos(0.2F * float(k / directions)));
    }
  }
  return twin = std::make_shared<const Twin>(params, maps, viewOf(0).display);
}

template <Unit unit>
RenderJob built(int pose) {
  RenderJob job = viewOf(pose);
  job.twin = unitOf(unit);
  return job;
}

/// A lens sheet of 3840×2160 pixels, of one kind or of two, with noise on its panel; it fills as
/// much of the view as the paper's display does.
template <bool isDelta>
RenderJob throughSheet(int pose) {
  RenderJob job = viewOf(pose);
  SheetDisplay sheet;
  sheet.calibration.params = {44.75, -6.87, 0.17, 283 * 0.3447 / 0.5, {3840, 2160}, 50};
  if (isDelta) {
    sheet.calibration.cells = {{{{-0.31, 0.25}, {0.28, 0.25}, {0, -0.25}}},
                               {{{-0.31, -0.25}, {0.28, -0.25}, {0, 0.25}}}};
    sheet.calibration.pattern = 2;
  }
  static const auto panel = [] {
    std::vector<std::uint8_t> values(std::size_t(3) * 3840 * 2160);
    std::mt19937 random(1);
    for (std::uint8_t& value : values) value = std::uint8_t(random());
    return std::make_shared<const LightField>(LightFieldSize{3840, 2160, 1, 1}, values);
  }();
  job.lightField = panel;
  job.display.size = LensSheet(sheet).size();
  job.display.sheet = sheet;
  job.display.hogels = {3840, 2160};
  job.display.directions = {1, 1};
  return job;
}

/// Addresses of every tap of every pixel of all poses, tap by tap within a row.
struct Reads {
  int taps = 0;
  std::vector<std::uint32_t> address;  ///< pose, row, tap, column
  [[nodiscard]] const std::uint32_t* of(int pose, int y, int tap) const {
    return &address[((std::size_t(pose) * 600 + std::size_t(y)) * std::size_t(taps) +
                     std::size_t(tap)) *
                    600];
  }
};

/// The texels that a view reads: `across`×`across` directions and `hogelsToo`² hogels round each
/// hit.
Reads readsOf(RenderJob (*make)(int), int across, int hogelsAcross, int poseCount) {
  Reads reads{across * across * hogelsAcross * hogelsAcross, {}};
  reads.address.resize(std::size_t(poseCount) * 600 * 600 * std::size_t(reads.taps));
  const BlockLayout& layout = lightField()->layout();
  parallelRows(poseCount, [&](int begin, int end) {
    for (int pose = begin; pose < end; ++pose) {
      const RenderJob job = make(pose);
      const Display display(job.display);
      const Camera camera(job.state.camera);
      const Distortion lens(job.state.distortion);
      const RigidTransform& world = camera.worldFromCamera();
      const Vec3 eye = display.displayFromWorld().point(world.origin);
      for (int y = 0; y < 600; ++y)
        for (int x = 0; x < 600; ++x) {
          const auto p = lens.undistort(camera.normalised(x, y));
          const auto hit =
              p ? display.hit(
                      eye, display.displayFromWorld().direction(world.direction({p->x, p->y, 1})))
                : std::nullopt;
          for (int t = 0; t < reads.taps; ++t) {
            std::uint32_t& address =
                reads
                    .address[((std::size_t(pose) * 600 + std::size_t(y)) * std::size_t(reads.taps) +
                              std::size_t(t)) *
                                 600 +
                             std::size_t(x)];
            address = layout.texels;
            if (!hit) continue;
            const auto at = [](double index, int step, int count) {
              return std::clamp(int(index) + step, 0, count - 1);
            };
            const int half = across / 2;
            const int hogel = t / (across * across);
            address = layout.address({at(hit->i, hogel % hogelsAcross, hogels),
                                      at(hit->j, hogel / hogelsAcross, hogels),
                                      at(hit->u, t % across - half, directions),
                                      at(hit->v, t / across % across - half, directions)});
          }
        }
    }
  });
  return reads;
}

MULTIVERSIONED
void addWords(const std::uint32_t* texels, const std::uint32_t* address, int count,
              std::uint32_t* redBlue, std::uint32_t* green) {
  for (int k = 0; k < count; ++k) {
    const std::uint32_t word = texels[address[k]];
    redBlue[k] += word & 0xff00ffU;
    green[k] += word >> 8U & 0xffU;
  }
}

MULTIVERSIONED
void loadWords(const std::uint32_t* texels, const std::uint32_t* address, int count,
               std::uint32_t* out) {
  for (int k = 0; k < count; ++k) out[k] = texels[address[k]];
}

void limit(benchmark::State& state, RenderJob (*make)(int), int across, int hogelsAcross) {
  setThreads(0);
  const int poseCount = across * hogelsAcross > 1 ? 16 : poses;
  const Reads reads = readsOf(make, across, hogelsAcross, poseCount);
  const auto* texels = reinterpret_cast<const std::uint32_t*>(
      std::get<TexelArray<std::uint8_t>>(lightField()->texels()).data());
  int pose = 0;
  for (auto _ : state) {
    parallelRows(600, [&](int begin, int end) {
      std::array<std::uint32_t, 600> redBlue;
      std::array<std::uint32_t, 600> green;
      for (int y = begin; y < end; ++y) {
        if (reads.taps == 1) {
          loadWords(texels, reads.of(pose, y, 0), 600, redBlue.data());
        } else {
          redBlue.fill(0);
          green.fill(0);
          for (int t = 0; t < reads.taps; ++t)
            addWords(texels, reads.of(pose, y, t), 600, redBlue.data(), green.data());
          benchmark::DoNotOptimize(green.data());
        }
        benchmark::DoNotOptimize(redBlue.data());
        benchmark::ClobberMemory();
      }
    });
    pose = (pose + 1) % poseCount;
  }
  countViews(state);
}

/// What a view costs beside its pixels: 16×16 of them, on one thread, the eye moving.
void smallViews(benchmark::State& state, RenderJob (*make)(int)) {
  constexpr int side = 16;
  LensTables tables;
  Image image(side, side);
  std::vector<RenderJob> views;
  for (int pose = 0; pose < poses; ++pose) {
    views.push_back(make(pose));
    views.back().state.camera.res = {side, side};
  }
  std::size_t pose = 0;
  for (auto _ : state) {
    const FastSimulation simulation(views[pose++ % views.size()], tables, serialRows);
    simulation.rows(0, side, 0, side, image.rgb.data(), image.seen.data());
    benchmark::DoNotOptimize(image.rgb.data());
  }
  state.counters["views/s"] =
      benchmark::Counter(double(state.iterations()), benchmark::Counter::kIsRate);
}

/// The reference loop, one thread.
void reference(benchmark::State& state) {
  int pose = 0;
  for (auto _ : state) benchmark::DoNotOptimize(simulate(plain(pose++ % poses)).rgb.data());
  countViews(state);
}

/// Joins two views for red and cyan glasses.
void anaglyphs(benchmark::State& state) {
  setThreads(0);
  const Image left = simulate(plain(0));
  const Image right = simulate(plain(1));
  for (auto _ : state)
    benchmark::DoNotOptimize(stereoImage(left, right, StereoMode::anaglyph).rgb.data());
  countViews(state);
}

/// What a report adds to each view: its error thrown back onto the panel.
void panelError(benchmark::State& state, RenderJob (*make)(int)) {
  setThreads(0);
  Image reference(600, 600);
  std::fill(reference.seen.begin(), reference.seen.end(), std::uint8_t{255});
  Image test = reference;
  std::fill(test.rgb.begin(), test.rgb.end(), std::uint8_t{3});
  LensTables tables;
  PanelError error(lightField()->size());
  int pose = 0;
  for (auto _ : state) error.add(make(pose++ % poses), tables, parallelRows, reference, test);
  countViews(state);
}

/// cv::remap with ready maps, on a hogel image small enough for it (32767 columns).
void remapOpenCv(benchmark::State& state) {
  const cv::Mat source(8192, 8192, CV_8UC3, cv::Scalar(1, 2, 3));
  cv::Mat x(600, 600, CV_32F);
  cv::Mat y(600, 600, CV_32F);
  for (int row = 0; row < 600; ++row)
    for (int column = 0; column < 600; ++column) {
      x.at<float>(row, column) = float(column * 13 + (column * 31 + row * 7) % 13);
      y.at<float>(row, column) = float(row * 13 + (row * 31 + column * 7) % 13);
    }
  cv::Mat out;
  for (auto _ : state) {
    cv::remap(source, out, x, y, cv::INTER_NEAREST);
    benchmark::DoNotOptimize(out.data);
  }
  countViews(state);
}

}  // namespace

void addViews() {
  add("limit/nearest", limit, plain, 1, 1);
  add("view/nearest", timeViews, plain, 0);
  add("view/nearest of 3840x2160", timeViews, large, 0);
  add("view/nearest, twin without errors", timeViews, built<Unit::zero>, 0);
  add("view/nearest, twin: lens array", timeViews, built<Unit::affine>, 0);
  add("view/nearest, twin: hogels", timeViews, built<Unit::hogels>, 0);
  add("view/nearest, twin: directions", timeViews, built<Unit::directions>, 0);
  add("view/nearest, lens sheet of stripes", timeViews, throughSheet<false>, 0);
  add("view/nearest, lens sheet of delta cells", timeViews, throughSheet<true>, 0);
  add("limit/nearest distorted", limit, distorted, 1, 1);
  add("view/nearest distorted", timeViews, distorted, 0);
  add("view/nearest distorted, fisheye", timeViews, distortedByAFisheye, 0);
  add("view/nearest distorted, rational", timeViews, distortedByARationalLens, 0);
  add("limit/psf 5x5", limit, plain, 5, 1);
  add("view/psf 5x5", timeViews, leaking5, 0);
  add("limit/psf 7x7", limit, plain, 7, 1);
  add("view/psf 7x7", timeViews, leaking7, 0);
  add("limit/quadrilinear", limit, plain, 2, 2);
  add("view/quadrilinear", timeViews, quadrilinear, 0);
  add("view/quadrilinear, of a capture", timeViews, ofACapture, 0);
  add("view/pupil 16", timeViews, through<16>, 0);
  add("view/pupil 16 distorted", timeViews, through16Distorted, 0);
  add("view/pupil 64", timeViews, through<64>, 0);
  add("view/pupil 64, focus behind", timeViews, behindThrough64, 0);
  add("view/pupil 64, psf 5x5", timeViews, leaking5Through64, 0);
  add("16x16 px/nearest", smallViews, plain);
  add("16x16 px/nearest distorted", smallViews, distorted);
  add("16x16 px/psf 5x5", smallViews, leaking5);
  add("picture/anaglyph of two views", anaglyphs);
  add("panel error/plain lens", panelError, plain);
  add("panel error/distorted", panelError, distorted);
  add("reference/nearest one thread", reference);
  add("peer/cv::remap nearest, 8192x8192", remapOpenCv);
}

void addOneThread() {
  add("view/nearest one thread", timeViews, plain, 1);
  add("view/psf 5x5 one thread", timeViews, leaking5, 1);
}

}  // namespace benchmarks
