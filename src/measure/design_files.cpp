// SPDX-License-Identifier: BSD-3-Clause
#include "measure/design_files.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "io/documents/session_file.h"
#include "io/scene/view_source.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Whether designs may name files that the session does not: a value has a text.
bool mayNameFiles(const SweepTable& table) {
  const auto hasText = [](const std::string& value) { return value.find('"') != value.npos; };
  return std::ranges::any_of(table.parameters, [&](const SweepParameter& parameter) {
    return std::ranges::any_of(parameter.values, hasText);
  });
}

/// Returns what decides which files a light field has: not where its content stands.
std::vector<std::string> namesOf(const LightFieldParams& lightField) {
  std::vector<std::string> names = lightField.content.files();
  names.insert(names.end(), {lightField.source, lightField.file, lightField.pattern});
  return names;
}

}  // namespace

std::vector<fs::path> filesOfDesigns(const Session& session, const SweepTable& table,
                                     const std::vector<Design>& designs, bool hasViews,
                                     const Progress& progress) {
  std::set<fs::path> files;
  std::set<std::vector<std::string>> opened;
  const auto add = [&](const Session& design) {
    const bool isNew = hasViews && opened.insert(namesOf(design.lightField)).second;
    for (fs::path& file : isNew ? filesOf(design) : sessionFiles(design))
      files.insert(std::move(file));
  };
  add(session);
  for (const Design& design : mayNameFiles(table) ? designs : std::vector<Design>()) {
    throwIfCancelled(progress);
    try {
      add(overridden(session, overridesOf(table, design)));
    } catch (const InputError&) {  // its row will say so
    }
  }
  return {files.begin(), files.end()};
}

}  // namespace hogelscope
