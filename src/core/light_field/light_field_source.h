// SPDX-License-Identifier: BSD-3-Clause
// The interface of content: the source of the directional pixels of views.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/light_field/footprint.h"
#include "core/light_field/live_scene.h"
#include "core/light_field/slice_layout.h"
#include "core/light_field/texel.h"

namespace hogelscope {

class LightField;

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

  /// Returns the scene of a live light field, which lives as long as this; null for a stored one.
  [[nodiscard]] virtual const LiveScene* scene() const { return nullptr; }

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
