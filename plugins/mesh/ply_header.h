// SPDX-License-Identifier: BSD-3-Clause
// The header of a PLY: its elements with their properties, and the pictures that its comments name.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hogelscope::mesh {

/// The type of a value; the bytes of each are in plyTypeBytes.
enum class PlyType : std::uint8_t { i8, u8, i16, u16, i32, u32, f32, f64, unknown };
constexpr std::array<std::size_t, 8> plyTypeBytes{1, 1, 2, 2, 4, 4, 4, 8};

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::unknown;
  PlyType countType = PlyType::unknown;  ///< of a list's length; unknown: not a list

  [[nodiscard]] bool isList() const { return countType != PlyType::unknown; }
};

struct PlyElement {
  std::string name;
  double count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyFormat : std::uint8_t { text, little, big };

struct PlyHeader {
  PlyFormat format = PlyFormat::text;
  std::vector<PlyElement> elements;
  std::vector<std::string> pictures;  ///< of comments "TextureFile NAME"

  /// Returns the element of a name; null if there is none.
  [[nodiscard]] const PlyElement* find(std::string_view name) const;
};

/// Throws that a file is no PLY that can be read.
[[noreturn]] void refusePly(const std::string& file, const std::string& why);

/// Reads the header and removes it from `rest`. Throws a line that names the file if it is damaged.
PlyHeader readPlyHeader(const std::string& file, std::string_view& rest);

}  // namespace hogelscope::mesh
