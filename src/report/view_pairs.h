// SPDX-License-Identifier: BSD-3-Clause
// The image pairs that a report compares: a state's views of the session's and a test's light
// field.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/engine/ray_moves.h"
#include "core/optics/viewing.h"
#include "report/report_request.h"
#include "runs/state_images.h"

namespace hogelscope {

/// The two images of a state, with their light fields' bit depths, or the problem.
struct ViewPair {
  Image reference;
  Image test;
  std::string problem;
};

/// Renders the image pairs. Two light fields are in memory at a time, each read once; if one is too
/// large and must be streamed, all its images are made while it is read. Different states may be
/// rendered by different workers at the same time.
class ViewPairs {
 public:
  /// `rowsWithin` distributes the rows of one image.
  ViewPairs(const ReportRequest& request, std::size_t workers, const ParallelRows& rowsWithin);

  void setReference(const ViewSource& source) {
    ViewSource deep = source;
    deep.isIdeal = m_isAgainstIdeal;
    deep.bits = m_own.file->bits();
    deep.keepsUnrounded = m_keepsUnrounded;
    m_reference.emplace(deep, m_own.session.cameras);
  }
  /// Reads a test's light field, and the first time the session's, in parallel if both are
  /// streamed. The previous test's memory is released first.
  void read(const ReportTest& test, const Progress& progress);

  /// Renders a pair. `progress` may be called from several threads. Throws Cancelled.
  ViewPair render(std::size_t state, std::size_t worker, const Progress& progress);
  /// Returns the errors of the light fields' own views. Empty if they cannot be compared: one is
  /// not completely in memory, their sizes differ, or the reference is the ideal view. Throws
  /// Cancelled.
  [[nodiscard]] std::vector<double> viewErrors(const Progress& progress) const;
  [[nodiscard]] RenderJob job(std::size_t state) const { return m_reference->job(state); }
  /// Returns how far the rays of a state move on the test, a twin. Throws Cancelled.
  [[nodiscard]] RayMoves moves(std::size_t state, std::size_t worker, const Progress& progress);
  [[nodiscard]] const ViewSource& reference() const { return m_reference->source(); }
  [[nodiscard]] const ViewSource& test() const { return m_test->source(); }
  /// Returns the viewing geometry of a state's reference.
  [[nodiscard]] Viewing viewing(std::size_t state) const;
  [[nodiscard]] Renderer& renderer(std::size_t worker) { return m_renderers[worker]; }

 private:
  void readSideBySide(const ReportTest& test, const Progress& progress);
  [[nodiscard]] StateImages imagesOf(const ReportTest& one, const Progress& progress) const;

  ReportTest m_own;  ///< the session with its light field
  bool m_isAgainstIdeal;
  bool m_keepsUnrounded;
  Shard m_shard;         ///< the states that are rendered
  std::size_t m_memory;  ///< in bytes, for each of the two
  std::optional<StateImages> m_reference;
  std::optional<StateImages> m_test;
  std::vector<Image> m_references;    ///< of the rendered states, if kept for more tests
  std::vector<Renderer> m_renderers;  ///< one per worker
};

}  // namespace hogelscope
