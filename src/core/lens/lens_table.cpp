// SPDX-License-Identifier: BSD-3-Clause
#include "core/lens/lens_table.h"

#include <algorithm>

namespace hogelscope {

std::size_t LensTable::bytes(const std::array<int, 2>& res, int samplesPerPixel) {
  const auto samples = std::size_t(samplesPerPixel) * std::size_t(samplesPerPixel);
  return samples * std::size_t(res[0]) * std::size_t(res[1]) * 2 * sizeof(double);
}

std::size_t LensTable::bytes(const LensKey& key) {
  return bytes(key.res, key.samplesPerPixel) +
         (key.hasStrips ? LensStrips::inImage(key.res) * sizeof(LensStrips) : 0);
}

LensTable::LensTable(const LensKey& key, const ParallelRows& parallelRows, const Progress& progress)
    : m_key(key), m_x(at(key.res[1], 0)), m_y(m_x.size()) {
  const Progress heard = forThreads(progress);
  const LensRays rays(key, heard);
  const std::vector<RaySample> samples = samplesOf(key.samplesPerPixel);
  const int n = int(samples.size());
  const StripFit fit(key.res[0]);
  if (key.hasStrips) m_strips.resize(LensStrips::inImage(key.res));
  parallelRows(key.res[1] * n, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      throwIfCancelled(heard);
      const std::size_t first = std::size_t(row) * std::size_t(key.res[0]);
      rays.row(row / n, samples[std::size_t(row % n)], 0, key.res[0], &m_x[first], &m_y[first]);
      if (key.hasStrips) fit.row(&m_x[first], &m_y[first], row, m_strips.data());
    }
  });
}

std::size_t LensTable::at(int y, int sample) const {
  const auto n = std::size_t(m_key.samplesPerPixel);
  return (std::size_t(y) * n * n + std::size_t(sample)) * std::size_t(m_key.res[0]);
}

std::shared_ptr<const LensTable> LensTables::get(const LensKey& key,
                                                 const ParallelRows& parallelRows,
                                                 const Progress& progress) {
  const auto found = std::ranges::find(m_entries, key, &Entry::key);
  if (found != m_entries.end()) {
    m_entries.splice(m_entries.begin(), m_entries, found);
    return m_entries.front().table;
  }
  std::size_t used = LensTable::bytes(key);
  for (auto entry = m_entries.begin(); entry != m_entries.end();) {
    used += LensTable::bytes(entry->key);
    entry = used > largestBytes ? m_entries.erase(entry) : std::next(entry);
  }
  m_entries.push_front({key, std::make_shared<const LensTable>(key, parallelRows, progress)});
  return m_entries.front().table;
}

}  // namespace hogelscope
