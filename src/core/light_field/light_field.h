// SPDX-License-Identifier: BSD-3-Clause
// The light field: every hogel's directional pixels, in memory. First on the line
// LightField → Display → Camera → Distortion → PSF → Image → Metrics → Report.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/base/huge_pages.h"
#include "core/base/parameters.h"
#include "core/light_field/block_layout.h"
#include "core/light_field/light_field_source.h"
#include "core/light_field/slice_layout.h"

namespace hogelscope {

enum class Layout { hogels, views, quilt, pack };
enum class RowOrder { topDown, bottomUp };
enum class ColumnOrder { leftRight, rightLeft };

/// The session's `lightField`: where the content is and how its file is laid out.
struct LightFieldParams {
  std::string file;
  Layout layout = Layout::hogels;
  bool incoming = false;
  RowOrder rows = RowOrder::topDown;
  ColumnOrder columns = ColumnOrder::leftRight;
  std::string pattern;
  std::array<double, 2> shear{0, 0};
  int quiltColumns = 0;
  int quiltRows = 0;
  bool operator==(const LightFieldParams&) const = default;
};

/// Visits only the fields that the layout has.
void describe(ParameterVisitor& v, LightFieldParams& p);

/// A directional pixel as it is stored; `unused` makes it a power of two of bytes.
template <class T>
struct Texel {
  T r{};
  T g{};
  T b{};
  T unused{};
};

template <class T>
using TexelArray = std::vector<Texel<T>, HugePageAllocator<Texel<T>>>;

/// Stored values: 16-bit ones are /257 code values, floating ones ·255. In memory the texels lie in
/// 4-D blocks, and one black texel follows them: what a ray that sees nothing can read.
class LightField final : public LightFieldSource, public std::enable_shared_from_this<LightField> {
 public:
  /// Three values a texel, in the raster of the hogel image: texel (i, j, u, v) is at column
  /// i·du + u, row j·dv + v.
  using Values =
      std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>>;
  using Texels =
      std::variant<TexelArray<std::uint8_t>, TexelArray<std::uint16_t>, TexelArray<float>>;

  /// Cells of a block along i, j, u, v, as powers of two: measured, see docs/measurements.md.
  static constexpr std::array<std::uint32_t, 4> standardBlock{3, 3, 3, 3};

  /// Black. Throws std::length_error beyond 2^32 - 2 texels.
  LightField(LightFieldSize size, StoredType type,
             const std::array<std::uint32_t, 4>& block = standardBlock);
  /// From a hogel image. Throws std::invalid_argument unless there are 3·width·height values.
  LightField(LightFieldSize size, const Values& values);
  /// Black, and only a slice in memory: no other texel may be asked for.
  LightField(LightFieldSize size, StoredType type, SliceLayout slice);

  /// Bytes that a light field of this size takes in memory.
  static std::size_t bytes(const LightFieldSize& size, StoredType type);

  [[nodiscard]] LightFieldSize size() const override { return m_size; }
  [[nodiscard]] const BlockLayout& layout() const { return m_layout; }
  [[nodiscard]] const Texels& texels() const { return m_texels; }
  [[nodiscard]] StoredType type() const override {
    return static_cast<StoredType>(m_texels.index());
  }
  /// Itself, which a std::shared_ptr must own.
  [[nodiscard]] std::shared_ptr<const LightField> slice(
      const std::function<Footprint()>& /*footprint*/,
      const Progress& /*progress*/) const override {
    return shared_from_this();
  }
  [[nodiscard]] std::shared_ptr<const LightField> overview() const override {
    return shared_from_this();
  }
  /// False for a slice.
  [[nodiscard]] bool isInMemory() const override { return !m_slice; }
  [[nodiscard]] Rgb texel(const TexelIndex& at) const override;
  /// Whether a slice has the texels.
  [[nodiscard]] bool covers(const Footprint& footprint) const {
    return !m_slice || m_slice->footprint.covers(footprint);
  }
  /// T must be the stored type.
  template <class T>
  void set(const TexelIndex& at, const T* rgb) {
    std::get<TexelArray<T>>(m_texels)[m_layout.address(at)] = {rgb[0], rgb[1], rgb[2], T{}};
  }
  /// Neighbours along u in a slice, from `first` on; T must be the stored type.
  template <class T>
  void setRun(const TexelIndex& first, int count, const T* rgb) {
    auto* to = &std::get<TexelArray<T>>(m_texels)[m_layout.address(first)];
    for (int k = 0; k < count; ++k, rgb += 3) to[k] = {rgb[0], rgb[1], rgb[2], T{}};
  }
  /// Takes what a slice has of directions (·, v) of hogels (·, j) from the hogel image's row. T
  /// must be the stored type, v in the slice.
  template <class T>
  void takeRow(int j, int v, const T* rgb);

 private:
  LightFieldSize m_size;
  std::shared_ptr<const SliceLayout> m_slice;
  BlockLayout m_layout;
  Texels m_texels;
};

}  // namespace hogelscope
