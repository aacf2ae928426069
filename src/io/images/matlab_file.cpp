// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/matlab_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/files/random_access_file.h"

namespace hogelscope {

namespace {

constexpr std::size_t headBytes = 128;

/// A piece of the file: type, number of bytes, and where they are.
struct Element {
  std::uint32_t type = 0;
  std::uint32_t bytes = 0;
  std::uint64_t at = 0;
};

class MatlabFile {
 public:
  explicit MatlabFile(const std::filesystem::path& path) : m_file(path) {
    std::array<char, headBytes> head{};
    constexpr std::string_view mark("MATLAB 5.0 MAT-file");
    if (m_file.readSome(0, std::as_writable_bytes(std::span(head))) < headBytes ||
        !std::string_view(head.data(), head.size()).starts_with(mark))
      return;
    m_isMatlab = true;
    m_isBigEndian = head[headBytes - 2] == 'M';
  }

  [[nodiscard]] bool isMatlab() const { return m_isMatlab; }

  /// Returns a text such as "LF 5×5×30×40×4, meta compressed"; at most five variables.
  [[nodiscard]] std::string variables() const {
    constexpr int most = 5;
    constexpr std::uint32_t matrix = 14, compressed = 15;
    std::string list;
    std::uint64_t at = headBytes;
    for (int k = 0; k < most && at + 8 <= m_file.size(); ++k) {
      const Element element = elementAt(at);
      if (element.type != matrix && element.type != compressed) break;
      list += (list.empty() ? "" : ", ") +
              (element.type == matrix ? variable(element.at) : std::string("a compressed one"));
      at = element.at + element.bytes;
    }
    return list;
  }

 private:
  [[nodiscard]] std::uint32_t numberAt(std::uint64_t at) const {
    std::array<unsigned char, 4> bytes{};
    (void)m_file.readSome(at, std::as_writable_bytes(std::span(bytes)));
    if (!m_isBigEndian) std::ranges::reverse(bytes);
    std::uint32_t number = 0;
    for (const unsigned char byte : bytes) number = 256 * number + byte;
    return number;
  }

  /// A small element has its size in the upper half of its type.
  [[nodiscard]] Element elementAt(std::uint64_t at) const {
    const std::uint32_t type = numberAt(at);
    if (type > 0xffff) return {type & 0xffffU, type >> 16U, at + 4};
    return {type, numberAt(at + 4), at + 8};
  }

  static std::uint64_t after(const Element& element) {
    return (element.at + element.bytes + 7) / 8 * 8;
  }

  /// Returns name and shape of the variable whose parts begin at `at`: flags, shape, name.
  [[nodiscard]] std::string variable(std::uint64_t at) const {
    constexpr std::uint32_t mostAxes = 10, longestName = 63;
    const Element shape = elementAt(after(elementAt(at)));
    const Element name = elementAt(after(shape));
    std::string text(std::min(name.bytes, longestName), '\0');
    text.resize(m_file.readSome(name.at, std::as_writable_bytes(std::span(text))));
    text += " ";
    for (std::uint32_t axis = 0; axis < std::min(shape.bytes / 4, mostAxes); ++axis)
      text += (axis == 0 ? "" : "×") + std::to_string(numberAt(shape.at + 4ULL * axis));
    return printable(text);
  }

  RandomAccessFile m_file;
  bool m_isMatlab = false;
  bool m_isBigEndian = false;
};

}  // namespace

void refuseMatlab(const std::filesystem::path& path) {
  const MatlabFile file(path);
  if (!file.isMatlab()) return;
  const std::string list = file.variables();
  throw InputError(path.string(), "",
                   "is a MATLAB file before version 7.3" + (list.empty() ? "" : " (" + list + ")") +
                       ": save it anew by save(NAME, 'LF', '-v7.3')");
}

}  // namespace hogelscope
