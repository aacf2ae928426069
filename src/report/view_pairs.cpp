// SPDX-License-Identifier: BSD-3-Clause
// The pictures that a report compares.
#include "report/view_pairs.h"

#include <new>

namespace hogelscope {

ViewPairs::ViewPairs(Session session, std::size_t workers, ParallelRows rowsWithin,
                     bool keepsReferences)
    : m_session(std::move(session)),
      m_rowsWithin(std::move(rowsWithin)),
      m_references(keepsReferences ? m_session.cameras.size() : 0),
      m_tables(workers) {}

const Scene& ViewPairs::readReference(const Progress& progress) {
  return m_reference.emplace(loadScene(m_session, progress));
}

const Scene& ViewPairs::readTest(const Session& test, const Progress& progress) {
  m_test.reset();
  return m_test.emplace(loadScene(test, progress));
}

View ViewPairs::view(std::size_t state) const {
  return m_reference->view(m_session.cameras[state]);
}

ViewPair ViewPairs::render(std::size_t state, std::size_t worker, const Progress& progress) {
  const auto rendered = [&](const Scene& scene) {
    return simulateFast(scene.view(m_session.cameras[state]), m_tables[worker], m_rowsWithin,
                        progress);
  };
  const bool isKept = !m_references.empty() && !m_references[state].seen.empty();
  try {
    ViewPair pair{isKept ? m_references[state] : rendered(*m_reference), rendered(*m_test), {}};
    if (!m_references.empty()) m_references[state] = pair.reference;
    return pair;
  } catch (const InputError& error) {
    return {{}, {}, error.what()};
  } catch (const std::bad_alloc&) {
    return {{}, {}, "not enough memory for its picture"};
  }
}

}  // namespace hogelscope
