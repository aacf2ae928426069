// SPDX-License-Identifier: BSD-3-Clause
// What a unit is: its lens array, the errors of its hogels, what is drawn.
#include "core/panel/twin.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/panel/random_field.h"

namespace hogelscope {

namespace {

/// The draws of a seed.
enum Draw : std::uint32_t { drawnShiftX, drawnShiftY, drawnGain };

}  // namespace

Twin::Twin(TwinParams params, TwinMaps maps, const PanelParams& design, const Progress& progress)
    : m_params(std::move(params)),
      m_maps(std::move(maps)),
      m_design(design),
      m_size{design.hogels[0], design.hogels[1], design.directions[0], design.directions[1]},
      m_lenses{lensOf(design, 0), lensOf(design, 1)} {
  prepareArray();
  prepareHogels(progress);
  if (hasDead()) prepareDead();
  checkKernels();
  checkDirections();
  prepareKernels();
  const std::array<double, 3>& scale = m_params.colour.scale;
  m_traits.movesRays = m_params.lensArray != LensArrayErrors{} || !m_hogels.empty() ||
                       scale != ColourErrors{}.scale || !m_maps.height.isEmpty() ||
                       movesDirections();
  m_traits.splitsColours = scale[0] != scale[1] || scale[1] != scale[2];
  const auto& [black, ambient, falloff, bits, eotf, fill] = m_params.light;
  const LightErrors none;
  m_traits.changesLight = black != none.black || ambient != none.ambient ||
                          falloff != none.falloff || fill != none.fill || !m_gains.empty() ||
                          std::ranges::any_of(m_maps.directionGain, [](const TwinPlane& gain) {
                            return !gain.isEmpty();
                          });
  m_traits.drivesTexels = drivesTexels() || hasDead();
  m_traits.needsLinearLight = m_traits.changesLight || drivesTexels();
  m_traits.hasUnlikeHogels = !m_hogels.empty() || hasDead();
}

void Twin::complete(PanelMap& map) const {
  if (m_traits.movesRays && isAffine()) map.affine = affineHits(map.eye);
}

void Twin::checkContent(const LightFieldSize& size) const {
  if (m_size != size) throw InputError("twin", "is of a display with other hogels or directions");
}

void Twin::prepareArray() {
  const LensArrayErrors& errors = m_params.lensArray;
  const auto& [width, height] = m_design.size;
  const auto [nx, ny] = m_design.hogels;
  const std::array pitch{width / nx, height / ny};
  const double cosine = std::cos(radians(errors.rotation));
  const double sine = std::sin(radians(errors.rotation));
  const double ex = errors.pitchError[0];
  const double ey = errors.pitchError[1];
  // The array's place of a place of the design, and the inverse.
  const auto moved = [&](double x, double y) {
    return std::array{cosine * (1 + ex) * x - sine * (1 + ey) * y,
                      sine * (1 + ex) * x + cosine * (1 + ey) * y};
  };
  const auto movedBack = [&](double x, double y) {
    return std::array{(cosine * x + sine * y) / (1 + ex), (cosine * y - sine * x) / (1 + ey)};
  };
  const auto cells = [&](const std::array<double, 2>& place) {
    return std::array{place[0] / pitch[0], -place[1] / pitch[1]};
  };
  const auto [left, up] = cells(movedBack(errors.offset[0], errors.offset[1]));
  m_array.cell = {nx / 2.0 - left, ny / 2.0 - up};
  m_array.cellX = cells(movedBack(1, 0));
  m_array.cellY = cells(movedBack(0, 1));
  m_array.pitch = pitch;
  m_array.design = {pitch[0] * (0.5 - nx / 2.0), pitch[1] * (ny / 2.0 - 0.5)};
  m_array.middle = moved(m_array.design[0], m_array.design[1]);
  for (std::size_t axis = 0; axis < 2; ++axis) m_array.middle[axis] += errors.offset[axis];
  m_array.middleI = moved(pitch[0], 0);
  m_array.middleJ = moved(0, -pitch[1]);
  m_array.wedge = {errors.wedge[0] / width, errors.wedge[1] / height};
  if (m_lenses[0]->isLinear() && m_lenses[1]->isLinear())
    m_array.field = {m_lenses[0]->slopeOf(1), m_lenses[1]->slopeOf(1)};
  m_array.convergence = m_design.viewingDistance > 0 ? 1 / m_design.viewingDistance : 0;
  m_array.gap = errors.gapError;
  m_array.focal = errors.focalError;
}

double Twin::bytesFor(const TwinParams& params, const PanelParams& design) {
  constexpr double ofErrors = 48;  // their table, the draws, and what filters these
  constexpr double ofGains = 24;
  const auto [nx, ny] = design.hogels;
  const auto [du, dv] = design.directions;
  const double hogels = double(nx) * ny;
  const bool hasMap = !params.maps.hogels.empty();
  double bytes = 0;
  if (hasMap || params.random.shift.sigma > 0) bytes += ofErrors * hogels;
  if (hasMap || params.random.gain.sigma > 0) bytes += ofGains * hogels;
  if (params.dead != DeadParts{}) bytes += hogels + double(nx) * du + double(ny) * dv;
  return bytes;
}

void Twin::prepareHogels(const Progress& progress) {
  const auto [nx, ny] = m_design.hogels;
  const auto& [seed, shift, gain] = m_params.random;
  const auto draws = [&, seed = seed, nx = nx, ny = ny](Draw what, const RandomErrors& errors) {
    if (!(errors.sigma > 0)) return std::vector<float>{};
    return randomField(std::uint32_t(seed), what, errors.length, {0, 0, nx, ny}, progress);
  };
  const std::vector<float> drawnX = draws(drawnShiftX, shift);
  const std::vector<float> drawnY = draws(drawnShiftY, shift);
  const std::vector<float> drawn = draws(drawnGain, gain);
  const bool hasGains = !drawn.empty() || std::ranges::any_of(m_maps.gain, [](const TwinPlane& g) {
    return !g.isEmpty();
  });
  const bool hasErrors = !drawnX.empty() || !m_maps.shiftX.isEmpty() || !m_maps.shiftY.isEmpty() ||
                         !m_maps.tiltX.isEmpty() || !m_maps.tiltY.isEmpty() ||
                         !m_maps.gap.isEmpty();
  const std::size_t hogels = std::size_t(nx) * std::size_t(ny);
  if (hasErrors) m_hogels.reserve(hogels);
  if (hasGains) m_gains.reserve(hogels);
  for (int j = 0; j < ny; ++j) {
    throwIfCancelled(progress);
    for (int i = 0; i < nx; ++i) {
      const std::size_t at = std::size_t(j) * std::size_t(nx) + std::size_t(i);
      const auto given = [&, nx = nx, ny = ny](const TwinPlane& plane) {
        return plane.atCell(i, j, nx, ny);
      };
      const auto sigma = static_cast<float>(shift.sigma);
      if (hasErrors)
        m_hogels.push_back({given(m_maps.shiftX) + (drawnX.empty() ? 0 : sigma * drawnX[at]),
                            given(m_maps.shiftY) + (drawnY.empty() ? 0 : sigma * drawnY[at]),
                            given(m_maps.tiltX), given(m_maps.tiltY), given(m_maps.gap)});
      if (!hasGains) continue;
      const float factor = drawn.empty() ? 1 : 1 + static_cast<float>(gain.sigma) * drawn[at];
      auto& gains = m_gains.emplace_back();
      for (std::size_t c = 0; c < 3; ++c)
        gains[c] = std::max(0.0F, factor) * (m_maps.gain[c].isEmpty() ? 1 : given(m_maps.gain[c]));
    }
  }
}

HogelErrors Twin::errorsOf(int i, int j) const {
  if (m_hogels.empty()) return {};
  const auto [nx, ny] = m_design.hogels;
  return m_hogels[std::size_t(std::clamp(j, 0, ny - 1)) * std::size_t(nx) +
                  std::size_t(std::clamp(i, 0, nx - 1))];
}

Vec2 Twin::shiftOf(int i, int j) const {
  const HogelErrors own = errorsOf(i, j);
  const auto along = [&](std::size_t axis) {
    const double pitch = axis == 0 ? i * m_array.pitch[0] : -j * m_array.pitch[1];
    return m_array.middle[axis] + i * m_array.middleI[axis] + j * m_array.middleJ[axis] -
           m_array.design[axis] - pitch;
  };
  return {along(0) + double(own.shiftX), along(1) + double(own.shiftY)};
}

TwinMaps Twin::drawn() const {
  TwinMaps maps = m_maps;
  const auto plane = [&](const auto& of, std::size_t count) {
    TwinPlane values{m_size.nx, m_size.ny, {}};
    for (std::size_t at = 0; at < count; ++at) values.values.push_back(of(at));
    return values;
  };
  if (m_params.random.shift.sigma > 0) {
    maps.shiftX = plane([&](std::size_t at) { return m_hogels[at].shiftX; }, m_hogels.size());
    maps.shiftY = plane([&](std::size_t at) { return m_hogels[at].shiftY; }, m_hogels.size());
  }
  if (m_params.random.gain.sigma > 0)
    for (std::size_t c = 0; c < 3; ++c)
      maps.gain[c] = plane([&](std::size_t at) { return m_gains[at][c]; }, m_gains.size());
  return maps;
}

}  // namespace hogelscope
