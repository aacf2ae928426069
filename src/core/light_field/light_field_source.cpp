// SPDX-License-Identifier: BSD-3-Clause
#include "core/light_field/light_field_source.h"

#include <algorithm>
#include <stdexcept>

#include "core/light_field/light_field.h"

namespace hogelscope {

ViewReads readsOfRows(const LightFieldSize& size, const CellRange& j, const CellRange& u,
                      const CellRange& v) {
  const auto footprint = [=] {
    Footprint rows(size.nx, size.ny);
    std::ranges::fill(rows.u, u);
    std::fill(rows.v.begin() + j.first, rows.v.begin() + j.last + 1, v);
    return rows;
  };
  return {footprint, {}};
}

Rgb LightFieldSource::texel(const TexelIndex& at) const {
  const auto footprint = [this, &at] {
    Footprint one(size().nx, size().ny);
    one.u[std::size_t(at.i)] = {at.u, at.u};
    one.v[std::size_t(at.j)] = {at.v, at.v};
    return one;
  };
  return slice({footprint, {}}, {})->texel(at);
}

std::shared_ptr<const LightField> StreamedLightField::slice(const ViewReads& /*reads*/,
                                                            const Progress& /*progress*/) const {
  throw std::logic_error("StreamedLightField: its texels come once, from the top");
}

std::shared_ptr<const LightField> StreamedLightField::overview() const {
  return slice({}, {});
}

}  // namespace hogelscope
