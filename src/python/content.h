// SPDX-License-Identifier: BSD-3-Clause
// A light field that Python has opened, from files or an array: Python's LightField.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/optics/session.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

class Content {
 public:
  /// `lightField` and `display` are what a session says of it, or, of an array, could say.
  Content(LightFieldParams lightField, DisplayParams display, std::shared_ptr<LightFieldFile> file,
          std::vector<std::string> warnings = {});

  /// Opens a session's own. Throws InputError, Cancelled.
  static std::shared_ptr<Content> openOf(const Session& session, const Progress& progress);

  [[nodiscard]] const LightFieldParams& lightField() const { return m_lightField; }
  [[nodiscard]] const DisplayParams& display() const { return m_display; }
  [[nodiscard]] const std::shared_ptr<LightFieldFile>& file() const { return m_file; }
  /// Returns lines for the user.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return m_warnings; }
  /// To be held while the file is read or rendered from.
  [[nodiscard]] std::timed_mutex& mutex() { return m_mutex; }

  /// Returns the texels, read the first time. Throws InputError, Cancelled.
  std::shared_ptr<const LightFieldSource> source(const Progress& progress);
  /// Whether the files are still those that were opened.
  [[nodiscard]] bool isFresh() const;

  /// Returns the session with this light field in the place of its own; it keeps its viewing
  /// distance unless this one has another.
  [[nodiscard]] Session in(const Session& session) const;

 private:
  LightFieldParams m_lightField;
  DisplayParams m_display;
  std::shared_ptr<LightFieldFile> m_file;
  std::vector<std::string> m_warnings;
  std::string m_state;  ///< of the files, when they were opened
  std::timed_mutex m_mutex;
  std::shared_ptr<const LightFieldSource> m_source;
};

}  // namespace hogelscope
