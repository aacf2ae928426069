// SPDX-License-Identifier: BSD-3-Clause
#include "measure/bench.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "core/base/error.h"
#include "core/content/live_source.h"
#include "core/light_field/light_field.h"
#include "core/panel/design_numbers.h"

namespace hogelscope {

namespace {

/// Test light as the content of a live scene, at the panel.
class TestContent : public plugin::ContentSource {
 public:
  explicit TestContent(const TestLight& light) : m_light(light) {}

  void describe(ParameterVisitor& /*v*/) override {}
  void open(const plugin::Panel& /*panel*/, const plugin::Place& /*place*/,
            const plugin::Progress& /*progress*/) override {}
  void depths(double& back, double& front) const override { back = front = 0; }
  void trace(std::span<const plugin::Ray> rays, std::span<plugin::Colour> colours) const override {
    for (std::size_t k = 0; k < rays.size(); ++k) {
      const auto [red, green, blue] = m_light(rays[k]);
      colours[k] = {float(red), float(green), float(blue)};
    }
  }

 private:
  const TestLight& m_light;
};

/// Test light as a quilt's views have it, woven for a lens sheet: the light of the rays from a
/// pixel's middle to the cameras of the views that its sub-pixels show.
class WovenContent : public LightFieldSource {
 public:
  WovenContent(const TestLight& light, const PanelParams& display)
      : m_light(light), m_display(display), m_sheet(*display.sheet) {}

  [[nodiscard]] LightFieldSize size() const override {
    return {m_display.hogels[0], m_display.hogels[1], 1, 1};
  }
  [[nodiscard]] StoredType type() const override { return StoredType::real; }
  [[nodiscard]] std::shared_ptr<const LightField> slice(
      const ViewReads& reads, const Progress& /*progress*/) const override {
    const Footprint footprint = reads.footprint();
    auto texels = std::make_shared<LightField>(size(), type(), sliceLayout(footprint));
    const SliceLayout& layout = *texels->sliceLayout();
    std::vector<std::uint8_t> marks(layout.texels, 1);
    if (reads.mark) {
      std::ranges::fill(marks, std::uint8_t{0});
      reads.mark(layout, marks);
    }
    std::vector<int> columns;
    for (int i = 0; i < m_display.hogels[0]; ++i)
      if (!footprint.u[std::size_t(i)].isEmpty()) columns.push_back(i);
    for (int j = 0; j < m_display.hogels[1]; ++j) {
      if (footprint.v[std::size_t(j)].isEmpty()) continue;
      const std::uint32_t row = layout.rowStart[std::size_t(j)];
      for (const int i : columns)
        if (const std::uint32_t at = row + layout.columnStart[std::size_t(i)]; marks[at] != 0)
          texels->setAddress(at, lightAt(i, j).data());
    }
    return texels;
  }
  [[nodiscard]] std::shared_ptr<const LightField> overview() const override {
    throw std::logic_error("WovenContent: has no overview");
  }

 private:
  [[nodiscard]] std::array<float, 3> lightAt(int column, int row) const {
    const double x = (column + 0.5) * m_sheet.pixel() - m_sheet.size()[0] / 2;
    const double y = m_sheet.size()[1] / 2 - (row + 0.5) * m_sheet.pixel();
    const int views = m_display.directions[0];
    const double distance = m_display.sheet->viewingDistance;
    std::array<float, 3> colour{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const int view = m_sheet.viewOf(column, row, channel, views);
      const double camera =
          ((view + 0.5) / views - 0.5) * distance * m_sheet.period() / m_sheet.gap();
      const plugin::Ray ray{x, y, 0, (camera - x) / distance, -y / distance, 0};
      colour[channel] = float(m_light(ray)[channel] / 255);
    }
    return colour;
  }

