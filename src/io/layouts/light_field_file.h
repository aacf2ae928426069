// SPDX-License-Identifier: BSD-3-Clause
// The files of a light field of any layout.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/light_field/light_field.h"
#include "core/optics/session.h"
#include "io/files/system_limits.h"
#include "io/images/image_file.h"

namespace hogelscope {

/// Options for texels that are fetched or computed when a view needs them.
struct SourceUse {
  std::size_t memory = allowedMemory();  ///< bytes for texels
  /// Bytes of decoded blocks of a store that are kept for a moving eye: two views of the paper's
  /// light field. For views that have nothing in common, allocating memory takes longer than
  /// decoding.
  std::size_t cache = 1000000000;
  int threads = 0;  ///< for each view; 0 = all
};

/// A light field whose files have been found and opened, but not read.
class LightFieldFile {
 public:
  virtual ~LightFieldFile() = default;
  [[nodiscard]] virtual LightFieldSize size() const = 0;
  [[nodiscard]] virtual std::vector<std::filesystem::path> files() const = 0;
  [[nodiscard]] virtual StoredType type() const = 0;
  /// Returns the bits of a value of the content, 8 … 16; by default all of its type, 16 for floats.
  [[nodiscard]] virtual int bits() const { return type() == StoredType::uint8 ? 8 : 16; }
  /// Returns the format of its pictures in words, such as "png"; "" where there are none.
  [[nodiscard]] virtual std::string format() const { return {}; }
  /// Returns warnings about what is missing, such as views, or not read.
  [[nodiscard]] virtual std::vector<std::string> warnings() const { return {}; }
  /// Returns a warning if a state's eye sees the scene cut by the panel's edges; otherwise "".
  [[nodiscard]] virtual std::string cutWarning(const CameraState& /*state*/) const { return {}; }
  /// Returns the hash of the content (io/files/content_hash.h) that the files contain, or "".
  [[nodiscard]] virtual std::string contentHash() const { return {}; }
  /// Returns the frames by their numbers: those of LightFieldParams::frames, otherwise all.
  [[nodiscard]] virtual FrameNumbers frames() const { return {}; }
  /// Returns how many frames files() have, of which frames() may be some.
  [[nodiscard]] virtual std::size_t framesInFiles() const { return frames().count(); }
  /// Returns the frames that are shown in a second; 0 if it is not known.
  [[nodiscard]] virtual double frameRate() const { return 0; }
  /// Selects the frame that is read from now on; until then it is the first one. Throws InputError.
  virtual void select(int /*frame*/) {}
  /// Reads the light field into memory. Throws InputError, or Cancelled.
  [[nodiscard]] virtual LightField read(const Progress& progress) = 0;

  /// Returns the light field for views: by default in memory. Throws InputError, or Cancelled.
  [[nodiscard]] virtual std::shared_ptr<const LightFieldSource> source(const SourceUse& use,
                                                                       const Progress& progress);

  /// Receives directions (·, v) of hogels (·, j): three values each, in the order of i·du + u.
  using HogelRow = std::function<void(int j, int v, const StoredRows& rgb)>;
  /// Whether stream() reads the files once, in bounded memory.
  [[nodiscard]] virtual bool isStream() const { return false; }
  /// Streams the light field, one row of hogels after the other from the top, with v of a row in
  /// any order. If isStream() is false, it uses half of allowedMemory(), and may read more than
  /// once. Throws InputError, or Cancelled.
  virtual void stream(const HogelRow& row, const Progress& progress) = 0;

 protected:
  /// Reads the light field by stream(). `file` and `advice` are for blankLightField().
  [[nodiscard]] LightField readStreamed(const std::filesystem::path& file,
                                        const std::string& advice, const Progress& progress);
};

/// A light field made of that of another file, which says all that a derived class does not.
class WrappedFile : public LightFieldFile {
 public:
  explicit WrappedFile(std::shared_ptr<LightFieldFile> content) : m_content(std::move(content)) {}

  [[nodiscard]] LightFieldSize size() const override { return m_content->size(); }
  [[nodiscard]] std::vector<std::filesystem::path> files() const override {
    return m_content->files();
  }
  [[nodiscard]] StoredType type() const override { return m_content->type(); }
  [[nodiscard]] int bits() const override { return m_content->bits(); }
  [[nodiscard]] std::vector<std::string> warnings() const override { return m_content->warnings(); }
  [[nodiscard]] std::string cutWarning(const CameraState& state) const override {
    return m_content->cutWarning(state);
  }
  [[nodiscard]] FrameNumbers frames() const override { return m_content->frames(); }
  [[nodiscard]] std::size_t framesInFiles() const override { return m_content->framesInFiles(); }
  [[nodiscard]] double frameRate() const override { return m_content->frameRate(); }
  void select(int frame) override { m_content->select(frame); }
  /// Reads the light field by stream().
  [[nodiscard]] LightField read(const Progress& progress) override {
    return readStreamed(files().empty() ? "" : files().front(), "", progress);
  }

 protected:
  [[nodiscard]] LightFieldFile& content() const { return *m_content; }

 private:
  std::shared_ptr<LightFieldFile> m_content;
};

/// Returns the frames that a session lists, checked against those that there are; these if it lists
/// none. Throws InputError that names the file.
FrameNumbers listedFrames(const LightFieldParams& params, const FrameNumbers& all);

/// Returns the frames that are shown in a second: a session's, otherwise those that the file says;
/// 0 if it is not known.
double frameRateOf(const LightFieldParams& params, const LightFieldFile& file);

/// Whether the whole light field takes at most `memory` bytes.
bool fitsInMemory(const LightFieldFile& file, std::size_t memory);

/// Calls `use` with directions (·, v) of hogels (·, j) of a light field or of a slice, as row `to`.
void handOutRow(const LightField& texels, int j, int v, const LightFieldFile::HogelRow& use,
                int to);

/// Advice for a light field that is too large.
inline constexpr const char* packIt = "allow more, or pack it into a store and use that";

/// Returns a black light field, to be filled. Throws InputError that names the file if the
/// machine's memory is too small for it, with advice. What is allowed is not asked: a stream needs
/// one row of hogels, however little that is.
LightField blankLightField(const LightFieldSize& size, StoredType type,
                           const std::filesystem::path& file,
                           const std::string& advice = "allow more");

}  // namespace hogelscope
