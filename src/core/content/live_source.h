// SPDX-License-Identifier: BSD-3-Clause
// A light field that is computed for each view: only those of the display's rays that the view
// needs are traced through a 3-D scene (docs/formulas.md, Live scenes). A view marks the texels
// that it reads within its footprint, since a view with a distorted lens reads only a third of it;
// only these are traced, tile after tile.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "core/base/parallel.h"
#include "core/light_field/light_field.h"
#include "core/panel/display.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

class LiveSource : public LightFieldSource, public LiveScene {
 public:
  /// `display` must have its hogels and directions, and `content` must be open for it. slice()
  /// allocates at most `memory` bytes for texels.
  LiveSource(std::shared_ptr<const plugin::ContentSource> content, const PanelParams& display,
             const LiveParams& params, StoredType type, std::size_t memory,
             ParallelRows rows = parallelRows);

  [[nodiscard]] const plugin::ContentSource& content() const { return *m_content; }
  /// Returns the same of other content, which must be open for the display.
  [[nodiscard]] std::shared_ptr<const LiveSource> withContent(
      std::shared_ptr<const plugin::ContentSource> content) const {
    return std::make_shared<const LiveSource>(std::move(content), m_params, m_live, m_type,
                                              m_memory, m_rows);
  }

  [[nodiscard]] LightFieldSize size() const override { return m_display.size(); }
  [[nodiscard]] StoredType type() const override { return m_type; }
  /// Traces the texels that the view reads. They are the same to the last bit for any view, thread
  /// count and block of texels.
  [[nodiscard]] std::shared_ptr<const LightField> slice(const ViewReads& reads,
                                                        const Progress& progress) const override;
  /// Traces at most 64×64 hogels of 16×16 directions of the same panel, by their middle rays.
  [[nodiscard]] std::shared_ptr<const LightField> overview() const override;
  [[nodiscard]] const LiveScene* scene() const override { return this; }
  [[nodiscard]] plugin::Triangles triangles() const override { return m_content->triangles(); }
  [[nodiscard]] std::array<double, 2> depths() const override;
  [[nodiscard]] double duration() const override { return m_content->duration(); }
  void trace(const Vec3& eye, std::span<const Vec2> slopes, std::span<Rgb> light) const override;
  void traceRays(std::span<const PanelRay> rays, std::span<Rgb> light) const override;
  void traceDepths(const Vec3& eye, std::span<const Vec2> slopes,
                   std::span<double> depths) const override;

 private:
  /// One point of the lattice: the position of each hogel and the slope of each direction there.
  struct Sample {
    std::vector<double> x, y, a, b;
  };

  [[nodiscard]] std::vector<plugin::Ray> raysFrom(const Vec3& eye,
                                                  std::span<const Vec2> slopes) const;
  void traceAll(std::span<const plugin::Ray> rays, std::span<Rgb> light) const;
  void bisectDepths(std::vector<plugin::Ray> rays, std::span<double> depths) const;
  template <class T>
  void fill(const std::vector<std::uint8_t>& marks, LightField& texels,
            const Progress& progress) const;
  struct Work;
  template <class T>
  void fillRows(int j0, int j1, const std::vector<std::uint8_t>& marks, Work& work,
                LightField& texels, const Progress& progress) const;
  template <class T>
  void traceTexels(Work& work, std::size_t texelCount, LightField& texels) const;

  std::shared_ptr<const plugin::ContentSource> m_content;
  PanelParams m_params;
  LiveParams m_live;
  Display m_display;
  StoredType m_type;
  std::size_t m_memory;
  ParallelRows m_rows;
  double m_back;
  double m_front;
  std::vector<Sample> m_samples;
  mutable std::once_flag m_overviewIsTraced;
  mutable std::shared_ptr<const LightField> m_overview;
};

}  // namespace hogelscope
