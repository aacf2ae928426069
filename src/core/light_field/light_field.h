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
#include "core/base/progress.h"
#include "core/light_field/block_layout.h"
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

/// nx × ny hogels of du × dv directional pixels.
struct LightFieldSize {
  int nx = 0;
  int ny = 0;
  int du = 0;
  int dv = 0;
  [[nodiscard]] std::size_t width() const { return std::size_t(nx) * std::size_t(du); }
  [[nodiscard]] std::size_t height() const { return std::size_t(ny) * std::size_t(dv); }
  bool operator==(const LightFieldSize&) const = default;
};

/// Which directional pixel: hogel (i, j) from the panel's top left, direction (u, v): u grows for
/// light leaving to the right, v = 0 leaves upwards.
struct TexelIndex {
  int i = 0;
  int j = 0;
  int u = 0;
  int v = 0;
  bool operator==(const TexelIndex&) const = default;
};

/// Red, green, blue in code values: 0 … 255 is the range of an 8-bit picture, fractions kept.
struct Rgb {
  double r = 0;
  double g = 0;
  double b = 0;
  bool operator==(const Rgb&) const = default;
};

constexpr Rgb operator+(const Rgb& a, const Rgb& b) {
  return {a.r + b.r, a.g + b.g, a.b + b.b};
}
constexpr Rgb operator*(double s, const Rgb& c) {
  return {s * c.r, s * c.g, s * c.b};
}

enum class StoredType { uint8, uint16, real };

/// A directional pixel as it is stored; `unused` makes it a power of two of bytes.
template <class T>
struct Texel {
  T r{};
  T g{};
  T b{};
  T unused{};
};

/// Of a texel in memory.
constexpr std::size_t memoryBytes(StoredType type) {
  return std::array<std::size_t, 3>{4, 8, 16}[std::size_t(type)];
}

template <class T>
using TexelArray = std::vector<Texel<T>, HugePageAllocator<Texel<T>>>;

class LightField;

/// Where the texels of a light field are that memory cannot hold.
class TexelStore {
 public:
  TexelStore() = default;
  TexelStore(const TexelStore&) = delete;
  TexelStore& operator=(const TexelStore&) = delete;
  virtual ~TexelStore() = default;

  /// The footprint's texels at least. May be called from several threads. Throws InputError
  /// (damaged file), Cancelled.
  virtual std::shared_ptr<const LightField> slice(const Footprint& footprint,
                                                  const Progress& progress) = 0;
  /// A small light field of the same panel for a first look: fewer hogels and directions, evenly
  /// spread. All in memory.
  [[nodiscard]] virtual std::shared_ptr<const LightField> overview() const = 0;
};

/// Stored values: 16-bit ones are /257 code values, floating ones ·255. In memory the texels lie in
/// 4-D blocks, and one black texel follows them: what a ray that sees nothing can read.
class LightField {
 public:
  /// Three values a texel, in the raster of the hogel image: texel (i, j, u, v) is at column
  /// i·du + u, row j·dv + v.
  using Values =
      std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>>;
  using Texels =
      std::variant<TexelArray<std::uint8_t>, TexelArray<std::uint16_t>, TexelArray<float>>;

  /// Cells of a block along i, j, u, v, as powers of two: measured, see ARCHITECTURE.md.
  static constexpr std::array<std::uint32_t, 4> standardBlock{3, 3, 3, 3};

  /// Black. Throws std::length_error beyond 2^32 - 2 texels.
  LightField(LightFieldSize size, StoredType type,
             const std::array<std::uint32_t, 4>& block = standardBlock);
  /// From a hogel image. Throws std::invalid_argument unless there are 3·width·height values.
  LightField(LightFieldSize size, const Values& values);
  /// Black, and only a slice in memory: no other texel may be asked for.
  LightField(LightFieldSize size, StoredType type, SliceLayout slice);
  /// Nothing in memory; views take slices of it. A null store serves where no texel is asked for.
  LightField(LightFieldSize size, StoredType type, std::shared_ptr<TexelStore> store);

  /// Bytes that a light field of this size takes in memory.
  static std::size_t bytes(const LightFieldSize& size, StoredType type);

  [[nodiscard]] const LightFieldSize& size() const { return m_size; }
  [[nodiscard]] const BlockLayout& layout() const { return m_layout; }
  [[nodiscard]] const Texels& texels() const { return m_texels; }
  [[nodiscard]] StoredType type() const { return static_cast<StoredType>(m_texels.index()); }
  /// Null for a light field that is all in memory.
  [[nodiscard]] const SliceLayout* slice() const { return m_slice.get(); }
  [[nodiscard]] TexelStore* store() const { return m_store.get(); }
  /// The index must lie in the light field.
  [[nodiscard]] Rgb texel(const TexelIndex& at) const;
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
  std::shared_ptr<TexelStore> m_store;
  BlockLayout m_layout;
  Texels m_texels;
};

}  // namespace hogelscope
