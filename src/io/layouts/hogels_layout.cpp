// SPDX-License-Identifier: BSD-3-Clause
// Layout "hogels": one image of hogel tiles.
#include <algorithm>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/layouts/layouts.h"
#include "io/layouts/picture_files.h"

namespace hogelscope {

namespace {

/// Reverses each hogel's row, for directions that were recorded looking into the scene.
template <class T>
void turnHogels(const LightFieldSize& size, const T* rgb, std::vector<T>& turned) {
  turned.resize(3 * size.width());
  for (int i = 0; i < size.nx; ++i)
    for (int u = 0; u < size.du; ++u)
      std::copy_n(rgb + std::ptrdiff_t(3) * (i * size.du + u), 3,
                  &turned[std::size_t(3) * std::size_t((i + 1) * size.du - 1 - u)]);
}

class HogelImage : public PictureFiles {
 public:
  HogelImage(const LightFieldParams& params, const DisplayParams& display)
      : PictureFiles(params), m_image(params.file, params.yuv) {
    takeTypeOf(m_image);
    takeFramesOf(m_image);
    warnOf("the picture", m_image.notesOfOne());
    m_size = {display.hogels[0], display.hogels[1], display.directions[0], display.directions[1]};
    if (display.sheet) {
      takePanel(*display.sheet);
      return;
    }
    if (m_size.nx < 1 || m_size.ny < 1 || m_size.du < 1 || m_size.dv < 1)
      throw InputError(params.file, "size",
                       "is " + pairText(m_image.width(), m_image.height()) +
                           " px; how many of them are hogels and directions it does not say: give "
                           "display.hogels and display.directions");
    if (m_image.width() != m_size.width() || m_image.height() != m_size.height())
      throw InputError(params.file, "size",
                       "is " + pairText(m_image.width(), m_image.height()) + " px, but " +
                           pairText(m_size.nx, m_size.ny) + " hogels of " +
                           pairText(m_size.du, m_size.dv) + " directions need " +
                           pairText(m_size.width(), m_size.height()));
  }

  [[nodiscard]] LightField read(const Progress& progress) override {
    LightField lightField = blank(m_size.ny);
    m_image.select(frame());
    const auto target = [this](int x, int y) {
      return std::optional(TexelIndex{x / m_size.du, y / m_size.dv, x % m_size.du, y % m_size.dv});
    };
    readTexels(m_image, lightField, m_params.incoming, target, progress);
    return lightField;
  }

  [[nodiscard]] bool isStream() const override { return true; }
  void stream(const HogelRow& row, const Progress& progress) override {
    const auto hand = [&](std::size_t first, std::size_t rows, const StoredRows& values) {
      const auto handRows = [&](const auto* rgb) {
        for (std::size_t y = first; y < first + rows; ++y, rgb += 3 * m_size.width())
          handRow(int(y), rgb, row);
      };
      std::visit(handRows, values);
    };
    m_image.select(frame());
    m_image.read(type(), hand, progress);
  }

 private:
  /// The pixels of a lens sheet's panel are hogels of one direction.
  void takePanel(const SheetDisplay& sheet) {
    const auto [width, height] = sheet.calibration.params.panel;
    m_size = {width, height, 1, 1};
    if (m_image.width() != m_size.width() || m_image.height() != m_size.height())
      throw InputError(m_params.file, "size",
                       "is " + pairText(m_image.width(), m_image.height()) +
                           " px, but the lens sheet's panel has " + pairText(width, height));
  }

  template <class T>
  void handRow(int y, const T* rgb, const HogelRow& row) const {
    if (!m_params.incoming) return row(y / m_size.dv, y % m_size.dv, rgb);
    std::vector<T> turned;
    turnHogels(m_size, rgb, turned);
    row(y / m_size.dv, m_size.dv - 1 - y % m_size.dv, turned.data());
  }

  ImageFile m_image;
};

}  // namespace

const LayoutType hogelsLayout{
    .open = [](const LightFieldParams& params, const DisplayParams& display,
               const Progress&) -> std::unique_ptr<LightFieldFile> {
      return std::make_unique<HogelImage>(params, display);
    },
    .isWhole =
        [](const LightFieldParams&, const DisplayParams& display) {
          return display.hogels[0] > 0 && display.directions[0] > 0;
        },
    .words = [](const LightFieldParams&, const DisplayParams&) -> std::string { return "hogels"; },
    .foundBy = [](const LightFieldParams&) -> FoundBy {
      return {"borders of hogels in the picture", "borders of hogels in the picture",
              "display.directions"};
    }};

}  // namespace hogelscope
