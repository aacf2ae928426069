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
  [[nodiscard]] Rgb texel(const TexelIndex& at) const override { return m_panel->texel(at); }
  [[nodiscard]] plugin::Triangles triangles() const override { return m_scene->triangles(); }
  [[nodiscard]] std::optional<std::array<double, 2>> depths() const override {
    return m_scene->depths();
  }
  void trace(const Vec3& eye, std::span<const Vec2> slopes, std::span<Rgb> light) const override {
    m_scene->trace(eye, slopes, light);
  }
  void traceRays(std::span<const PanelRay> rays, std::span<Rgb> light) const override {
    m_scene->traceRays(rays, light);
  }
  void traceDepths(const Vec3& eye, std::span<const Vec2> slopes,
                   std::span<double> depths) const override {
    m_scene->traceDepths(eye, slopes, depths);
  }

 private:
  std::shared_ptr<const LightFieldSource> m_panel;
  std::shared_ptr<const LightFieldSource> m_scene;
};

}  // namespace

WovenFile::WovenFile(std::unique_ptr<LightFieldFile> views, LensSheet sheet, bool isLive)
    : m_views(std::move(views)), m_sheet(std::move(sheet)), m_isLive(isLive) {
  const LightFieldSize size = m_views->size();
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
  return std::make_shared<const WovenScene>(std::move(panel), m_views->source(use, {}));
}

LightField WovenFile::read(const Progress& progress) {
  return readStreamed(files().empty() ? "" : files().front(), "", progress);
}

void WovenFile::stream(const HogelRow& row, const Progress& progress) {
  constexpr double reading = 0.5;
  const LightField views = m_views->read(part(progress, 0, reading));
  const Progress weaving = part(progress, reading, 1);
  const auto [width, height, one, other] = size();
  const auto [across, down, count, rows] = views.size();
  withStoredType(type(), [&, width = width, height = height, across = across, down = down,
                          count = count](auto zero) {
    using T = decltype(zero);
    const auto& texels = std::get<TexelArray<T>>(views.texels());
    constexpr int band = 64;
    std::vector<T> values(std::size_t(3) * std::size_t(width) * band);
    for (int first = 0; first < height; first += band) {
      reportProgress(weaving, double(first) / height);
      const int last = std::min(first + band, height);
      parallelRows(last - first, [&](int begin, int end) {
        for (int y = first + begin; y < first + end; ++y) {
          T* to = values.data() + std::ptrdiff_t(3) * width * (y - first);
          // The view's pixel at the middle of the panel's.
          const int j = int((2 * std::int64_t(y) + 1) * down / (2 * std::int64_t(height)));
          for (int x = 0; x < width; ++x, to += 3) {
            const int i = int((2 * std::int64_t(x) + 1) * across / (2 * std::int64_t(width)));
            const auto texelOf = [&](std::size_t channel) {
              return texels[views.layout().address(
                  {i, j, m_sheet.viewOf(x, y, channel, count), 0})];
            };
            to[0] = texelOf(0).r;
            to[1] = texelOf(1).g;
            to[2] = texelOf(2).b;
          }
        }
      });
      for (int y = first; y < last; ++y)
        row(y, 0, StoredRows(values.data() + std::ptrdiff_t(3) * width * (y - first)));
    }
  });
}

}  // namespace hogelscope
