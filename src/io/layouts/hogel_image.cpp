// SPDX-License-Identifier: BSD-3-Clause
// Layout "hogels": one image of hogel tiles.
#include "io/layouts/hogel_image.h"

#include <algorithm>

#include "core/base/error.h"
#include "io/layouts/texel_placement.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Flips directions that were recorded looking into the scene: each hogel's row backwards.
template <class T>
void turnHogels(const LightFieldSize& size, const T* rgb, std::vector<T>& turned) {
  turned.resize(3 * size.width());
  for (int i = 0; i < size.nx; ++i)
    for (int u = 0; u < size.du; ++u)
      std::copy_n(rgb + std::ptrdiff_t(3) * (i * size.du + u), 3,
                  &turned[std::size_t(3) * std::size_t((i + 1) * size.du - 1 - u)]);
}

class HogelImage : public LightFieldFile {
 public:
  HogelImage(const LightFieldParams& params, const DisplayParams& display)
      : m_params(params),
        m_image(params.file, params.yuv),
        m_size{display.hogels[0], display.hogels[1], display.directions[0], display.directions[1]} {
    if (m_size.nx < 1 || m_size.ny < 1 || m_size.du < 1 || m_size.dv < 1)
      throw InputError(params.file, "size",
                       "is " + pixels(m_image.width(), m_image.height()) +
                           " px; how many of them are hogels and directions it does not say: give "
                           "display.hogels and display.directions");
    if (m_image.width() != m_size.width() || m_image.height() != m_size.height())
      throw InputError(params.file, "size",
                       "is " + pixels(m_image.width(), m_image.height()) + " px, but " +
                           pixels(std::size_t(m_size.nx), std::size_t(m_size.ny)) + " hogels of " +
                           pixels(std::size_t(m_size.du), std::size_t(m_size.dv)) +
                           " directions need " + pixels(m_size.width(), m_size.height()));
  }

  [[nodiscard]] StoredType type() const override { return m_image.type(); }
  [[nodiscard]] int bits() const override { return m_image.bits(); }
  [[nodiscard]] LightFieldSize size() const override { return m_size; }
  [[nodiscard]] std::vector<fs::path> files() const override { return {m_image.file()}; }

  [[nodiscard]] LightField read(const Progress& progress) override {
    LightField lightField = blankLightField(m_size, m_image.type(), m_params.file, packIt);
    const auto target = [this](int x, int y) {
      return std::optional(TexelIndex{x / m_size.du, y / m_size.dv, x % m_size.du, y % m_size.dv});
    };
    readTexels(m_image, m_image.type(), lightField, m_params.incoming, target, progress);
    return lightField;
  }

  [[nodiscard]] bool isStream() const override { return true; }
  void stream(const HogelRow& row, const Progress& progress) override {
    m_image.read(
        m_image.type(),
        [&](std::size_t first, std::size_t rows, const StoredRows& values) {
          std::visit(
              [&](const auto* rgb) {
                for (std::size_t k = 0; k < rows; ++k)
                  hand(int(first + k), rgb + 3 * k * m_size.width(), row);
              },
              values);
        },
        progress);
  }

 private:
  template <class T>
  void hand(int y, const T* rgb, const HogelRow& row) const {
    if (!m_params.incoming) return row(y / m_size.dv, y % m_size.dv, rgb);
    std::vector<T> turned;
    turnHogels(m_size, rgb, turned);
    row(y / m_size.dv, m_size.dv - 1 - y % m_size.dv, turned.data());
  }

  LightFieldParams m_params;
  ImageFile m_image;
  LightFieldSize m_size;
};

}  // namespace

std::unique_ptr<LightFieldFile> openHogelImage(const LightFieldParams& params,
                                               const DisplayParams& display) {
  return std::make_unique<HogelImage>(params, display);
}

}  // namespace hogelscope
