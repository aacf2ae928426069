// SPDX-License-Identifier: BSD-3-Clause
#include "texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hogelscope::mesh {

namespace {

/// Returns the texel of 0 … n − 1 at position k.
std::size_t wrapped(double k, int n, Wrap wrap) {
  if (wrap == Wrap::clamp) return std::size_t(std::clamp(k, 0.0, double(n - 1)));
  const double period = wrap == Wrap::repeat ? n : 2.0 * n;
  const double place = std::clamp(k - period * std::floor(k / period), 0.0, period - 1);
  return std::size_t(place < n ? place : period - 1 - place);
}

/// The positions of a coarser row's texel in a finer row, with their weights.
struct Box {
  int first = 0;
  std::array<double, 3> weights{};
};

/// Returns the box of texel k of `to`, which covers from/to texels of `from`: two, or parts of up
/// to three if `from` is odd.
Box boxOf(int k, int from, int to) {
  const double width = double(from) / to;
  Box box{int(std::floor(k * width)), {}};
  for (int i = 0; i < 3; ++i) {
    const double left = std::max<double>(box.first + i, k * width);
    const double right = std::min<double>(box.first + i + 1, (k + 1) * width);
    box.weights[std::size_t(i)] = std::max(0.0, right - left) / width;
  }
  return box;
}

}  // namespace

Texture::Texture(const Picture& picture, const Reading& reading) {
  std::array<std::uint16_t, 256> linear{};
  for (std::size_t k = 0; k < linear.size(); ++k)
    linear[k] = std::uint16_t(std::lround(65535 * linearOf(double(k) / 255)));
  Level level{picture.width, picture.height, std::vector<std::uint16_t>(picture.rgb.size())};
  std::transform(picture.rgb.begin(), picture.rgb.end(), level.texels.begin(),
                 [&](std::uint8_t code) { return linear[code]; });
  m_levels.push_back(std::move(level));
  while (m_levels.back().width > 1 || m_levels.back().height > 1)
    m_levels.push_back(halved(m_levels.back(), reading));
}

Texture::Level Texture::halved(const Level& level, const Reading& reading) {
  Level half{std::max(1, level.width / 2), std::max(1, level.height / 2), {}};
  half.texels.reserve(std::size_t(half.width) * std::size_t(half.height) * 3);
  for (int y = 0; y < half.height; ++y) {
    if (constexpr int someRows = 64; y % someRows == 0) reading.poll();
    const Box rows = boxOf(y, level.height, half.height);
    for (int x = 0; x < half.width; ++x) {
      const Box columns = boxOf(x, level.width, half.width);
      std::array<double, 3> sum{};
      for (int k = 0; k < 9; ++k) {
        const double weight =
            rows.weights[std::size_t(k / 3)] * columns.weights[std::size_t(k % 3)];
        if (weight == 0) continue;
        const int texel = (rows.first + k / 3) * level.width + columns.first + k % 3;
        for (std::size_t c = 0; c < 3; ++c)
          sum[c] += weight * level.texels[std::size_t(texel) * 3 + c];
      }
      for (const double light : sum) half.texels.push_back(std::uint16_t(std::lround(light)));
    }
  }
  return half;
}

Linear Texture::Level::sample(double u, double v, const Wrap wrap[2]) const {
  const double x = u * width - 0.5;
  const double y = v * height - 0.5;
  const double left = std::floor(x);
  const double top = std::floor(y);
  const auto fx = float(x - left);
  const auto fy = float(y - top);
  const std::size_t columns[2]{wrapped(left, width, wrap[0]), wrapped(left + 1, width, wrap[0])};
  const std::size_t rows[2]{wrapped(top, height, wrap[1]), wrapped(top + 1, height, wrap[1])};
  const auto texel = [&](int i, int j, std::size_t c) {
    return float(texels[(rows[j] * std::size_t(width) + columns[i]) * 3 + c]);
  };
  Linear light{};
  for (std::size_t c = 0; c < 3; ++c)
    light[c] = ((1 - fy) * ((1 - fx) * texel(0, 0, c) + fx * texel(1, 0, c)) +
                fy * ((1 - fx) * texel(0, 1, c) + fx * texel(1, 1, c))) /
               65535;
  return light;
}

Linear Texture::sample(double u, double v, double level, const Wrap wrap[2]) const {
  const double coarsest = double(m_levels.size() - 1);
  const double at = level > 0 ? std::min(level, coarsest) : 0;
  const auto fine = std::size_t(at);
  Linear light = m_levels[fine].sample(u, v, wrap);
  const auto part = float(at - double(fine));
  if (part == 0) return light;
  const Linear coarse = m_levels[fine + 1].sample(u, v, wrap);
  for (std::size_t c = 0; c < 3; ++c) light[c] += part * (coarse[c] - light[c]);
  return light;
}

}  // namespace hogelscope::mesh
