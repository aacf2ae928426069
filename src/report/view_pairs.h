// SPDX-License-Identifier: BSD-3-Clause
// The image pairs that a report compares: a state's views of the session's and a test's light
// field.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/engine/ray_moves.h"
#include "core/optics/viewing.h"
#include "report/report_frames.h"
#include "report/report_request.h"
#include "runs/frame_reader.h"
#include "runs/state_images.h"

namespace hogelscope {

/// The two images of a state, with their light fields' bit depths, or the problem.
struct ViewPair {
  Image reference;
  Image test;
  std::string problem;
};

/// Renders the image pairs. Two light fields are in memory at a time, each read once; if one is too
/// large and must be streamed, all its images are made while it is read. Of light fields in time a
/// frame of each is in memory, and the next one is read meanwhile. Different states may be rendered
/// by different workers at the same time.
class ViewPairs {
 public:
  /// `rowsWithin` distributes the rows of one image.
  ViewPairs(const ReportRequest& request, std::size_t workers, const ParallelRows& rowsWithin);

  void setReference(const ViewSource& source) {
    ViewSource deep = source;
    deep.isIdeal = m_isAgainstIdeal;
    setKind(deep, m_own);
    m_reference.emplace(deep, m_own.session.cameras);
  }
  /// Sets the frames that are read from now on: of each the tests one after the other.
  void expect(std::vector<FrameViews> frames);
  /// Reads a test's light field at a frame, by its place among those of expect(), and for the first
  /// test the session's, in parallel if both are streamed. The previous one's memory is released
  /// first.
  void read(std::size_t test, std::size_t frame, const Progress& progress);

  /// Renders a pair. `progress` may be called from several threads. Throws Cancelled.
  ViewPair render(std::size_t state, std::size_t worker, const Progress& progress);
  /// Returns the errors of the light fields' own views. Empty if they cannot be compared: one is
  /// not completely in memory, their sizes differ, or the reference is the ideal view. Throws
  /// Cancelled.
  [[nodiscard]] std::vector<double> viewErrors(const Progress& progress) const;
  [[nodiscard]] RenderJob job(std::size_t state) const {
    return m_reference->job(state - m_views.begin);
  }
  /// Returns how far the rays of a state move on the test, a twin. Throws Cancelled.
  [[nodiscard]] RayMoves moves(std::size_t state, std::size_t worker, const Progress& progress);
  [[nodiscard]] const ViewSource& reference() const { return m_reference->source(); }
  [[nodiscard]] const ViewSource& test() const { return m_test->source(); }
  /// Returns the viewing geometry of a state's reference.
  [[nodiscard]] Viewing viewing(std::size_t state) const;
  [[nodiscard]] Renderer& renderer(std::size_t worker) { return m_renderers[worker]; }

 private:
  /// The light field of the session or of a test.
  struct Light {
    ReportTest test;
    std::optional<ViewSource> unloaded;  ///< of one in time, whose maps are read once
    std::unique_ptr<FrameReader> reader;
  };
  void setKind(ViewSource& source, const ReportTest& one) const {
    source.bits = one.file->bits();
    source.keepsUnrounded = m_keepsUnrounded;
  }
  void readSideBySide(Light& test, const Progress& progress);
  [[nodiscard]] StateImages imagesOf(Light& one, const Progress& progress);
  [[nodiscard]] FrameReader& readerOf(Light& one) const;
  [[nodiscard]] int frameOf(const Light& one, int frame) const;

  ReportTest m_own;  ///< the session with its light field
  bool m_isAgainstIdeal;
  bool m_keepsUnrounded;
  Shard m_shard;                ///< the states of a still that are rendered
  std::size_t m_memory;         ///< in bytes, for each of the two
  std::vector<Light> m_lights;  ///< of the session and of the tests
  bool m_isInTime;
  std::vector<FrameViews> m_frames;  ///< to be read
  FrameViews m_views;                ///< of the frame in memory
  std::optional<StateImages> m_reference;
  std::optional<StateImages> m_test;
  std::vector<Image> m_references;    ///< of the frame's states, if kept for more tests
  std::vector<Renderer> m_renderers;  ///< one per worker
};

}  // namespace hogelscope
