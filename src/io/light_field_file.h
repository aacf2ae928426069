// SPDX-License-Identifier: BSD-3-Clause
// Light field files: any layout becomes a LightField in memory.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/display.h"
#include "core/light_field.h"
#include "core/progress.h"
#include "core/simulate.h"
#include "io/image_file.h"
#include "io/machine.h"

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

/// Throws InputError that names the file: missing, damaged, or not the display's size.
std::unique_ptr<LightFieldFile> openLightField(const LightFieldParams& params,
                                               const DisplayParams& display);

/// What the views of a session's states have in common: read once, shared.
struct Scene {
  std::shared_ptr<const LightField> lightField;
  DisplayParams display;  ///< resolved
  SamplingParams sampling;

  [[nodiscard]] View view(const CameraState& state) const {
    return {lightField, display, sampling, state};
  }
};

/// Would all of it take at most `memory` bytes?
bool fitsInMemory(const LightFieldFile& file, std::size_t memory);

/// How views fetch what they need of a store.
struct StoreUse {
  /// Bytes of decoded blocks that are kept, for an eye that moves: two views of the paper's light
  /// field. For views that have nothing in common new memory takes longer than decoding.
  std::size_t cache = 1000000000;
  int threads = 0;  ///< for each view; 0 = all
};

/// Reads the session's light field, or opens it where it is a store that is larger than `memory`
/// bytes. Throws InputError, or Cancelled.
Scene loadScene(const Session& session, const Progress& progress,
                std::size_t memory = allowedMemory(), const StoreUse& use = {});
/// With nothing of the light field in memory.
Scene unloadedScene(const Session& session, const LightFieldFile& file);

/// Do both sessions have the same light field in memory? Their displays may be otherwise different.
bool readTheSame(const Session& a, const Session& b);

/// A folder of views, a store, a quilt by its name, or a hogel image.
LightFieldParams lightFieldOf(const std::string& file);

/// Another file with the layout of `params`, unless one is a folder or a store and the other is
/// not.
LightFieldParams withFile(const LightFieldParams& params, const std::string& file);

/// Columns and rows that a quilt's name says (…_qs8x6a0.75.png); 0 where it does not.
std::array<int, 2> quiltTilesFromName(const std::string& file);

}  // namespace hogelscope
