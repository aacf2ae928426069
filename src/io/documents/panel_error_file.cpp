// SPDX-License-Identifier: BSD-3-Clause
#include "io/documents/panel_error_file.h"

#include <fstream>

#include "core/base/error.h"
#include "io/files/atomic_file.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

using Cells = std::vector<PanelError::Cell>;

constexpr std::string_view headOfPanelError = R"({"hogelscope panel error":1,)";

std::string_view bytesOf(const Cells& cells) {
  return {reinterpret_cast<const char*>(cells.data()), cells.size() * sizeof(PanelError::Cell)};
}

constexpr std::size_t longestHead = std::size_t{16} << 20U;  // a million states

/// Returns none if the head is missing or of another panel error.
std::optional<std::set<std::size_t>> statesOf(const std::string& head, const std::string& key) {
  try {
    const Json document = parseJson(head);
    if (document.at("key") != key) return std::nullopt;
    std::set<std::size_t> states;
    for (const Json& state : document.at("states")) {
      if (!state.is_number_unsigned()) return std::nullopt;
      states.insert(state.get<std::size_t>());
    }
    return states;
  } catch (const InputError&) {
    return std::nullopt;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
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
                                              const LightFieldSize& size, bool isDeep) {
  requireOwnFile(file, headOfPanelError);
  Cells hogels(std::size_t(size.nx) * std::size_t(size.ny));
  Cells directions(std::size_t(size.du) * std::size_t(size.dv));
  std::error_code error;
  if (fs::file_size(file, error) >
      longestHead + bytesOf(hogels).size() + bytesOf(directions).size())
    return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  std::string line;
  if (!std::getline(in, line)) return std::nullopt;
  const auto states = statesOf(line, key);
  if (!states || !readCells(in, hogels) || !readCells(in, directions) ||
      in.peek() != std::char_traits<char>::eof())
    return std::nullopt;
  return SavedPanelError{*states, {size, std::move(hogels), std::move(directions), isDeep}};
}

}  // namespace hogelscope
