// SPDX-License-Identifier: BSD-3-Clause
// The twin's map and light, written to be read beside docs/formulas.md, Twin.
#include "core/panel/twin.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/panel/random_field.h"

namespace hogelscope {

namespace {

/// The draws of a seed.
enum Draw : std::uint32_t { drawnShiftX, drawnShiftY, drawnGain };

/// The surface at a place, metres, and its slopes.
struct SurfacePoint {
  double z = 0;
  double slopeX = 0;
  double slopeY = 0;
};

/// Beyond the middles of the outermost cells the surface goes straight on to the panel's borders.
SurfacePoint surfaceAt(const TwinPlane& height, const std::array<double, 2>& size, double x,
                       double y) {
  if (height.isEmpty()) return {};
  const Bilinear at(height, planePlaceOf(std::clamp(x / size[0] + 0.5, 0.0, 1.0), height.width),
                    planePlaceOf(std::clamp(0.5 - y / size[1], 0.0, 1.0), height.height));
  return {at.value, at.across * height.width / size[0], -at.down * height.height / size[1]};
}

bool isOutside(double index, int count) {
  return !(index >= 0 && index < count);
}

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
  if (!m_traits.movesRays) return;
  map.twin = this;
  if (isAffine()) map.affine = affineHits(map.eye);
}

void Twin::checkContent(const LightFieldSize& size) const {
  if (m_size != size) throw InputError("twin", "is of a display with other hogels or directions");
}

void Twin::prepareDead() {
  const auto [nx, ny] = m_design.hogels;
  const auto [du, dv] = m_design.directions;
  const auto cells = [](int hogels, int directions) {
    return std::size_t(hogels) * std::size_t(directions);
  };
  m_deadHogels.resize(cells(nx, ny));
  m_deadColumns.resize(cells(nx, du));
  m_deadRows.resize(cells(ny, dv));
  const auto mark = [](std::vector<std::uint8_t>& marks, int at, const char* name,
                       const char* what) {
    if (std::size_t(at) >= marks.size())
      throw InputError(std::string("twin.dead.") + name,
                       "has " + std::to_string(at) + ", but the hogel image has " + what + " 0 … " +
                           std::to_string(marks.size() - 1));
    marks[std::size_t(at)] = 1;
  };
  for (const int column : m_params.dead.columns) mark(m_deadColumns, column, "columns", "columns");
  for (const int row : m_params.dead.rows) mark(m_deadRows, row, "rows", "rows");
  for (const auto& [i, j] : m_params.dead.hogels) {
    if (i >= nx || j >= ny)
      throw InputError("twin.dead.hogels", "has [" + std::to_string(i) + ", " + std::to_string(j) +
                                               "], but the display has " + std::to_string(nx) +
                                               " × " + std::to_string(ny) + " hogels");
    m_deadHogels[hogelAt(i, j)] = 1;
  }
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

/// The move m of a direction, and how it grows for each direction across and down.
struct Twin::Move {
  Vec2 m;
  Vec2 across;
  Vec2 down;
  [[nodiscard]] double determinant() const {
    return (1 + across.x) * (1 + down.y) - down.x * across.y;
  }
};

Twin::Move Twin::moveAt(double u, double v) const {
  const auto [du, dv] = m_design.directions;
  Move move;
  const auto find = [&, du = du, dv = dv](const TwinPlane& plane, double Vec2::*axis) {
    if (plane.isEmpty()) return;
    const PlanePlace i = planePlaceOf(u / du, plane.width);
    const PlanePlace j = planePlaceOf(v / dv, plane.height);
    const Bilinear at(plane, within(i), within(j));
    move.m.*axis = at.value;
    if (i.share == within(i).share) move.across.*axis = at.across * plane.width / du;
    if (j.share == within(j).share) move.down.*axis = at.down * plane.height / dv;
  };
  find(m_maps.moveU, &Vec2::x);
  find(m_maps.moveV, &Vec2::y);
  return move;
}

/// The determinant of a bilinear map is linear along both axes, so that it is least in a corner.
void Twin::checkDirections() const {
  const TwinPlane& plane = m_maps.moveU.isEmpty() ? m_maps.moveV : m_maps.moveU;
  const auto [du, dv] = m_design.directions;
  constexpr double inside = 1e-9;  // of a cell, from its corners
  for (int row = 0; row < plane.height; ++row)
    for (int column = 0; column < plane.width; ++column)
      for (const double x : {-inside, inside})
        for (const double y : {-inside, inside}) {
          const double u = (column + 0.5 + x) / plane.width * du;
          const double v = (row + 0.5 + y) / plane.height * dv;
          if (!(moveAt(u, v).determinant() > 0))
            throw InputError("twin.maps.directions",
                             "folds near direction (" + std::to_string(int(u)) + ", " +
                                 std::to_string(int(v)) +
                                 "): two pixels would send light into one direction");
        }
}

void Twin::checkKernels() const {
  const TwinPlane& image = m_maps.kernels[0];
  if (image.isEmpty()) return;
  const int tiles = m_params.maps.kernelTiles;
  const int side = image.width / tiles;
  const auto [du, dv] = m_design.directions;
  if (image.width != image.height || side * tiles != image.width || side % 2 == 0)
    throw InputError("twin.maps.kernels",
                     "is " + pairText(image.width, image.height) + " pixels, which are not " +
                         pairText(tiles, tiles) +
                         " squares of an odd number of pixels: set twin.maps.kernelTiles");
  for (int v = 0; v < tiles && v < dv; ++v)
    for (int u = 0; u < tiles && u < du; ++u)
      for (std::size_t c = 0; c < 3; ++c) {
        const TapRange all{-kernelReach(), kernelReach()};
        const std::vector<double> kernel = kernelAt(u * du / tiles, v * dv / tiles, c, all, all);
        const double sum = std::accumulate(kernel.begin(), kernel.end(), 0.0);
        if (std::ranges::any_of(kernel, [](double w) { return w < 0; }) || !(sum > 0))
          throw InputError("twin.maps.kernels", "kernel (" + std::to_string(u) + ", " +
                                                    std::to_string(v) +
                                                    ") has weights below 0, or none above");
      }
}

void Twin::prepareKernels() {
  const auto& [field, pitch] = std::pair(m_array.field, m_array.pitch);
  const auto [du, dv] = m_design.directions;
  m_isAffine = m_array.wedge == std::array<double, 2>{} && m_maps.gap.isEmpty() &&
               m_params.colour.scale == ColourErrors{}.scale;
  if (m_isAffine && field[0] > 0)
    for (const HogelErrors& own : m_hogels) {
      const double scale = 1 + m_array.gap;
      m_hogelMoves.push_back({static_cast<float>(-du * (double(own.shiftX) / pitch[0] +
                                                        scale * double(own.tiltX) / field[0])),
                              static_cast<float>(dv * (double(own.shiftY) / pitch[1] +
                                                       scale * double(own.tiltY) / field[1]))});
    }
  for (const auto& move : m_hogelMoves)
    for (std::size_t axis = 0; axis < 2; ++axis)
      m_largestMoves[axis] = std::max(m_largestMoves[axis], std::abs(double(move[axis])));
  if (m_params.lensArray.outside == OutsideField::dark && movesDirections())
    m_directions = MoveTable(m_maps.moveU, m_maps.moveV, m_design.directions);
}

AffineHits Twin::affineHits(const Vec3& eye) const {
  const auto& [cell, cellX, cellY, middle, middleI, middleJ, design, pitch, wedge, field, gap,
               focal, convergence] = m_array;
  const double g = 1 + gap;
  const double blur = g / (1 + focal) - 1;
  AffineHits hits;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    hits.place[axis] = {cell[axis] + cellX[axis] * eye.x + cellY[axis] * eye.y,
                        -cellX[axis] * eye.z, -cellY[axis] * eye.z};
    const double own = axis == 0 ? eye.x : eye.y;
    const double count = m_design.directions[axis];
    const double cells = axis == 0 ? count : -count;  // v is downwards
    const double step = axis == 0 ? pitch[0] : -pitch[1];
    const double along = axis == 0 ? middleI[0] : middleJ[1];
    const double across = axis == 0 ? middleJ[0] : middleI[1];
    hits.direction[axis] = {
        count / 2 +
            cells * (g * convergence * own / field[axis] +
                     (blur * (own - middle[axis]) - (middle[axis] - design[axis])) / pitch[axis]),
        cells * (g * (1 - convergence * eye.z) / field[axis] - blur * eye.z / pitch[axis]),
        -cells * (blur * along + along - step) / pitch[axis],
        -cells * (blur * across + across) / pitch[axis]};
  }
  return hits;
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

std::optional<Hit> Twin::meet(const Vec3& eye, const Vec3& direction, std::size_t channel) const {
  if (!(eye.z > 0 && direction.z < 0)) return std::nullopt;
  double a = direction.x / direction.z;
  double b = direction.y / direction.z;
  double x = eye.x - eye.z * a;
  double y = eye.y - eye.z * b;
  if (!std::isfinite(x) || !std::isfinite(y)) return std::nullopt;  // along the panel
  if (!m_maps.height.isEmpty()) {
    SurfacePoint surface;
    for (int step = 0; step < 100; ++step) {
      surface = surfaceAt(m_maps.height, m_design.size, x, y);
      const double nextX = eye.x - (eye.z - surface.z) * a;
      const double nextY = eye.y - (eye.z - surface.z) * b;
      const double moved = std::max(std::abs(nextX - x), std::abs(nextY - y));
      std::tie(x, y) = std::pair(nextX, nextY);
      if (moved < 1e-12) break;
    }
    if (!(eye.z > surface.z)) return std::nullopt;
    a += surface.slopeX;
    b += surface.slopeY;
  }
  const auto& [cell, cellX, cellY, middle, middleI, middleJ, design, pitch, wedge, field, gap0,
               focal, convergence] = m_array;
  const auto [du, dv] = m_design.directions;
  Hit hit;
  hit.i = cell[0] + cellX[0] * x + cellY[0] * y;
  hit.j = cell[1] + cellX[1] * x + cellY[1] * y;
  const double i = std::floor(hit.i);
  const double j = std::floor(hit.j);
  const Vec2 lens{middle[0] + i * middleI[0] + j * middleJ[0],
                  middle[1] + i * middleI[1] + j * middleJ[1]};
  const auto [nx, ny] = m_design.hogels;
  const HogelErrors own = errorsOf(static_cast<int>(std::clamp(i, 0.0, double(nx))),
                                   static_cast<int>(std::clamp(j, 0.0, double(ny))));
  const Vec2 off{lens.x - (design[0] + i * pitch[0]) + double(own.shiftX),
                 lens.y - (design[1] - j * pitch[1]) + double(own.shiftY)};
  const double gap = gap0 + wedge[0] * x + wedge[1] * y + double(own.gap);
  const double blur = (1 + gap) / (1 + focal) - 1;
  const double scale = scaleOf(channel) * (1 + gap);
  const double turnedA = a - double(own.tiltX) + convergence * x;
  const double turnedB = b - double(own.tiltY) + convergence * y;
  hit.u = du * (0.5 + scale * m_lenses[0]->directionOf(turnedA) +
                (blur * (x - lens.x) - off.x) / pitch[0]);
  hit.v = dv * (0.5 - scale * m_lenses[1]->directionOf(turnedB) -
                (blur * (y - lens.y) - off.y) / pitch[1]);
  return moved(hit);
}

/// Newton's steps. The map is bilinear between the middles of its cells and does not fold, so that
/// few are needed; a step after which more is left, beyond a steep cell, is halved.
Vec2 Twin::solved(const Vec2& designed) const {
  Vec2 found = designed;
  Vec2 step;
  double left = std::numeric_limits<double>::infinity();
  for (int count = 0; count < 100; ++count) {
    const Move move = moveAt(found.x, found.y);
    const Vec2 rest{designed.x - found.x - move.m.x, designed.y - found.y - move.m.y};
    const double size = std::max(std::abs(rest.x), std::abs(rest.y));
    if (size >= left) {
      step = {step.x / 2, step.y / 2};
      found = {found.x - step.x, found.y - step.y};
      continue;
    }
    left = size;
    const double determinant = move.determinant();
    step = {(rest.x * (1 + move.down.y) - rest.y * move.down.x) / determinant,
            (rest.y * (1 + move.across.x) - rest.x * move.across.y) / determinant};
    found = {found.x + step.x, found.y + step.y};
    if (std::max(std::abs(step.x), std::abs(step.y)) < 1e-9) break;
  }
  return found;
}

Hit Twin::moved(Hit hit) const {
  const auto [nx, ny] = m_design.hogels;
  const auto [du, dv] = m_design.directions;
  if (isOutside(hit.i, nx) || isOutside(hit.j, ny)) return hit;
  if (movesDirections()) {
    const Vec2 found = solved({hit.u, hit.v});
    hit.u = found.x;
    hit.v = found.y;
  }
  if (m_params.lensArray.outside == OutsideField::dark) return hit;
  const double aside = std::floor(hit.u / du);
  const double below = std::floor(hit.v / dv);
  hit.i -= aside;
  hit.u -= aside * du;
  hit.j -= below;
  hit.v -= below * dv;
  return hit;
}

std::optional<PanelRay> Twin::rayOf(const TexelIndex& at) const {
  if (!m_traits.movesRays) return std::nullopt;
  return rayOf(at.i, at.j, at.u + 0.5, at.v + 0.5, greenChannel);
}

PanelRay Twin::rayOf(int i, int j, double u, double v, std::size_t channel) const {
  const auto& array = m_array;
  const auto [du, dv] = m_design.directions;
  const Vec2 lens{array.middle[0] + i * array.middleI[0] + j * array.middleJ[0],
                  array.middle[1] + i * array.middleI[1] + j * array.middleJ[1]};
  const HogelErrors own = errorsOf(i, j);
  const Vec2 off{lens.x - (array.design[0] + i * array.pitch[0]) + double(own.shiftX),
                 lens.y - (array.design[1] - j * array.pitch[1]) + double(own.shiftY)};
  const double gap =
      array.gap + array.wedge[0] * lens.x + array.wedge[1] * lens.y + double(own.gap);
  const double scale = scaleOf(channel) * (1 + gap);
  const Vec2 move = moveAt(u, v).m;
  const double acrossField = (u + move.x) / du - 0.5 + off.x / array.pitch[0];
  const double upField = 0.5 - (v + move.y) / dv + off.y / array.pitch[1];
  const SurfacePoint surface = surfaceAt(m_maps.height, m_design.size, lens.x, lens.y);
  const double a = m_lenses[0]->slopeOf(acrossField / scale) + double(own.tiltX) -
                   array.convergence * lens.x - surface.slopeX;
  const double b = m_lenses[1]->slopeOf(upField / scale) + double(own.tiltY) -
                   array.convergence * lens.y - surface.slopeY;
  return {{lens.x - surface.z * a, lens.y - surface.z * b}, {a, b}};
}

double Twin::leastGain() const {
  float least = std::numeric_limits<float>::infinity();
  for (const auto& gains : m_gains)
    for (const float gain : gains)
      if (gain > 0) least = std::min(least, gain);
  return std::isfinite(least) ? double(least) : 1;
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

double Twin::sigmaAt(int u, int v, double sigma) const {
  const auto [du, dv] = m_design.directions;
  const double x = (u + 0.5) / du;
  const double y = (v + 0.5) / dv;
  if (!m_maps.sigma.isEmpty()) return m_maps.sigma.at(x, y);
  const double square = (2 * x - 1) * (2 * x - 1) + (2 * y - 1) * (2 * y - 1);
  return sigma * (1 + m_params.leakage.sigmaGrowth * square);
}

/// A square lens of the width p sends the wavelength λ into sinc²(p s/λ) of the slope s.
double Twin::diffractionStep(std::size_t axis, std::size_t channel) const {
  const double wavelength = m_params.colour.wavelengths[channel];
  if (!(wavelength > 0)) return 0;
  const double step = m_lenses[axis]->slopeOf(0.5) - m_lenses[axis]->slopeOf(-0.5);
  return m_array.pitch[axis] * step / m_design.directions[axis] / wavelength;
}

std::vector<double> Twin::kernelAt(int u, int v, std::size_t channel, const TapRange& across,
                                   const TapRange& down) const {
  const auto [du, dv] = m_design.directions;
  const TwinPlane& image = m_maps.kernels[channel];
  const int tiles = m_params.maps.kernelTiles;
  const int side = 2 * kernelReach() + 1;
  const int middleX = u * tiles / du * side + kernelReach();
  const int middleY = v * tiles / dv * side + kernelReach();
  std::vector<double> kernel;
  for (int y = middleY + down.first; y <= middleY + down.last; ++y)
    for (int x = middleX + across.first; x <= middleX + across.last; ++x)
      kernel.push_back(
          double(image.values[std::size_t(y) * std::size_t(image.width) + std::size_t(x)]));
  return kernel;
}

Rgb Twin::lit(const std::array<Hit, 3>& hits, const Rgb& content) const {
  const LightErrors& light = m_params.light;
  const auto [nx, ny] = m_design.hogels;
  const auto [du, dv] = m_design.directions;
  const auto of = [&, nx = nx, du = du, dv = dv](std::size_t c, double value) {
    const Hit& hit = hits[c];
    double factor = 1 - light.black;
    if (!m_gains.empty())
      factor *= double(m_gains[std::size_t(hit.j) * std::size_t(nx) + std::size_t(hit.i)][c]);
    if (!m_maps.directionGain[c].isEmpty())
      factor *= m_maps.directionGain[c].at(hit.u / du, hit.v / dv);
    if (light.falloff != 0) {
      const double a = m_lenses[0]->slopeOf(hit.u / du - 0.5);
      const double b = m_lenses[1]->slopeOf(0.5 - hit.v / dv);
      factor *= std::pow(1 + a * a + b * b, -light.falloff / 2);
    }
    const double fromMiddleU = std::abs(hit.u - std::floor(hit.u) - 0.5);
    const double fromMiddleV = std::abs(hit.v - std::floor(hit.v) - 0.5);
    if (2 * fromMiddleU > light.fill[0] || 2 * fromMiddleV > light.fill[1]) factor = 0;
    return light.black + factor * value + light.ambient[c];
  };
  return {of(0, content.r), of(1, content.g), of(2, content.b)};
}

}  // namespace hogelscope
