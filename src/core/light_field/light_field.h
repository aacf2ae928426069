// SPDX-License-Identifier: BSD-3-Clause
// The light field: every hogel's directional pixels, in memory. The first stage of
// LightField → Display → Camera → Distortion → PSF → Image → Metrics → Report.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/huge_pages.h"
#include "core/base/parameters.h"
#include "core/light_field/block_layout.h"
#include "core/light_field/frames.h"
#include "core/light_field/layout_params.h"
#include "core/light_field/light_field_source.h"
#include "core/light_field/sheet_calibration.h"
#include "core/light_field/slice_layout.h"

namespace hogelscope {

enum class Layout { hogels, views, quilt, mosaic, lenslets, pack, live, woven };
/// The stored type of a live light field's texels; capture: 8 bits where the capture has 8.
enum class LiveType { uint8, real, capture };
enum class RowOrder { topDown, bottomUp };
enum class ColumnOrder { leftRight, rightLeft };
/// The order of views that are counted by one running number: row by row or column by column, each
/// from its beginning, or every second one from its end.
enum class ViewScan { raster, serpentine, columns, columnsSerpentine };
/// The tile of a quilt that is its first view.
enum class QuiltStart { bottomLeft, topLeft };

/// The session's `lightField`: the content's file and its layout, or a live scene.
struct LightFieldParams {
  std::string file;
  Layout layout = Layout::hogels;
  bool incoming = false;
  RowOrder rows = RowOrder::topDown;
  ColumnOrder columns = ColumnOrder::leftRight;
  std::string pattern;
  std::string exclude;
  ViewScan scan = ViewScan::raster;
  std::array<double, 2> shear{0, 0};
  double viewingDistance = notGiven;  ///< where the hogels' fields coincide, metres
  int quiltColumns = 0;
  int quiltRows = 0;
  QuiltStart quiltStart = QuiltStart::bottomLeft;
  LensletParams lenslets;
  YuvParams yuv;       ///< for files of raw YUV
  std::string source;  ///< name of a live scene's content
  LiveType type = LiveType::uint8;
  ContentParams content;  ///< of the source
  LiveParams live;        ///< of any source
  /// The lens sheet for which views are woven; none: the display's own.
  std::optional<SheetCalibration> calibration;
  std::string calibrationFile;         ///< the document that names it; "": none
  std::optional<FrameNumbers> frames;  ///< none: all that there are
  double fps = notGiven;               ///< frames of the source shown in a second
  [[nodiscard]] bool isLive() const { return layout == Layout::live; }
  bool operator==(const LightFieldParams&) const = default;
};

/// Whether a layout has parameters for the order and shear of a grid of views.
constexpr bool isGridOfViews(Layout layout) {
  return layout == Layout::views || layout == Layout::mosaic;
}

/// Whether the names of its files have the number of a frame, {T}.
bool isNumbered(const LightFieldParams& params);

/// Returns what messages call it: its file, that of a live scene, or else the scene's source.
std::string contentName(const LightFieldParams& params);

/// A directional pixel as stored; `unused` makes its size a power of two.
template <class T>
struct Texel {
  T r{};
  T g{};
  T b{};
  T unused{};
};

/// The code value of one that is stored.
constexpr double codeValue(std::uint8_t stored) {
  return stored;
}
constexpr double codeValue(std::uint16_t stored) {
  return stored / 257.0;
}
constexpr double codeValue(float stored) {
  return static_cast<double>(stored) * 255.0;
}

template <class T>
using TexelArray = std::vector<Texel<T>, HugePageAllocator<Texel<T>>>;

/// A light field in memory. Code values are 16-bit values / 257 and floating values · 255. The
/// texels lie in 4-D blocks; one black texel follows them, for rays that see nothing.
class LightField final : public LightFieldSource, public std::enable_shared_from_this<LightField> {
 public:
  /// Three values per texel, in the raster of the hogel image: texel (i, j, u, v) is at column
  /// i·du + u, row j·dv + v.
  using Values =
      std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>>;
  using Texels =
      std::variant<TexelArray<std::uint8_t>, TexelArray<std::uint16_t>, TexelArray<float>>;

  /// log2 of a block's cells along i, j, u, v, chosen by measurement (docs/measurements.md).
  static constexpr std::array<std::uint32_t, 4> standardBlock{3, 3, 3, 3};

  /// Returns the blocks of a light field of this size: standard ones, with fewer directions where
  /// padding would be more than a sixteenth of an axis. Of a panel behind a lens sheet, whose
  /// lenses show some columns of every row, a line of the cache is two columns.
  static std::array<std::uint32_t, 4> blockFor(const LightFieldSize& size);

