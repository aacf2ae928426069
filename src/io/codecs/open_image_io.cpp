// SPDX-License-Identifier: BSD-3-Clause
#include "io/codecs/open_image_io.h"

namespace hogelscope {

std::string asOneLine(std::string text, const std::filesystem::path& file) {
  for (const std::string& noise : {"\"" + file.string() + "\"", "'" + file.string() + "'"})
    if (const std::size_t at = text.find(noise); at != std::string::npos)
      text.replace(at, noise.size(), "it");
  text = text.substr(0, text.find('\n'));  // the other lines repeat it
  if (text.ends_with(" (it)")) text.resize(text.size() - 5);
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text.empty() ? "unknown reason" : text;
}

OIIO::TypeDesc typeDesc(StoredType type) {
  switch (type) {
    case StoredType::uint8:
      return OIIO::TypeDesc::UINT8;
    case StoredType::uint16:
      return OIIO::TypeDesc::UINT16;
    default:
      return OIIO::TypeDesc::FLOAT;
  }
}

}  // namespace hogelscope
