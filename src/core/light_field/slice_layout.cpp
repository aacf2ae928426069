// SPDX-License-Identifier: BSD-3-Clause
#include "core/light_field/slice_layout.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <stdexcept>

#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

namespace {

/// The size of a ring of rows, and where each hogel row begins in it, counted in rows.
struct Places {
  std::vector<std::size_t> begin;
  std::size_t rows = 0;
};

/// Returns the most rows that are needed at a time, plus those of the largest hogel row, which the
/// end of the ring may waste.
std::size_t ringRows(const std::vector<CellRange>& v, const std::vector<int>& lastUse) {
  struct Kept {
    int until;
    std::size_t rows;
  };
  std::deque<Kept> kept;
  std::size_t rows = 0;
  std::size_t most = 0;
  std::size_t largest = 0;
  int until = 0;
  for (int j = 0; j < int(v.size()); ++j) {
    for (; !kept.empty() && kept.front().until < j; kept.pop_front()) rows -= kept.front().rows;
    until = std::max(until, lastUse[std::size_t(j)]);  // places are released in order
    kept.push_back({until, v[std::size_t(j)].size()});
    rows += kept.back().rows;
    most = std::max(most, rows);
    largest = std::max(largest, kept.back().rows);
  }
  return most + largest;
}

/// Puts each hogel row behind the previous one, or at the beginning if the end is too near.
Places ring(const std::vector<CellRange>& v, const std::vector<int>& lastUse) {
  Places places{{}, ringRows(v, lastUse)};
  std::size_t next = 0;
  for (const CellRange& range : v) {
    if (next + range.size() > places.rows) next = 0;
    places.begin.push_back(next);
    next += range.size();
  }
  return places;
}

SliceLayout layoutOf(const Footprint& footprint, const Places& places) {
  SliceLayout layout{footprint, {}, 0, {}, {}, 0};
  std::size_t width = 0;
  for (int i = 0; i < int(footprint.u.size()); ++i) {
    const CellRange& u = footprint.u[std::size_t(i)];
    layout.columnStart.push_back(std::uint32_t(width) - std::uint32_t(u.first));
    if (!u.isEmpty()) layout.runs.push_back({i, u});
    width += u.size();
  }
  if (width * places.rows >= std::numeric_limits<std::uint32_t>::max())
    throw std::length_error("more than 2^32 directional pixels in memory");
  layout.width = std::uint32_t(width);
  layout.texels = std::uint32_t(width * places.rows);
  for (std::size_t j = 0; j < footprint.v.size(); ++j)
    layout.rowStart.push_back(
        (std::uint32_t(places.begin[j]) - std::uint32_t(footprint.v[j].first)) * layout.width);
  return layout;
}

Places allAtOnce(const std::vector<CellRange>& v) {
  Places places;
  for (const CellRange& range : v) {
    places.begin.push_back(places.rows);
    places.rows += range.size();
  }
  return places;
}

}  // namespace

void requireMemory(const Footprint& footprint, std::size_t bytesOfTexel, std::size_t memory) {
  const double bytes = double(footprint.texels()) * double(bytesOfTexel);
  if (bytes > double(memory))
    throw InputError("memory", "a view needs " + bytesText(std::size_t(bytes)) +
                                   " of the light field, " + bytesText(memory) +
                                   " are allowed: allow more");
}

SliceLayout sliceLayout(const Footprint& footprint) {
  return layoutOf(footprint, allAtOnce(footprint.v));
}

SliceLayout rollingLayout(const Footprint& footprint, const std::vector<int>& lastUse) {
  const Places whole = allAtOnce(footprint.v);
  const Places places = ring(footprint.v, lastUse);
  return layoutOf(footprint, places.rows < whole.rows ? places : whole);
}

}  // namespace hogelscope
