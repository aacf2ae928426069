// SPDX-License-Identifier: BSD-3-Clause
// The loops that take most of the time, compiled once for each kind of processor.
#include "core/engine/row_kernels.h"

#include <algorithm>

#include "core/base/multiversioned.h"
#include "core/engine/sheet_finder.h"
#include "core/engine/unit_finders.h"

namespace hogelscope {

namespace {

/// A design with linear hogel lenses.
template <class Real>
struct DesignFinder : RealMap<Real> {
  static constexpr StripHits rowHits = StripHits::all;

  using RealMap<Real>::RealMap;

  [[nodiscard]] __attribute__((always_inline)) RealHit<Real> hit(double x, double y) const {
    const RealMap<Real>& m = *this;
    const RealSlopes<Real> s = slopesOf(m, static_cast<Real>(x), static_cast<Real>(y));
    return {m.constant[0] + m.slope[0] * s.a, m.constant[1] + m.slope[1] * s.b,
            m.constant[2] + m.slope[2] * s.a, m.constant[3] + m.slope[3] * s.b, s.isToward};
  }
};

/// A design with other lenses, whose map's u and v are the slopes that they take.
template <class Real>
struct CurvedFinder : DesignFinder<Real> {
  static constexpr StripHits rowHits = StripHits::none;

  explicit CurvedFinder(const HitMap& m)
      : DesignFinder<Real>(m), across(&m.panel.display->lens(0)), down(&m.panel.display->lens(1)) {}

  [[nodiscard]] RealHit<Real> hit(double x, double y) const {
    const auto directionOf = [](const HogelLens* lens, Real ofRay) {
      return static_cast<Real>(lens->directionOf(static_cast<double>(ofRay)));
    };
    constexpr auto half = static_cast<Real>(0.5);
    RealHit<Real> h = DesignFinder<Real>::hit(x, y);
    h.u = this->count[2] * (half + directionOf(across, h.u));
    h.v = this->count[3] * (half - directionOf(down, h.v));
    return h;
  }

  const HogelLens* across;
  const HogelLens* down;
};

/// Any display, as it says itself.
struct AnyFinder : RealMap<double> {
  AnyFinder(const HitMap& m, std::size_t ofChannel)
      : RealMap<double>(m), display(m.panel.display), eye(m.panel.eye), channel(ofChannel) {}

  [[nodiscard]] RealHit<double> hit(double x, double y) const {
    const auto along = [&](std::size_t c) { return x * right[c] + y * down[c] + forward[c]; };
    const std::optional<Hit> met =
        display->intersectPlane(eye, {along(0), along(1), along(2)}, channel);
    const auto [i, j, u, v] = met.value_or(Hit{});
    return {i, j, u, v, met.has_value()};
  }

  const Display* display;
  Vec3 eye;
  std::size_t channel;
};

template <class Use>
inline __attribute__((always_inline)) void withAffine(const HitMap& map, const Use& use) {
  const Twin& twin = *map.panel.display->twin();
  const bool hasMoves = !twin.hogelMoves().empty();
  if (twin.movesHits())
    hasMoves ? use(AffineFinder<true, true>(map)) : use(AffineFinder<false, true>(map));
  else
    hasMoves ? use(AffineFinder<true, false>(map)) : use(AffineFinder<false, false>(map));
}

template <class Use>
inline __attribute__((always_inline)) void withSheet(const HitMap& map, std::size_t channel,
                                                     const Use& use) {
  const CellPattern& pattern = map.panel.display->sheet()->pattern();
  if (pattern.mask == 0)
    use(SheetFinder<1>(map, channel));
  else if (pattern.mask == 1 && pattern.ofRow == 0)
    use(SheetFinder<2>(map, channel));
  else
    use(SheetFinder<4>(map, channel));
}

/// Calls `use` with the finder of one colour of a map.
template <class Use>
inline __attribute__((always_inline)) void withFinder(const HitMap& map, std::size_t channel,
                                                      const Use& use) {
  switch (map.finder) {
    case Finder::design:
      return map.isSingle ? use(DesignFinder<float>(map)) : use(DesignFinder<double>(map));
    case Finder::curved:
      return map.isSingle ? use(CurvedFinder<float>(map)) : use(CurvedFinder<double>(map));
    case Finder::unit:
      return map.panel.display->twin()->hogels().empty() ? use(UnitFinder<false>(map, channel))
                                                         : use(UnitFinder<true>(map, channel));
    case Finder::affine:
      return withAffine(map, use);
    case Finder::sheet:
      return withSheet(map, channel, use);
    case Finder::any:
      return use(AnyFinder(map, channel));
  }
}

}  // namespace

Finder finderOf(const Display& display) {
  if (display.sheet() != nullptr) return Finder::sheet;
  if (const Twin* twin = display.twin(); twin != nullptr)
    return !twin->hasKernel() ? Finder::any : twin->isAffine() ? Finder::affine : Finder::unit;
  if (display.traits().movesRays) return Finder::any;
  return display.lens(0).isLinear() && display.lens(1).isLinear() ? Finder::design : Finder::curved;
}

MULTIVERSIONED
void copyRays(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
              bool isPlain, std::span<const RayRow> rows) {
  withFinder(
      map, greenChannel, [&](const auto& finder) __attribute__((always_inline)) {
        if (isPlain)
          copyRows<Rays::row>(finder, layout, texels, rows);
        else
          copyRows<Rays::any>(finder, layout, texels, rows);
      });
}

MULTIVERSIONED
void findCells(const HitMap& map, const double* x, const double* y, int count, CellBatch& batch,
               std::size_t channel) {
  withFinder(
      map, channel, [&](const auto& finder) __attribute__((always_inline)) {
        cellsOf(finder, x, y, count, batch);
      });
}

bool fillUnseen(int count, CellBatch& batch) {
  const auto end = batch.seen.begin() + count;
  if (count == batchSize && std::find(batch.seen.begin(), end, std::uint8_t{0}) == end) return true;
  const auto hit = std::find(batch.seen.begin(), end, std::uint8_t{255});
  if (hit == end) return false;
  std::fill(end, batch.seen.end(), std::uint8_t{0});
  const auto at = std::size_t(hit - batch.seen.begin());
  for (auto& cell : batch.cell)
    for (std::size_t k = 0; k < batchSize; ++k) cell[k] = batch.seen[k] == 0 ? cell[at] : cell[k];
  return true;
}

}  // namespace hogelscope
