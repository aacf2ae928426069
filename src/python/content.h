// SPDX-License-Identifier: BSD-3-Clause
// A light field opened by Python from files or an array: Python's LightField.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <variant>
#include <vector>

#include "core/optics/session.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// Returns a text that changes when a file is written or replaced.
std::string identitiesOf(const std::vector<std::filesystem::path>& files);

class Content {
 public:
  enum class Kind { files, copiedArray, borrowedArray };

  /// `lightField` and `display` are a session's parameters for it; for an array, possible ones.
  Content(LightFieldParams lightField, DisplayParams display, std::shared_ptr<LightFieldFile> file,
          std::vector<std::string> warnings = {}, Kind kind = Kind::files);

  /// Opens a session's own light field. Throws InputError, Cancelled.
  static std::shared_ptr<Content> openOf(const Session& session, const Progress& progress);

  [[nodiscard]] const LightFieldParams& lightField() const { return m_lightField; }
  [[nodiscard]] const DisplayParams& display() const { return m_display; }
  /// Returns the file, which one thread at a time reads; others wait. Its sources are for all.
  [[nodiscard]] const std::shared_ptr<LightFieldFile>& file() const { return m_file; }
  /// Returns lines for the user.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return m_warnings; }

  /// Returns the texels of a frame, read on first use; those of the last frame are kept. Throws
  /// InputError, Cancelled.
  std::shared_ptr<const LightFieldSource> source(int frame, const Progress& progress);
  /// Streams a frame (LightFieldFile::stream()). Throws InputError, Cancelled.
  void stream(int frame, const LightFieldFile::HogelRow& row, const Progress& progress);
  /// Whether the files are unchanged since they were opened.
  [[nodiscard]] bool isFresh() const;
  /// Whether it is an array, which cannot be opened again.
  [[nodiscard]] bool isArray() const { return m_kind != Kind::files; }
  /// Whether its texels are the array of the user, who may change it.
  [[nodiscard]] bool isBorrowed() const { return m_kind == Kind::borrowedArray; }

  /// Returns the session with this light field instead of its own. The viewing distance is kept
  /// unless this light field has another.
  [[nodiscard]] Session in(const Session& session) const;

 private:
  LightFieldParams m_lightField;
  DisplayParams m_display;
  std::shared_ptr<LightFieldFile> m_file;
  std::vector<std::string> m_warnings;
  Kind m_kind;
  std::string m_state;             ///< of the files when they were opened
  std::timed_mutex m_sourceMutex;  ///< of the frame that is selected, too
  std::shared_ptr<const LightFieldSource> m_source;
  int m_frame = 0;  ///< of m_source
};

/// The session's own; an open one; or a file, a folder or a session, as for --test.
using LightChoice = std::variant<std::monostate, std::shared_ptr<Content>, std::string>;

/// Returns the session with a file as its light field. Throws InputError that names the file.
Session sessionWith(const Session& session, const std::string& file);

}  // namespace hogelscope
