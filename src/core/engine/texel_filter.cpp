// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/texel_filter.h"

#include <algorithm>

#include "core/base/multiversioned.h"
#include "core/panel/twin.h"

namespace hogelscope {

namespace {

std::uint32_t clampedCell(int cell, int cells) {
  return static_cast<std::uint32_t>(std::clamp(cell, 0, cells - 1));
}

constexpr int vectorLanes = 16;
int wholeVectors(int count) {
  return (count + vectorLanes - 1) / vectorLanes * vectorLanes;
}

}  // namespace

TexelFilter::TexelFilter(std::shared_ptr<const LightField> lightField, const RenderJob& job,
                         const Plan& plan)
    : m_lightField(std::move(lightField)),
      m_reconstruction(job.sampling.reconstruction),
      m_leaks(plan.psfReach > 0),
      m_sumsLinear(plan.sumsLinear) {
  const auto [nx, ny, du, dv] = m_lightField->size();
  m_cells = {nx, ny, du, dv};
  m_weights = {axisWeights(job.state.psf, plan.psfReach, du),
               axisWeights(job.state.psf, plan.psfReach, dv)};
  if (plan.drivesTexels) m_twin = job.twin;
}

TexelFilter::AxisWeights TexelFilter::axisWeights(const PsfParams& psf, int reach, int cells) {
  AxisWeights axis;
  axis.cells = cells;
  axis.reach = std::min(reach, cells - 1);
  const std::size_t window = 2 * std::size_t(axis.reach) + 1;
  axis.weights.resize(std::size_t(cells) * window);
  const std::vector<double> gaussian = gaussianWeights(psf.sigma, reach);
  for (int cell = 0; cell < cells; ++cell) {
    std::vector<double> weights(window);
    double total = 0;
    for (int place = 0; place <= 2 * reach; ++place) {
      const double weight = gaussian[std::size_t(place)];
      int tap = cell + place - reach;
      if (psf.border == PsfBorder::clamp) tap = std::clamp(tap, 0, cells - 1);
      const bool inside = tap >= 0 && tap < cells;
      if (inside) weights[std::size_t(tap - cell + axis.reach)] += weight;
      if (inside || psf.border == PsfBorder::black) total += weight;
    }
    std::transform(weights.begin(), weights.end(),
                   &axis.weights[std::size_t(cell) * weights.size()],
                   [total](double weight) { return static_cast<float>(weight / total); });
  }
  if (axis.reach == reach) {
    axis.firstInner = reach;
    axis.lastInner = cells - 1 - reach;
  }
  return axis;
}

const AxisLayout& TexelFilter::layoutOf(std::size_t axis) const {
  const BlockLayout& layout = m_lightField->layout();
  return *std::array{&layout.i, &layout.j, &layout.u, &layout.v}[axis];
}

/// Makes one tap: the cell itself.
MULTIVERSIONED
void TexelFilter::nearestTap(std::size_t axis, const CellBatch& batch, AxisTaps& taps) const {
  static constexpr float whole = 1;
  taps.taps = 1;
  taps.share = &whole;
  taps.offset.resize(1);
  const AxisLayout layout = layoutOf(axis);
  for (std::size_t k = 0; k < batchSize; ++k) taps.offset[0][k] = layout(batch.cell[axis][k]);
}

/// Makes two taps: the cells whose centres lie around the hit.
void TexelFilter::linearTaps(std::size_t axis, const CellBatch& batch, AxisTaps& taps) const {
  taps.taps = 2;
  taps.share = nullptr;
  taps.offset.resize(2);
  taps.weight.resize(2);
  bracketingCells(layoutOf(axis), m_cells[axis], batch.cell[axis].data(), batch.place[axis].data(),
                  taps.offset[0].data(), taps.weight[0].data());
}

/// Makes the taps of a direction axis without interpolation: the window of each ray's cell.
MULTIVERSIONED
void TexelFilter::directionTaps(std::size_t axis, const CellBatch& batch, AxisTaps& taps) const {
  const AxisWeights& weights = m_weights[axis - 2];
  const AxisLayout layout = layoutOf(axis);
  const auto& cell = batch.cell[axis];
  taps.taps = 2 * weights.reach + 1;
  taps.offset.resize(std::size_t(taps.taps));
  taps.weight.resize(taps.offset.size());
  std::uint32_t low = cell[0];
  std::uint32_t high = cell[0];
  for (const std::uint32_t at : cell) {
    low = std::min(low, at);
    high = std::max(high, at);
  }
  const bool isInner = int(low) >= weights.firstInner && int(high) <= weights.lastInner;
  taps.share = isInner ? weights.of(weights.firstInner) : nullptr;
  for (int t = 0; t < taps.taps; ++t) {
    const int step = t - weights.reach;
    auto& offset = taps.offset[std::size_t(t)];
    if (isInner) {
      for (std::size_t k = 0; k < batchSize; ++k)
        offset[k] = layout(cell[k] + static_cast<std::uint32_t>(step));
      continue;
    }
    for (std::size_t k = 0; k < batchSize; ++k) {
      offset[k] = layout(clampedCell(int(cell[k]) + step, weights.cells));
      taps.weight[std::size_t(t)][k] = weights.of(int(cell[k]))[t];
    }
  }
}

/// Makes the taps of a direction axis with interpolation: the windows of the two cells around the
/// hit, one tap apart.
MULTIVERSIONED
void TexelFilter::interpolatedTaps(std::size_t axis, const CellBatch& batch, AxisTaps& taps) const {
  const AxisWeights& weights = m_weights[axis - 2];
  const AxisLayout layout = layoutOf(axis);
  const int window = 2 * weights.reach + 1;
  taps.taps = window + 1;
  taps.share = nullptr;
  taps.offset.resize(std::size_t(taps.taps));
  taps.weight.resize(taps.offset.size());
  for (std::size_t k = 0; k < batchSize; ++k) {
    const float place = batch.place[axis][k];
    const int left = int(batch.cell[axis][k]) - (place < 0.5F ? 1 : 0);
    const float share = place < 0.5F ? place + 0.5F : place - 0.5F;
    const int first = std::max(left, 0);
    const int second = std::min(left + 1, weights.cells - 1);
    for (int t = 0; t < taps.taps; ++t) {
      const int fromSecond = t - (second - first);
      taps.offset[std::size_t(t)][k] =
          layout(clampedCell(first - weights.reach + t, weights.cells));
      taps.weight[std::size_t(t)][k] =
          (t < window ? (1 - share) * weights.of(first)[t] : 0) +
          (fromSecond >= 0 && fromSecond < window ? share * weights.of(second)[fromSecond] : 0);
    }
  }
}

void TexelFilter::tapsOf(std::size_t axis, const CellBatch& batch, AxisTaps& taps) const {
  const Reconstruction reconstruction = m_reconstruction;
  const bool isHogel = axis < 2;
  const bool interpolates = isHogel ? reconstruction == Reconstruction::quadrilinear
                                    : reconstruction != Reconstruction::nearest;
  const bool leaks = !isHogel && m_leaks;
  if (leaks)
    interpolates ? interpolatedTaps(axis, batch, taps) : directionTaps(axis, batch, taps);
  else
    interpolates ? linearTaps(axis, batch, taps) : nearestTap(axis, batch, taps);
}

/// Takes the weight of taps in dead columns (axis 2) or rows (axis 3) of the hogel image.
void TexelFilter::dropDead(std::size_t axis, const CellBatch& batch, AxisTaps& taps) const {
  taps.weight.resize(std::size_t(taps.taps));
  if (taps.share != nullptr)
    for (std::size_t t = 0; t < taps.weight.size(); ++t) taps.weight[t].fill(taps.share[t]);
  taps.share = nullptr;
  const bool interpolates = m_reconstruction != Reconstruction::nearest;
  const int reach = m_leaks ? m_weights[axis - 2].reach : 0;
  for (std::size_t k = 0; k < batchSize; ++k) {
    const auto hogel = static_cast<int>(batch.cell[axis - 2][k]);
    int first = static_cast<int>(batch.cell[axis][k]);
    if (interpolates && batch.place[axis][k] < 0.5F) --first;
    if (interpolates && m_leaks) first = std::max(first, 0);
    for (std::size_t t = 0; t < taps.weight.size(); ++t) {
      const int at = std::clamp(first - reach + static_cast<int>(t), 0, m_cells[axis] - 1);
      const bool isDead =
          axis == 2 ? m_twin->isDeadColumn(hogel, at) : m_twin->isDeadRow(hogel, at);
      if (isDead) taps.weight[t][k] = 0;
    }
  }
}

Rgb TexelFilter::lightOf(const TexelIndex& at) const {
  if (m_twin && m_twin->hasDead() && m_twin->isDead(at)) return {};
  const Rgb code = m_lightField->texel(at);
  if (m_twin && m_twin->drivesTexels()) {
    const LightErrors& panel = m_twin->params().light;
    return {panelLight(panel, code.r), panelLight(panel, code.g), panelLight(panel, code.b)};
  }
  return m_sumsLinear ? decoded(LightModel::linear, code) : code;
}

void TexelFilter::addTaps(int count, const TapBatch& taps, LightBatch& sum) const {
  std::visit(
      [&](const auto& texels) {
        if (m_twin && m_twin->drivesTexels())
          accumulateDriven(texels.data(), taps, count, m_twin->params().light, sum);
        else if (m_sumsLinear)
          accumulateLinear(texels.data(), taps, count, sum);
        else
          accumulate(texels.data(), taps, count, sum);
      },
      m_lightField->texels());
}

MULTIVERSIONED
void TexelFilter::sum(int count, const CellBatch& batch, Scratch& scratch, LightBatch& sum) const {
  for (const std::size_t axis : {0U, 1U, 2U, 3U}) tapsOf(axis, batch, scratch.axes[axis]);
  if (m_twin && m_twin->hasDead())
    for (const std::size_t axis : {2U, 3U}) dropDead(axis, batch, scratch.axes[axis]);
  const auto& [i, j, u, v] = scratch.axes;
  sum = {};
  std::array<std::array<std::uint32_t, batchSize>, 4> hogel;
  std::array<std::array<float, batchSize>, 4> weight;
  const auto hogels = std::size_t(i.taps) * std::size_t(j.taps);
  for (std::size_t t = 0; t < hogels; ++t) {
    const std::size_t ti = t % std::size_t(i.taps);
    const std::size_t tj = t / std::size_t(i.taps);
    for (std::size_t k = 0; k < batchSize; ++k) hogel[t][k] = i.offset[ti][k] + j.offset[tj][k];
    if (i.taps == 1) continue;
    for (std::size_t k = 0; k < batchSize; ++k) weight[t][k] = i.weight[ti][k] * j.weight[tj][k];
  }
  constexpr std::size_t ahead = 2;  // rows of taps that are fetched before they are summed
  std::array<std::array<std::uint32_t, batchSize>, ahead + 1> bases;
  const std::size_t rows = hogels * std::size_t(v.taps);
  const auto makeBase = [&, v = &v](std::size_t t) {
    auto& base = bases[t % bases.size()];
    for (std::size_t k = 0; k < batchSize; ++k)
      base[k] = hogel[t % hogels][k] + v->offset[t / hogels][k];
    return base.data();
  };
  for (std::size_t t = 0; t < std::min(ahead, rows); ++t) makeBase(t);
  std::array<float, batchSize> scale;
  scratch.share.resize(std::size_t(u.taps));
  const bool isUniform = u.share != nullptr && v.share != nullptr && hogels == 1;
  for (std::size_t t = 0; t < rows; ++t) {
    const std::size_t th = t % hogels;
    const std::size_t tv = t / hogels;
    TapBatch taps{
        u.taps, bases[t % bases.size()].data(), u.offset.data(), u.share, u.weight.data(), nullptr,
        nullptr};
    if (t + ahead < rows) taps.ahead = makeBase(t + ahead);
    if (isUniform) {
      for (std::size_t tu = 0; tu < scratch.share.size(); ++tu)
        scratch.share[tu] = u.share[tu] * v.share[tv];
      taps.share = scratch.share.data();
    } else {
      if (v.share != nullptr)
        scale.fill(v.share[tv]);
      else
        scale = v.weight[tv];
      if (hogels > 1)
        for (std::size_t k = 0; k < batchSize; ++k) scale[k] *= weight[th][k];
      taps.scale = scale.data();
    }
    addTaps(wholeVectors(count), taps, sum);
  }
}

}  // namespace hogelscope
