// SPDX-License-Identifier: BSD-3-Clause
#include "errors.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace hogelscope::mesh {

void fail(const std::string& file, const std::string& what, const std::string& why) {
  std::string line = file + ": " + what + ": " + why;
  const auto breaksLine = [](unsigned char c) { return c < ' ' || c == 0x7F; };
  std::replace_if(line.begin(), line.end(), breaksLine, '?');
  throw std::runtime_error(line);
}

std::string shortName(const std::string& name) {
  constexpr std::size_t most = 80;
  return name.size() <= most ? name : name.substr(0, most) + "…";
}

std::string sameName(const std::string& path) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::weakly_canonical(path, error);
  return error ? path : whole.string();
}

std::string leftOut(const std::string& what, const std::vector<std::string>& names) {
  constexpr std::size_t mostNamed = 6;
  std::string note = "Its " + what;
  for (std::size_t k = 0; k < std::min(names.size(), mostNamed); ++k)
    note += (k == 0 ? " " : ", ") + shortName(names[k]);
  return note + (names.size() > mostNamed ? ", … are not shown." : " are not shown.");
}

}  // namespace hogelscope::mesh
