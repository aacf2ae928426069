// SPDX-License-Identifier: BSD-3-Clause
// The pictures that a report compares: a state's from the session's light field and from a test's.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/fast_simulation.h"
#include "io/light_field_file.h"

namespace hogelscope {

/// Of one state, or why there are none.
struct ViewPair {
  Image reference;
  Image test;
  std::string problem;
};

/// Two light fields are in memory at a time, each read once. Different states may be rendered by
/// different workers at the same time.
class ViewPairs {
 public:
  /// `rowsWithin` is how the rows of one picture are shared out.
  ViewPairs(Session session, std::size_t workers, ParallelRows rowsWithin, bool keepsReferences);

  const Scene& readReference(const Progress& progress);
  void takeReference(const Scene& scene) { m_reference = scene; }
  /// The last test's memory is free before the next one is read.
  const Scene& readTest(const Session& test, const Progress& progress);

  /// `progress` may be called from several threads. Throws Cancelled.
  ViewPair render(std::size_t state, std::size_t worker, const Progress& progress);
  [[nodiscard]] View view(std::size_t state) const;
  [[nodiscard]] const DisplayParams& display() const { return m_reference->display; }
  [[nodiscard]] LensTables& tables(std::size_t worker) { return m_tables[worker]; }
  [[nodiscard]] const ParallelRows& rowsWithin() const { return m_rowsWithin; }

 private:
  Session m_session;
  ParallelRows m_rowsWithin;
  std::optional<Scene> m_reference;
  std::optional<Scene> m_test;
  std::vector<Image> m_references;  ///< of the states rendered, if they are kept for more tests
  std::vector<LensTables> m_tables;
};

}  // namespace hogelscope
