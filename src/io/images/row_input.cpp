// SPDX-License-Identifier: BSD-3-Clause
// Converts rows of 8 or 16 bits.
#include "io/images/image_inputs.h"

#include <algorithm>
#include <limits>

namespace hogelscope {

namespace {

template <class To, class From>
To converted(From value) {
  if constexpr (std::is_same_v<To, float>)
    return float(value) / std::numeric_limits<From>::max();
  else if constexpr (sizeof(To) > sizeof(From))
    return To(value * 257);  // 255 becomes 65535
  else
    return To((value + 128U) / 257U);
}

}  // namespace

template <class From, class To>
void RowInput::readAs(std::size_t first, std::size_t rows, To* rgb) {
  const std::size_t count = 3 * m_facts.width;
  std::vector<From> stored(std::is_same_v<From, To> ? 0 : count);
  for (std::size_t y = first; y < first + rows; ++y, rgb += count) {
    if constexpr (std::is_same_v<From, To>) {
      readRow(y, rgb);
    } else {
      readRow(y, stored.data());
      std::ranges::transform(stored, rgb, converted<To, From>);
    }
  }
}

void RowInput::read(std::size_t /*frame*/, std::size_t first, std::size_t rows, const Rows& to) {
  std::visit(
      [&](auto* rgb) {
        if (m_facts.type == StoredType::uint8)
          readAs<std::uint8_t>(first, rows, rgb);
        else
          readAs<std::uint16_t>(first, rows, rgb);
      },
      to);
}

}  // namespace hogelscope
