// SPDX-License-Identifier: BSD-3-Clause
// The text of an input error.
#include "core/base/error.h"

#include <string_view>

namespace hogelscope {

namespace {

/// Returns the number of bytes of the UTF-8 character at `at`, or 0 for none.
std::size_t letterBytes(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char lead = byte(at);
  const std::size_t size = lead < 0x80 ? 1 : lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if ((lead >= 0x80 && lead < 0xc2) || lead > 0xf4 || at + size > text.size()) return 0;
  for (std::size_t k = 1; k < size; ++k)
    if ((byte(at + k) & 0xc0U) != 0x80) return 0;
  return size;
}

/// Makes one line of UTF-8 that is harmless to a terminal: other bytes become \xNN.
std::string printable(const std::string& text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t size = letterBytes(text, at);
    const auto byte = static_cast<unsigned char>(text[at]);
    if (size > 0 && byte >= 32 && byte != 127) {
      line += text.substr(at, size);
      at += size;
      continue;
    }
    line += {'\\', 'x', digits[byte >> 4U], digits[byte & 15U]};
    ++at;
  }
  return line;
}

std::string joined(const std::string& file, const std::string& what, const std::string& why) {
  std::string line;
  for (const std::string& part : {file, what, why}) {
    if (part.empty()) continue;
    if (!line.empty()) line += ": ";
    line += printable(part);
  }
  return line;
}

}  // namespace

InputError::InputError(std::string file, std::string what, std::string why)
    : std::runtime_error(joined(file, what, why)),
      m_file(std::move(file)),
      m_what(std::move(what)),
      m_why(std::move(why)) {}

InputError InputError::in(const std::string& file) const {
  return m_file.empty() ? InputError(file, m_what, m_why) : *this;
}

}  // namespace hogelscope