  /// Makes a black light field, in blocks as blockFor(). Throws std::length_error beyond 2^32 - 2
  /// texels.
  LightField(LightFieldSize size, StoredType type) : LightField(size, type, blockFor(size)) {}
  LightField(LightFieldSize size, StoredType type, const std::array<std::uint32_t, 4>& block);
  /// Copies a hogel image. Throws std::invalid_argument unless it has 3·width·height values.
  LightField(LightFieldSize size, const Values& values);
  /// Makes a black light field with only a slice in memory: no other texel may be read.
  LightField(LightFieldSize size, StoredType type, SliceLayout slice);

  /// Returns the bytes that a light field of this size takes in memory.
  static std::size_t bytes(const LightFieldSize& size, StoredType type);

  [[nodiscard]] LightFieldSize size() const override { return m_size; }
  [[nodiscard]] const BlockLayout& layout() const { return m_layout; }
  [[nodiscard]] const Texels& texels() const { return m_texels; }
  [[nodiscard]] StoredType type() const override {
    return static_cast<StoredType>(m_texels.index());
  }
  /// Returns this object, which a std::shared_ptr must own.
  [[nodiscard]] std::shared_ptr<const LightField> slice(
      const ViewReads& /*reads*/, const Progress& /*progress*/) const override {
    return shared_from_this();
  }
  [[nodiscard]] std::shared_ptr<const LightField> overview() const override {
    return shared_from_this();
  }
  /// Returns false for a slice.
  [[nodiscard]] bool isInMemory() const override { return !m_slice; }
  [[nodiscard]] Rgb texel(const TexelIndex& at) const override;
  /// Whether all texels of the footprint are in memory.
  [[nodiscard]] bool covers(const Footprint& footprint) const {
    return !m_slice || m_slice->footprint.covers(footprint);
  }
  /// Sets a texel; T must be the stored type.
  template <class T>
  void set(const TexelIndex& at, const T* rgb) {
    std::get<TexelArray<T>>(m_texels)[m_layout.address(at)] = {rgb[0], rgb[1], rgb[2], T{}};
  }
  /// Sets neighbours along i from `first` on; not of a slice. T must be the stored type.
  template <class T>
  void setHogels(const TexelIndex& first, int count, const T* rgb) {
    Texel<T>* const line =
        std::get<TexelArray<T>>(m_texels).data() + m_layout.address({0, first.j, first.u, first.v});
    const int together = int(m_layout.i.mask) + 1;  // their texels lie side by side
    for (int i = first.i, end = 0; i < first.i + count; i = end) {
      end = std::min((i / together + 1) * together, first.i + count);
      Texel<T>* const to = line + m_layout.i.inBlocks(std::uint32_t(i));
      rgb = expand(rgb, end - i, to);
    }
  }
  /// Returns the layout of a slice; null if all texels are in memory.
  [[nodiscard]] const SliceLayout* sliceLayout() const { return m_slice.get(); }
  /// Sets the texel at an address of a slice's layout; T must be the stored type.
  template <class T>
  void setAddress(std::uint32_t address, const T* rgb) {
    std::get<TexelArray<T>>(m_texels)[address] = {rgb[0], rgb[1], rgb[2], T{}};
  }
  /// Sets neighbours along u of a slice, from `first` on; T must be the stored type.
  template <class T>
  void setRun(const TexelIndex& first, int count, const T* rgb) {
    auto* to = &std::get<TexelArray<T>>(m_texels)[m_layout.address(first)];
    for (int k = 0; k < count; ++k, rgb += 3) to[k] = {rgb[0], rgb[1], rgb[2], T{}};
  }
  /// Copies the slice's part of directions (·, v) of hogels (·, j) from the hogel image's row. T
  /// must be the stored type, v must lie in the slice.
  template <class T>
  void takeRow(int j, int v, const T* rgb);

 private:
  /// Copies values into texels. Returns what follows them.
  template <class T>
  static const T* expand(const T* rgb, int count, Texel<T>* to) {
    if constexpr (sizeof(T) == 1 && std::endian::native == std::endian::little)
      for (; count > 1; --count, rgb += 3, ++to) {  // by words, of which the next has a part
        std::uint32_t word = 0;
        std::memcpy(&word, rgb, sizeof word);
        word &= 0xffffffU;
        *to = std::bit_cast<Texel<T>>(word);
      }
    for (; count > 0; --count, rgb += 3, ++to) *to = {rgb[0], rgb[1], rgb[2], T{}};
    return rgb;
  }

  LightFieldSize m_size;
  std::shared_ptr<const SliceLayout> m_slice;
  BlockLayout m_layout;
  Texels m_texels;
};

}  // namespace hogelscope
