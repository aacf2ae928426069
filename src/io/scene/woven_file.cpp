// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/woven_file.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/text.h"

namespace hogelscope {

namespace {

/// A panel's pixels, and the live scene that they show.
class WovenScene : public LightFieldSource {
 public:
  WovenScene(std::shared_ptr<const LightFieldSource> panel,
             std::shared_ptr<const LightFieldSource> scene)
      : m_panel(std::move(panel)), m_scene(std::move(scene)) {}

  [[nodiscard]] LightFieldSize size() const override { return m_panel->size(); }
  [[nodiscard]] StoredType type() const override { return m_panel->type(); }
  [[nodiscard]] std::shared_ptr<const LightField> slice(const ViewReads& reads,
                                                        const Progress& progress) const override {
    return m_panel->slice(reads, progress);
  }
  [[nodiscard]] std::shared_ptr<const LightField> overview() const override {
    return m_panel->overview();
  }
  [[nodiscard]] bool isInMemory() const override { return true; }
  [[nodiscard]] const LiveScene* scene() const override { return m_scene->scene(); }

 private:
  std::shared_ptr<const LightFieldSource> m_panel;
  std::shared_ptr<const LightFieldSource> m_scene;
};

}  // namespace

WovenFile::WovenFile(std::unique_ptr<LightFieldFile> views, LensSheet sheet, bool isLive)
    : WrappedFile(std::move(views)), m_sheet(std::move(sheet)), m_isLive(isLive) {
  const LightFieldSize size = content().size();
  if (size.dv != 1)
    throw InputError("lightField", "has " + pairText(size.du, size.dv) +
                                       " views, but a lens sheet shows one row of them");
}

LightFieldSize WovenFile::size() const {
  const auto [width, height] = m_sheet.calibration().params.panel;
  return {width, height, 1, 1};
}

std::shared_ptr<const LightFieldSource> WovenFile::source(const SourceUse& use,
                                                          const Progress& progress) {
  auto panel = LightFieldFile::source(use, progress);
  if (!m_isLive) return panel;
  return std::make_shared<const WovenScene>(std::move(panel), content().source(use, {}));
}

void WovenFile::stream(const HogelRow& row, const Progress& progress) {
  constexpr double reading = 0.5;
  const LightField views = content().read(part(progress, 0, reading));
  const Progress weaving = part(progress, reading, 1);
  const auto [width, height, one, other] = size();
  const auto [across, down, count, rows] = views.size();
  withStoredType(type(), [&, width = width, height = height, across = across, down = down,
                          count = count](auto zero) {
    using T = decltype(zero);
    const auto& texels = std::get<TexelArray<T>>(views.texels());
    const BlockLayout& layout = views.layout();
    // The view's pixel at the middle of the panel's, and the parts of texels' addresses.
    const auto at = [](int pixel, int own, int panel) {
      return std::uint32_t((2 * std::int64_t(pixel) + 1) * own / (2 * std::int64_t(panel)));
    };
    std::vector<std::uint32_t> ofColumn(std::size_t(width), 0);
    std::vector<std::uint32_t> ofView(std::size_t(count), 0);
    for (int x = 0; x < width; ++x) ofColumn[std::size_t(x)] = layout.i(at(x, across, width));
    for (int u = 0; u < count; ++u) ofView[std::size_t(u)] = layout.u(std::uint32_t(u));
    constexpr int band = 64;
    std::vector<T> values(std::size_t(3) * std::size_t(width) * band);
    for (int first = 0; first < height; first += band) {
      reportProgress(weaving, double(first) / height);
      const int last = std::min(first + band, height);
      parallelRows(last - first, [&](int begin, int end) {
        std::vector<int> shown(std::size_t(width), 0);
        for (int y = first + begin; y < first + end; ++y) {
          const auto* const texelsOfRow = texels.data() + layout.j(at(y, down, height));
          T* const to = values.data() + std::ptrdiff_t(3) * width * (y - first);
          for (std::size_t channel = 0; channel < 3; ++channel) {
            m_sheet.viewsOf(y, channel, count, shown);
            for (std::size_t x = 0; x < shown.size(); ++x) {
              const Texel<T>& texel = texelsOfRow[ofColumn[x] + ofView[std::size_t(shown[x])]];
              to[3 * x + channel] = channel == 0 ? texel.r : channel == 1 ? texel.g : texel.b;
            }
          }
        }
      });
      for (int y = first; y < last; ++y)
        row(y, 0, StoredRows(values.data() + std::ptrdiff_t(3) * width * (y - first)));
    }
  });
}

}  // namespace hogelscope
