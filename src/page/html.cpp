// SPDX-License-Identifier: BSD-3-Clause
#include "page/html.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <sstream>
#include <string_view>
#include <utility>

namespace hogelscope {

namespace {

std::string escapedLine(const std::string& text) {
  std::string out;
  for (const char letter : printable(text)) switch (letter) {
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
        out += letter;
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

std::string latexPart(const std::string& tex) {
  return "<details><summary>As LaTeX</summary><pre>" + escaped(tex) + "</pre></details>\n";
}

std::string pageOf(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
         std::string(pagePolicy) +
         "\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width\"/>\n<title>" +
         escaped(title) + "</title>\n<style>" + pageStyle + "</style></head><body>\n" + body +
         "<script>" + pageScript + "</script>\n</body></html>\n";
}

namespace {

/// Returns the height of an `<svg>` over its width, by its viewBox.
double aspectOf(const std::string& svg) {
  constexpr std::string_view box = "viewBox=\"0 0 ";
  double width = 1;
  double height = 1;
  if (const std::size_t at = svg.find(box); at != std::string::npos) {
    std::istringstream numbers(svg.substr(at + box.size(), 40));
    numbers >> width >> height;
  }
  return height / width;
}

}  // namespace

std::string svgFile(const std::string& svg, double width) {
  constexpr std::string_view tag = "<svg ";
  const std::size_t at = svg.find('>') + 1;
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + numberText(width) +
         "mm\" height=\"" + numberText(fourDigits(width * aspectOf(svg))) + "mm\" " +
         svg.substr(tag.size(), at - tag.size()) + "<style>" + plotStyle + "</style>" +
         svg.substr(at);
}

}  // namespace hogelscope
