// SPDX-License-Identifier: BSD-3-Clause
// Light fields whose frames are files or folders with the number of the frame in their names.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// Frames of one layout, each opened as a still when it is selected.
class NumberedFrames : public LightFieldFile {
 public:
  /// Opens a light field of one frame.
  using OpenStill = std::unique_ptr<LightFieldFile> (*)(const LightFieldParams& params,
                                                        const DisplayParams& display,
                                                        const Progress& progress);
  /// Finds the frames by {T} in the file and the pattern (isNumbered()) and opens the first one.
  /// Throws InputError: there is none, one is missing between the first and the last, or two have
  /// the same number.
  NumberedFrames(LightFieldParams params, const DisplayParams& display, OpenStill open,
                 const Progress& progress);

  [[nodiscard]] LightFieldSize size() const override { return m_still->size(); }
  /// Returns the files of all listed frames, which are looked for once.
  [[nodiscard]] std::vector<std::filesystem::path> files() const override;
  [[nodiscard]] StoredType type() const override { return m_still->type(); }
  [[nodiscard]] int bits() const override { return m_still->bits(); }
  [[nodiscard]] std::string format() const override { return m_still->format(); }
  [[nodiscard]] std::vector<std::string> warnings() const override { return m_still->warnings(); }
  [[nodiscard]] FrameNumbers frames() const override { return m_frames; }
  /// Opens a frame. Throws InputError, also if its size or its bits are not those of the first one.
  void select(int frame) override;
  [[nodiscard]] LightField read(const Progress& progress) override {
    return m_still->read(progress);
  }
  [[nodiscard]] std::shared_ptr<const LightFieldSource> source(const SourceUse& use,
                                                               const Progress& progress) override {
    return m_still->source(use, progress);
  }
  [[nodiscard]] bool isStream() const override { return m_still->isStream(); }
  void stream(const HogelRow& row, const Progress& progress) override {
    m_still->stream(row, progress);
  }

 private:
  LightFieldParams m_params;
  DisplayParams m_display;
  OpenStill m_open;
  std::map<int, std::string> m_digits;  ///< of each frame in its names
  FrameNumbers m_frames;
  int m_frame = 0;
  std::unique_ptr<LightFieldFile> m_still;
  mutable std::once_flag m_areFound;
  mutable std::vector<std::filesystem::path> m_files;
};

/// Returns the first frame of numbered files as a light field of its own; any other light field as
/// it is. Throws InputError.
LightFieldParams firstStillOf(const LightFieldParams& params);

/// Returns the name of the first frame's file or folder; a name without {T} as it is. Throws
/// InputError.
std::string firstFileOf(const std::string& file);

/// Returns a name with the digits of a frame's number in place of each {T}.
std::string withFrame(std::string name, const std::string& digits);

}  // namespace hogelscope
