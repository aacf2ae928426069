// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/word_fit.h"

#include <string>

namespace hogelscope {

int wordFit(std::string_view word, std::string_view title, std::string_view path) {
  const auto begins = [&](std::string_view in) {
    return (' ' + std::string(in)).find(' ' + std::string(word)) != std::string::npos;
  };
  if (title.starts_with(word)) return 8;
  if (begins(title)) return 6;
  if (begins(path)) return 4;
  if (title.find(word) != std::string_view::npos) return 3;
  if (word.size() < 3) return 0;  // a few letters are in most texts
  std::size_t at = 0;
  for (const char letter : word) {
    at = title.find(letter, at);
    if (at++ == std::string_view::npos) return 0;
  }
  return 1;
}

}  // namespace hogelscope
