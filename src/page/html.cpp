// SPDX-License-Identifier: BSD-3-Clause
#include "page/html.h"

#include <algorithm>
#include <cstdint>

#include "core/base/text.h"

namespace hogelscope {

namespace {

std::string escapedLine(const std::string& text) {
  std::string out;
  for (const char c : printable(text)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string out;
  for (std::size_t at = 0;; ++at) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    out += escapedLine(text.substr(at, end - at));
    if (end == text.size()) return out;
    out += '\n';
    at = end;
  }
}

std::string base64(const std::string& bytes) {
  constexpr const char* alphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = at; k < at + 3; ++k)
      bits = bits << 8U | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += at + k <= bytes.size() ? alphabet[bits >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

std::string imageTag(const std::string& png, const std::string& text) {
  return "<img alt=\"" + escaped(text) + "\" src=\"data:image/png;base64," + base64(png) + "\"/>";
}

}  // namespace hogelscope
