// SPDX-License-Identifier: BSD-3-Clause
// The interface of content: the source of the directional pixels of views.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/progress.h"
#include "core/light_field/footprint.h"
#include "core/light_field/slice_layout.h"
#include "core/light_field/texel.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

class LightField;

/// A ray of light in the display frame: its point on the panel (metres) and its slopes dx/dz, dy/dz
/// toward the viewer.
struct PanelRay {
  Vec2 position;
  Vec2 slopes;
};

/// The texels that a view reads. Both functions cast all of its rays.
struct ViewReads {
  std::function<Footprint()> footprint;
  /// Sets the marks of the texels that the view reads; `marks` has all texels of its footprint's
  /// layout. Empty if the view reads all of its footprint.
  std::function<void(const SliceLayout& layout, std::vector<std::uint8_t>& marks)> mark;
};

/// Returns the reads of all texels with these j, u and v.
ViewReads readsOfRows(const LightFieldSize& size, const CellRange& j, const CellRange& u,
                      const CellRange& v);

/// What is wrong with "lightField.layout" where an ideal view is wanted of what is not live.
inline constexpr const char* noIdealView = "is not \"live\": only a 3-D scene has an ideal view";

/// A light field in memory, in a store, or computed on demand. All functions may be
/// called from several threads at the same time.
class LightFieldSource {
 public:
  LightFieldSource() = default;
  LightFieldSource(const LightFieldSource&) = default;
  LightFieldSource& operator=(const LightFieldSource&) = default;
  virtual ~LightFieldSource() = default;

  [[nodiscard]] virtual LightFieldSize size() const = 0;
  [[nodiscard]] virtual StoredType type() const = 0;

  /// Returns at least the texels that a view reads, in memory. Throws InputError, Cancelled.
  [[nodiscard]] virtual std::shared_ptr<const LightField> slice(const ViewReads& reads,
                                                                const Progress& progress) const = 0;

  /// Returns a small light field of the same panel for a first look: fewer hogels and directions,
  /// evenly spread; the whole light field where it is in memory. Throws InputError.
  [[nodiscard]] virtual std::shared_ptr<const LightField> overview() const = 0;

  /// Whether slice() gives the whole light field, at no cost: texels may then be copied unsummed.
  [[nodiscard]] virtual bool isInMemory() const { return false; }

  /// Computes the light that an eye receives from the scene itself, without a display, along slopes
  /// dx/dz, dy/dz. The eye is in the display frame, in metres; the spans have one size. May be
  /// called from several threads. Throws InputError for content that is not a live scene.
  virtual void trace(const Vec3& eye, std::span<const Vec2> slopes, std::span<Rgb> light) const;

  /// Computes the light of a live scene along rays that leave the panel as texels' do. Throws
  /// likewise.
  virtual void traceRays(std::span<const PanelRay> rays, std::span<Rgb> light) const;

  /// Finds the depths z (display frame, metres) of what trace() sees; NaN for a ray that meets
  /// nothing. Content that does not know its depths is cut at ever more of them, and the depth is
  /// where the light becomes that of the whole content: to a thousandth of the content's range, and
  /// NaN where content has the background's colour. Throws likewise.
  virtual void traceDepths(const Vec3& eye, std::span<const Vec2> slopes,
                           std::span<double> depths) const;

  /// Returns the triangles that the 3-D scene draws for a live scene; none for other light fields.
  /// Throws InputError.
  [[nodiscard]] virtual plugin::Triangles triangles() const { return {}; }

  /// Returns the depths of a live scene's content in the display frame, in metres, the back one
  /// first; none for other light fields.
  [[nodiscard]] virtual std::optional<std::array<double, 2>> depths() const { return {}; }

  /// Returns one texel; the index must lie in the light field. Throws InputError.
  [[nodiscard]] virtual Rgb texel(const TexelIndex& at) const;
};

/// The size and the type of a light field that StreamingRenderer reads once, from the top.
class StreamedLightField : public LightFieldSource {
 public:
  StreamedLightField(const LightFieldSize& size, StoredType type) : m_size(size), m_type(type) {}

  [[nodiscard]] LightFieldSize size() const override { return m_size; }
  [[nodiscard]] StoredType type() const override { return m_type; }
  /// Throws std::logic_error, as overview() does.
  [[nodiscard]] std::shared_ptr<const LightField> slice(const ViewReads& reads,
                                                        const Progress& progress) const override;
  [[nodiscard]] std::shared_ptr<const LightField> overview() const override;

 private:
  LightFieldSize m_size;
  StoredType m_type;
};

}  // namespace hogelscope
