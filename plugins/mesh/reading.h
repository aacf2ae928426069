// SPDX-License-Identifier: BSD-3-Clause
// The memory that one mesh may take, and the listener of its reading; all its readers share them.
#pragma once

#include <cstdint>
#include <string>

#include "hogelscope/plugin.h"

namespace hogelscope::mesh {

class Reading {
 public:
  /// `file` is the mesh's own, for messages; `memory` are the bytes for all that is made of it.
  Reading(std::string file, std::uint64_t memory, const plugin::Progress& progress);

  [[nodiscard]] const std::string& file() const { return m_file; }

  /// Counts bytes before they are allocated and kept. Throws if the mesh has then too many.
  void take(double bytes);
  /// Returns what a file holds, taking its size, or throws.
  [[nodiscard]] std::string bytesOf(const std::string& file);
  /// Tells the listener how much of a file has been read. Throws "stopped" if it stops.
  void report(std::size_t read, std::size_t bytes);
  /// Asks the listener alone.
  void poll() const;

 private:
  std::string m_file;
  double m_memory;
  double m_taken = 0;
  double m_done = 0;
  const plugin::Progress& m_progress;
};

// The bytes that the scene keeps of each point and triangle besides the mesh.

constexpr double sceneBytesOfPoint = 3 * sizeof(float);
/// Corners, material and longest side; the list that finds repeated triangles; Embree's tree while
/// it is built, 87 to 133 in its own account.
constexpr double sceneBytesOfTriangle = 24 + 16 + 140;

}  // namespace hogelscope::mesh
