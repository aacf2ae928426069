// SPDX-License-Identifier: BSD-3-Clause
// A panel error on its way, as a file.
#include "io/panel_error_file.h"

#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "io/atomic_file.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;
using Cells = std::vector<PanelError::Cell>;

constexpr std::string_view headOfAny = R"({"hogelscope panel error":1,)";

std::string_view bytesOf(const Cells& cells) {
  return {reinterpret_cast<const char*>(cells.data()), cells.size() * sizeof(PanelError::Cell)};
}

bool readCells(std::istream& in, Cells& cells) {
  const auto bytes = static_cast<std::streamsize>(cells.size() * sizeof(PanelError::Cell));
  return bool(in.read(reinterpret_cast<char*>(cells.data()), bytes));
}

}  // namespace

void savePanelError(const fs::path& file, const std::string& key, const SavedPanelError& saved) {
  std::string content =
      Json{{"hogelscope panel error", 1}, {"key", key}, {"states", saved.states}}.dump() + "\n";
  content += bytesOf(saved.error.hogels());
  content += bytesOf(saved.error.directions());
  writeTextFile(file, content);
}

std::optional<SavedPanelError> loadPanelError(const fs::path& file, const std::string& key,
                                              const LightFieldSize& size) {
  requireOurs(file, headOfAny);
  std::ifstream in(file, std::ios::binary);
  std::string line;
  if (!std::getline(in, line)) return std::nullopt;
  const Json head = Json::parse(line, nullptr, false);
  Cells hogels(std::size_t(size.nx) * std::size_t(size.ny));
  Cells directions(std::size_t(size.du) * std::size_t(size.dv));
  try {
    if (head.at("key") != key || !readCells(in, hogels) || !readCells(in, directions) ||
        in.peek() != std::char_traits<char>::eof())
      return std::nullopt;
    return SavedPanelError{head.at("states").get<std::set<std::size_t>>(),
                           {size, std::move(hogels), std::move(directions)}};
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace hogelscope
