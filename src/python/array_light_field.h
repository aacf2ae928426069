// SPDX-License-Identifier: BSD-3-Clause
// A light field in an array of another owner, such as numpy's.
// It is a source of slices, as a store is, so views copy what they read of it. The hash of its
// values stands in a report's key.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// Views (sub-aperture images) in the order v, u, y, x, colour: view (u, v), pixel (i, j) is hogel
/// (i, j), direction (u, v).
struct ViewArray {
  LightFieldSize size;
  StoredType type = StoredType::uint8;
  const std::byte* data = nullptr;
  std::array<std::ptrdiff_t, 5> strides{};  ///< in bytes, of v, u, y, x, colour
  std::shared_ptr<const void> owner;        ///< keeps the memory
  int frames = 1;
  std::ptrdiff_t frameStride = 0;  ///< in bytes

  /// Returns one of its frames as an array.
  [[nodiscard]] ViewArray frame(int number) const {
    ViewArray one = *this;
    one.data += number * frameStride;
    one.frames = 1;
    return one;
  }
};

/// Throws InputError for a value that is not finite, and Cancelled.
void checkFinite(const ViewArray& array, const Progress& progress);

/// A light field in an array. A large array is not copied: views read the slices that they need. A
/// small one is copied into blocks, which are faster. The array must not change.
class ArrayLightField : public LightFieldFile {
 public:
  explicit ArrayLightField(ViewArray array) : m_array(array.frame(0)), m_whole(std::move(array)) {}

  [[nodiscard]] LightFieldSize size() const override { return m_array.size; }
  [[nodiscard]] StoredType type() const override { return m_array.type; }
  /// Returns no files.
  [[nodiscard]] std::vector<std::filesystem::path> files() const override { return {}; }
  [[nodiscard]] LightField read(const Progress& progress) override;
  [[nodiscard]] std::shared_ptr<const LightFieldSource> source(const SourceUse& use,
                                                               const Progress& progress) override;
  void stream(const HogelRow& row, const Progress& progress) override;
  [[nodiscard]] FrameNumbers frames() const override { return {0, m_whole.frames - 1, 1}; }
  void select(int frame) override { m_array = m_whole.frame(frame); }
  /// Whether it is small enough for that.
  [[nodiscard]] bool isCopied() const;

 private:
  ViewArray m_array;  ///< the frame that is read
  ViewArray m_whole;
};

}  // namespace hogelscope