  const TestLight& m_light;
  const PanelParams& m_display;
  LensSheet m_sheet;
};

PanelParams onBench(PanelParams display) {
  display.position = display.orientation = {};
  return display;
}

/// Returns what the engine knows of a display: of a lens sheet's panel, one direction.
PanelParams shownBy(PanelParams display) {
  if (!hasDirections(display)) display.directions = {1, 1};
  return display;
}

}  // namespace

Bench::Bench(const PanelParams& display, const CameraState& state, std::shared_ptr<const Twin> twin)
    : m_display(onBench(display)),
      m_twin(std::move(twin)),
      m_law(m_twin ? unitLawOf(m_twin->params()) : UnitLaw()),
      m_panel(shownBy(m_display), m_twin),
      m_eye(Display(display).displayFromWorld().point(state.camera.eye)),
      m_psf(state.psf),
      m_pupil(state.pupil) {
  if (!(m_eye.z > 0)) throw InputError(state.camera.name, "its eye is not in front of the panel");
  if (m_display.sheet) {
    m_pitches = {sheet()->period(), sheet()->pixel()};
    m_steps = {numbersOfSheet().slopeSpread, 0};
    return;
  }
  const DesignNumbers numbers = designNumbers(m_display, m_eye);
  m_pitches = numbers.hogelPitch;
  m_steps = numbers.slopeStep;
}

Bench Bench::withoutBlur() const {
  Bench plain = *this;
  plain.m_psf = {};
  if (m_twin) plain.m_psf.light = m_psf.light;  // that a unit which adds light needs
  plain.m_pupil = {};
  return plain;
}

bool Bench::isLinear(std::size_t axis) const {
  return m_panel.lens(axis).isLinear();
}

double Bench::directionOf(const plugin::Ray& ray, std::size_t axis) const {
  const Vec2 place = pointOf(ray, 0);
  const Vec2 turn = m_panel.turn(place);
  const double slope = axis == 0 ? ray.a + turn.x : -(ray.b + turn.y);
  return (0.5 + m_panel.lens(axis).directionOf(slope)) * m_display.directions[axis];
}

double Bench::middleHogel(std::size_t axis) const {
  const int middle = m_display.hogels[axis] / 2;
  const Vec2 place = m_panel.position(middle + 0.5, middle + 0.5);
  return axis == 0 ? place.x : place.y;
}

double Bench::eyePlaceFor(double direction, double place, std::size_t axis) const {
  const Vec2 slopes = m_panel.slopes(direction, direction);
  const Vec2 turn = m_panel.turn({place, place});
  return place + distance() * (axis == 0 ? slopes.x - turn.x : slopes.y - turn.y);
}

std::vector<BenchPoint> Bench::look(const TestLight& light, const Vec3& eye, std::size_t axis,
                                    double from, double to, int count, double across) {
  RenderJob job;
  if (m_display.sheet)
    job.lightField = std::make_shared<WovenContent>(light, m_display);
  else
    job.lightField = std::make_shared<LiveSource>(
        std::make_shared<TestContent>(light), m_display, LiveParams(), StoredType::real,
        std::numeric_limits<std::size_t>::max(), serialRows);
  job.display = shownBy(m_display);
  job.twin = m_twin;
  CameraState& state = job.state;
  state.psf = m_psf;
  state.pupil = m_pupil;
  state.camera.eye = eye;
  state.camera.lookat = {eye.x, eye.y, 0};
  state.camera.res[axis] = count;
  state.camera.res[1 - axis] = 1;
  // The camera looks straight at the panel's plane, its image is the line. Rows of images go down.
  const double width = (to - from) / count;
  const double focal = eye.z / width;
  const double first = (axis == 0 ? from + width / 2 - eye.x : eye.y - to + width / 2) / width;
  const double other = (axis == 0 ? eye.y - across : across - eye.x) / width;
  state.intrinsics = {focal, focal, axis == 0 ? -first : -other, axis == 0 ? -other : -first};
  const FloatImage image = m_renderer.renderFloat(job);
  std::vector<BenchPoint> points;
  for (int k = 0; k < count; ++k) {
    const auto pixel = std::size_t(axis == 0 ? k : count - 1 - k);
    if (image.seen[pixel] == 0) continue;
    BenchPoint point;
    point.place = from + (k + 0.5) * width;
    std::copy_n(&image.rgb[3 * pixel], 3, point.values.begin());
    const Vec3 target = axis == 0 ? Vec3{point.place, across, 0} : Vec3{across, point.place, 0};
    const auto hit = m_panel.intersectPlane(eye, target - eye);
    if (hit) point.direction = axis == 0 ? hit->u : hit->v;
    points.push_back(point);
  }
  return points;
}

CodeValues Bench::lookAt(const TestLight& light, const Vec3& eye, const Vec2& point) {
  const double half = 1e-4 * pitch(0);
  const auto points = look(light, eye, 0, point.x - half, point.x + half, 1, point.y);
  return points.empty() ? grey(std::numeric_limits<double>::quiet_NaN()) : points[0].values;
}

namespace {

constexpr double middleLight = 0.5, linearWave = 0.4;  // of linear light
constexpr double middleCode = 127.5, codeWave = 4;     // code values

}  // namespace

double Bench::codeOf(double wave) const {
  return sumsLinear() ? encodedFromLinear(middleLight + linearWave * wave)
                      : middleCode + codeWave * wave;
}

double Bench::waveOf(double code) const {
  return sumsLinear() ? (linearFromEncoded(code) - middleLight) / linearWave
                      : (code - middleCode) / codeWave;
}

std::vector<double> Bench::weights() const {
  std::vector<double> weights = m_psf.windowSize > 1
                                    ? gaussianWeights(m_psf.sigma, m_psf.windowSize / 2)
                                    : std::vector<double>{1};
  double sum = 0;
  for (const double weight : weights) sum += weight;
  for (double& weight : weights) weight /= sum;
  return weights;
}

MeterAperture::MeterAperture(Bench& bench) : m_bench(bench), m_own(bench.pupil()) {
  constexpr double halfDegree = std::numbers::pi / 360;
  PupilParams narrow = m_own;
  narrow.diameter = std::min(narrow.diameter, 2 * bench.distance() * std::tan(halfDegree));
  m_bench.setPupil(narrow);
}

}  // namespace hogelscope
