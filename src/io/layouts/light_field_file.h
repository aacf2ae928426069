// SPDX-License-Identifier: BSD-3-Clause
// A light field's files, of any layout.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/light_field/light_field.h"
#include "io/images/image_file.h"

namespace hogelscope {

/// A light field whose files have been found and opened, but not read.
class LightFieldFile {
 public:
  virtual ~LightFieldFile() = default;
  [[nodiscard]] virtual LightFieldSize size() const = 0;
  [[nodiscard]] virtual std::vector<std::filesystem::path> files() const = 0;
  [[nodiscard]] virtual StoredType type() const = 0;
  /// Throws InputError, or Cancelled.
  [[nodiscard]] virtual LightField read(const Progress& progress) = 0;

  /// Hears the directions (·, v) of the hogels (·, j): three values each, in the order of i·du + u.
  using HogelRow = std::function<void(int j, int v, const StoredRows& rgb)>;
  /// Can the file be gone through in bounded memory and once, row of hogels by row of hogels?
  [[nodiscard]] virtual bool isStream() const { return false; }
  /// Tells all of it, hogel row after hogel row from the top, a hogel row's v in any order. Where
  /// isStream() says no it takes half of allowedMemory(), and reads more than once if it must.
  /// Throws InputError, or Cancelled.
  virtual void stream(const HogelRow& row, const Progress& progress) = 0;
};

/// A black one, to be filled. Throws InputError that names the file where the machine's memory is
/// too small; `hint` says what to do then.
LightField blankLightField(const LightFieldSize& size, StoredType type,
                           const std::filesystem::path& file, const std::string& hint = {});

}  // namespace hogelscope
