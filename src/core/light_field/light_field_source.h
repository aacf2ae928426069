// SPDX-License-Identifier: BSD-3-Clause
// The interface of content: the source of the directional pixels of views.
#pragma once

#include <functional>
#include <memory>

#include "core/base/progress.h"
#include "core/light_field/footprint.h"
#include "core/light_field/texel.h"

namespace hogelscope {

class LightField;

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

  /// Returns at least the texels of a footprint, in memory. `footprint` casts all rays of a view,
  /// so a source that has everything in memory does not call it. Throws InputError, Cancelled.
  [[nodiscard]] virtual std::shared_ptr<const LightField> slice(
      const std::function<Footprint()>& footprint, const Progress& progress) const = 0;

  /// Returns a small light field of the same panel for a first look: fewer hogels and directions,
  /// evenly spread; the whole light field where it is in memory. Throws InputError.
  [[nodiscard]] virtual std::shared_ptr<const LightField> overview() const = 0;

  /// Whether slice() gives the whole light field, at no cost: texels may then be copied unsummed.
  [[nodiscard]] virtual bool isInMemory() const { return false; }

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
  [[nodiscard]] std::shared_ptr<const LightField> slice(const std::function<Footprint()>& footprint,
                                                        const Progress& progress) const override;
  [[nodiscard]] std::shared_ptr<const LightField> overview() const override;

 private:
  LightFieldSize m_size;
  StoredType m_type;
};

}  // namespace hogelscope
