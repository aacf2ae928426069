// SPDX-License-Identifier: BSD-3-Clause
// The files of a light field of any layout.
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
  /// Reads it into memory. Throws InputError, or Cancelled.
  [[nodiscard]] virtual LightField read(const Progress& progress) = 0;

  /// Called with directions (·, v) of hogels (·, j): three values each, in the order of i·du + u.
  using HogelRow = std::function<void(int j, int v, const StoredRows& rgb)>;
  /// Whether one pass in bounded memory suffices for stream().
  [[nodiscard]] virtual bool isStream() const { return false; }
  /// Streams all of it, hogel row after hogel row from the top, with v of a hogel row in any order.
  /// If isStream() is false it uses half of allowedMemory(), and may read more than once. Throws
  /// InputError, or Cancelled.
  virtual void stream(const HogelRow& row, const Progress& progress) = 0;
};

/// Makes a black light field, to be filled. Throws InputError that names the file if the machine's
/// memory is too small; `hint` tells the user what to do.
LightField blankLightField(const LightFieldSize& size, StoredType type,
                           const std::filesystem::path& file, const std::string& hint = {});

}  // namespace hogelscope
