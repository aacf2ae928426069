// SPDX-License-Identifier: BSD-3-Clause
#include "python/content.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "io/files/content_hash.h"
#include "io/opening/session_around.h"
#include "io/scene/view_source.h"
#include "python/stoppable.h"

namespace hogelscope {

namespace {

/// A file that one thread at a time reads, since decoders have a state.
class SharedFile : public WrappedFile {
 public:
  using WrappedFile::WrappedFile;

  [[nodiscard]] std::string contentHash() const override { return content().contentHash(); }
  [[nodiscard]] bool isStream() const override { return content().isStream(); }

  [[nodiscard]] LightField read(const Progress& progress) override {
    const auto lock = lockFor(m_mutex, progress);
    return content().read(progress);
  }
  [[nodiscard]] std::shared_ptr<const LightFieldSource> source(const SourceUse& use,
                                                               const Progress& progress) override {
    const auto lock = lockFor(m_mutex, progress);
    return content().source(use, progress);
  }
  void stream(const HogelRow& row, const Progress& progress) override {
    const auto lock = lockFor(m_mutex, progress);
    content().stream(row, progress);
  }

 private:
  std::timed_mutex m_mutex;
};

}  // namespace

std::string identitiesOf(const std::vector<std::filesystem::path>& files) {
  std::string identities;
  for (const std::filesystem::path& file : files) identities += fileIdentity(file) + "\n";
  return identities;
}

Content::Content(LightFieldParams lightField, DisplayParams display,
                 std::shared_ptr<LightFieldFile> file, std::vector<std::string> warnings, Kind kind)
    : m_lightField(std::move(lightField)),
      m_display(std::move(display)),
      m_file(std::make_shared<SharedFile>(std::move(file))),
      m_warnings(std::move(warnings)),
      m_kind(kind),
      m_state(identitiesOf(m_file->files())) {
  for (const std::string& line : m_file->warnings()) m_warnings.push_back(line);
}

std::shared_ptr<Content> Content::openOf(const Session& session, const Progress& progress) {
  return std::make_shared<Content>(session.lightField, session.display,
                                   openLightField(session.lightField, session.display, progress));
}

std::shared_ptr<const LightFieldSource> Content::source(int frame, const Progress& progress) {
  const auto lock = lockFor(m_sourceMutex, progress);
  if (m_source && m_frame == frame) return m_source;
  m_source.reset();
  m_file->select(frame);
  m_source = m_file->source({.threads = threadCount()}, progress);
  m_frame = frame;
  return m_source;
}

void Content::stream(int frame, const LightFieldFile::HogelRow& row, const Progress& progress) {
  const auto lock = lockFor(m_sourceMutex, progress);
  m_file->select(frame);
  m_file->stream(row, progress);
}

bool Content::isFresh() const {
  return identitiesOf(m_file->files()) == m_state;
}

Session Content::in(const Session& session) const {
  Session result = session;
  result.lightField = m_lightField;
  if (!(m_lightField.viewingDistance > 0))
    result.lightField.viewingDistance = session.lightField.viewingDistance;
  return result;
}

Session sessionWith(const Session& session, const std::string& file) {
  try {
    return withLightField(session, file);
  } catch (const InputError& error) {
    throw error.in(file);
  }
}

}  // namespace hogelscope
