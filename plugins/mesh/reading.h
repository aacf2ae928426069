// SPDX-License-Identifier: BSD-3-Clause
// The memory limit and the progress listener of reading a mesh, shared by all its readers.
#pragma once

#include <cstdint>
#include <string>

#include "hogelscope/plugin.h"

namespace hogelscope::mesh {

class Reading {
 public:
  /// `file` is the mesh's own, for messages; `memory` is the limit in bytes for everything made of
  /// it.
  Reading(std::string file, std::uint64_t memory, const plugin::Progress& progress);

  [[nodiscard]] const std::string& file() const { return m_file; }

  /// Counts bytes before they are allocated and kept. Throws if the mesh then exceeds the limit.
  void take(double bytes);
  /// Returns the content of a file and counts its size, or throws.
  [[nodiscard]] std::string bytesOf(const std::string& file);
  /// Reports the share of a file that has been read. Throws "stopped" if the listener cancels.
  void report(std::size_t read, std::size_t bytes);
  /// Calls the listener without progress.
  void poll() const;

 private:
  std::string m_file;
  double m_memory;
  double m_taken = 0;
  double m_done = 0;
  const plugin::Progress& m_progress;
};

// The scene's bytes for each point and triangle, in addition to the mesh.

constexpr double sceneBytesOfPoint = 3 * sizeof(float);
/// Corners, material and longest side; the list for finding repeated triangles; Embree's tree
/// during its construction, 87 to 133 bytes by its own report.
constexpr double sceneBytesOfTriangle = 24 + 16 + 140;

}  // namespace hogelscope::mesh
