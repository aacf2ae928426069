// SPDX-License-Identifier: BSD-3-Clause
// Helpers for reading and writing by OpenImageIO.
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <type_traits>

namespace hogelscope {

template <class T>
constexpr OIIO::TypeDesc::BASETYPE baseType() {
  if constexpr (std::is_same_v<T, std::uint8_t>) return OIIO::TypeDesc::UINT8;
  if constexpr (std::is_same_v<T, std::uint16_t>) return OIIO::TypeDesc::UINT16;
  return OIIO::TypeDesc::FLOAT;
}

/// Returns OpenImageIO's message on one line, without the file's name.
std::string asOneLine(std::string text, const std::filesystem::path& file);

}  // namespace hogelscope
