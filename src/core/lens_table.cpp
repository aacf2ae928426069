// SPDX-License-Identifier: BSD-3-Clause
// The rays of a lens, one for each (sub-)pixel of a picture.
#include "core/lens_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hogelscope {

void serialRows(int count, const std::function<void(int begin, int end)>& rows) {
  rows(0, count);
}

namespace {

Vec2 onSensor(const LensKey& key, int x, int y, int sx, int sy) {
  const int n = key.samplesPerPixel;
  return {(x + (sx + 0.5) / n - 0.5 - key.centre.x) / key.focalLength,
          (y + (sy + 0.5) / n - 0.5 - key.centre.y) / key.focalLength};
}

}  // namespace

void lensRow(const LensKey& key, const QuickInverse& inverse, int y, int sx, int sy, int x0,
             int count, double* idealX, double* idealY) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const Distortion distortion(key.distortion);
  Vec2 previous;
  for (int k = 0; k < count; ++k) {
    const Vec2 pixel = onSensor(key, x0 + k, y, sx, sy);
    const std::optional<Vec2> ideal = key.mapping == LensMapping::direct
                                          ? distortion.distort(pixel)
                                          : inverse.undistort(pixel, previous);
    previous = ideal.value_or(Vec2{});
    idealX[k] = ideal ? ideal->x : none;
    idealY[k] = ideal ? ideal->y : none;
  }
}

std::size_t LensTable::bytes(const LensKey& key) {
  const auto samples = std::size_t(key.samplesPerPixel) * std::size_t(key.samplesPerPixel);
  return samples * std::size_t(key.res[0]) * std::size_t(key.res[1]) * 2 * sizeof(double);
}

LensTable::LensTable(const LensKey& key, const ParallelRows& parallelRows)
    : m_key(key),
      m_distortion(key.distortion),
      m_x(bytes(key) / (2 * sizeof(double))),
      m_y(m_x.size()) {
  const QuickInverse inverse{m_distortion};
  const int rows = key.res[1] * key.samplesPerPixel * key.samplesPerPixel;
  parallelRows(rows, [&](int begin, int end) {
    const int n = key.samplesPerPixel;
    for (int row = begin; row < end; ++row) {
      const std::size_t first = std::size_t(row) * std::size_t(key.res[0]);
      lensRow(key, inverse, row / (n * n), row % n, row / n % n, 0, key.res[0], &m_x[first],
              &m_y[first]);
    }
  });
}

std::size_t LensTable::at(int y, int sx, int sy) const {
  const auto n = std::size_t(m_key.samplesPerPixel);
  return ((std::size_t(y) * n + std::size_t(sy)) * n + std::size_t(sx)) * std::size_t(m_key.res[0]);
}

LensCertificate LensTable::certificate() const {
  LensCertificate certificate;
  const int n = m_key.samplesPerPixel;
  for (int y = 0; y < m_key.res[1]; ++y) {
    for (int s = 0; s < n * n; ++s) {
      const std::size_t first = at(y, s % n, s / n);
      for (int x = 0; x < m_key.res[0]; ++x) {
        ++certificate.pixels;
        const Vec2 ideal{m_x[first + std::size_t(x)], m_y[first + std::size_t(x)]};
        if (std::isnan(ideal.x)) {
          ++certificate.withoutRay;
          continue;
        }
        certificate.validRadius = std::max(certificate.validRadius, std::hypot(ideal.x, ideal.y));
        if (m_key.mapping == LensMapping::direct) continue;
        const Vec2 pixel = onSensor(m_key, x, y, s % n, s / n);
        const Vec2 back = m_distortion.distort(ideal);
        certificate.worstResidual =
            std::max(certificate.worstResidual,
                     m_key.focalLength * std::hypot(back.x - pixel.x, back.y - pixel.y));
      }
    }
  }
  return certificate;
}

std::shared_ptr<const LensTable> LensTables::get(const LensKey& key,
                                                 const ParallelRows& parallelRows) {
  const auto found = std::find_if(m_entries.begin(), m_entries.end(),
                                  [&key](const Entry& entry) { return entry.key == key; });
  if (found != m_entries.end()) {
    m_entries.splice(m_entries.begin(), m_entries, found);
    return m_entries.front().table;
  }
  std::size_t used = LensTable::bytes(key);
  for (auto entry = m_entries.begin(); entry != m_entries.end();) {
    used += LensTable::bytes(entry->key);
    entry = used > largestBytes ? m_entries.erase(entry) : std::next(entry);
  }
  m_entries.push_front({key, std::make_shared<const LensTable>(key, parallelRows)});
  return m_entries.front().table;
}

}  // namespace hogelscope
