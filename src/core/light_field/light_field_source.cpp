// SPDX-License-Identifier: BSD-3-Clause
// The interface of content.
#include "core/light_field/light_field_source.h"

#include <stdexcept>

#include "core/light_field/light_field.h"

namespace hogelscope {

Rgb LightFieldSource::texel(const TexelIndex& at) const {
  const auto footprint = [this, &at] {
    Footprint one(size().nx, size().ny);
    one.u[std::size_t(at.i)] = {at.u, at.u};
    one.v[std::size_t(at.j)] = {at.v, at.v};
    return one;
  };
  return slice(footprint, {})->texel(at);
}

std::shared_ptr<const LightField> StreamedLightField::slice(
    const std::function<Footprint()>& /*footprint*/, const Progress& /*progress*/) const {
  throw std::logic_error("StreamedLightField: its texels come once, from the top");
}

std::shared_ptr<const LightField> StreamedLightField::overview() const {
  return slice({}, {});
}

}  // namespace hogelscope
