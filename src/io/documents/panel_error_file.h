// SPDX-License-Identifier: BSD-3-Clause
// Files of partial panel errors, with the states that they include, so that a report can be
// resumed.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "core/metrics/panel_error.h"

namespace hogelscope {

struct SavedPanelError {
  std::set<std::size_t> states;
  PanelError error;
};

/// Writes a line of JSON (key, states), then the cells of the hogels and of the directions as this
/// machine's 64-bit numbers. Throws InputError.
void savePanelError(const std::filesystem::path& file, const std::string& key,
                    const SavedPanelError& saved);
/// Reads the file; none if there is no complete one with this key and size. Throws InputError if
/// the file is not a panel error, because it would be replaced.
std::optional<SavedPanelError> loadPanelError(const std::filesystem::path& file,
                                              const std::string& key, const LightFieldSize& size,
                                              bool isDeep = false);

}  // namespace hogelscope
