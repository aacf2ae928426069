// SPDX-License-Identifier: BSD-3-Clause
#include "errors.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
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

std::string readBytes(const std::string& file) {
  // A pipe or a device would never end.
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) fail(file, "cannot be read", std::strerror(ENOENT));
  if (!std::filesystem::is_regular_file(status)) fail(file, "cannot be read", "is not a file");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> input(std::fopen(file.c_str(), "rbe"),
                                                              &std::fclose);
  if (!input) fail(file, "cannot be read", std::strerror(errno));
  std::string bytes(std::filesystem::file_size(file), '\0');
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), input.get()));
  if (std::ferror(input.get()) != 0) fail(file, "cannot be read", std::strerror(errno));
  return bytes;
}

}  // namespace hogelscope::mesh
