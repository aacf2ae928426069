// SPDX-License-Identifier: BSD-3-Clause
// A panel error on its way: which states are in it, so that a report can go on later.
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

/// A line of JSON (key, states), then the cells of the hogels and of the directions as this
/// machine's 64-bit numbers. Throws InputError.
void savePanelError(const std::filesystem::path& file, const std::string& key,
                    const SavedPanelError& saved);
/// None where there is no whole file with this key and size. Throws InputError where there is a
/// file that is no panel error: it would be replaced.
std::optional<SavedPanelError> loadPanelError(const std::filesystem::path& file,
                                              const std::string& key, const LightFieldSize& size);

}  // namespace hogelscope
