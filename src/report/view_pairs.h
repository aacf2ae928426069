// SPDX-License-Identifier: BSD-3-Clause
// The images that a report compares: a state's from the session's light field and from a test's.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaign/state_images.h"
#include "core/optics/viewing.h"
#include "report/report_request.h"

namespace hogelscope {

/// The two images of a state, with the bits that its light fields have, or why there are none.
struct ViewPair {
  Image reference;
  Image test;
  std::string problem;
};

/// Two light fields are in memory at a time, each read once; of one that is too large and can only
/// be read from the top all images are made while it is read. Different states may be rendered by
/// different workers at the same time.
class ViewPairs {
 public:
  /// `rowsWithin` is how the rows of one image are shared out.
  ViewPairs(const ReportRequest& request, std::size_t workers, const ParallelRows& rowsWithin);

  void setReference(const Scene& scene) {
    Scene deep = scene;
    deep.isIdeal = m_isAgainstIdeal;
    deep.bits = m_file.bits();
    deep.keepsUnrounded = m_keepsUnrounded;
    m_reference.emplace(deep, m_session.cameras);
  }
  /// Reads the session's light field, the first time, and a test's, side by side where both pass
  /// by. The last test's memory is free before the next one is read.
  void read(const ReportTest& test, const Progress& progress);

  /// `progress` may be called from several threads. Throws Cancelled.
  ViewPair render(std::size_t state, std::size_t worker, const Progress& progress);
  /// The errors of the light fields' own views. Empty where there is nothing to compare: one is not
  /// whole in memory, their sizes differ, or the reference is the ideal view. Throws Cancelled.
  [[nodiscard]] std::vector<double> viewErrors(const Progress& progress) const;
  [[nodiscard]] RenderJob job(std::size_t state) const { return m_reference->job(state); }
  [[nodiscard]] const Scene& reference() const { return m_reference->scene(); }
  [[nodiscard]] const Scene& test() const { return m_test->scene(); }
  /// Returns where the reference of a state is seen from.
  [[nodiscard]] Viewing viewing(std::size_t state) const;
  [[nodiscard]] Renderer& renderer(std::size_t worker) { return m_renderers[worker]; }

 private:
  [[nodiscard]] bool streams(const LightFieldFile& file) const;
  void readSideBySide(const ReportTest& test, const Progress& progress);
  [[nodiscard]] StateImages imagesOf(const Session& session, LightFieldFile& file,
                                     const Progress& progress) const;

  Session m_session;
  LightFieldFile& m_file;  ///< the session's light field
  bool m_isAgainstIdeal;
  bool m_keepsUnrounded;
  Shard m_shard;         ///< whose states are asked for
  std::size_t m_memory;  ///< of each of the two
  std::optional<StateImages> m_reference;
  std::optional<StateImages> m_test;
  std::vector<Image> m_references;    ///< of the states rendered, if they are kept for more tests
  std::vector<Renderer> m_renderers;  ///< of the workers
};

}  // namespace hogelscope
