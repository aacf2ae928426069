// SPDX-License-Identifier: BSD-3-Clause
#include "core/lens/lens_rays.h"

#include "core/lens/lens_steps.h"

namespace hogelscope {

LensRays::LensRays(const LensKey& key, const Progress& progress)
    : m_key(key), m_exact(Distortion(key.distortion), progress) {
  if (key.mapping == LensMapping::exact && key.inverse == LensInverse::table) makeNodes();
}

void LensRays::row(int y, const RaySample& sample, int x0, int count, double* idealX,
                   double* idealY) const {
  const double py = y + sample.place.y - 0.5;
  for (int k = 0; k < count; ++k) {
    const double px = x0 + k + sample.place.x - 0.5;
    const Vec2 point = m_nodeX.empty() ? m_key.onSensor(px, py) : betweenNodes(px, py);
    idealX[k] = point.x;
    idealY[k] = point.y;
  }
  if (m_key.mapping == LensMapping::exact) {
    if (m_nodeX.empty()) invert(idealX, idealY, count);
    return;
  }
  const Distortion distortion(m_key.distortion);
  for (int k = 0; k < count; ++k) {
    const Vec2 ideal = distortion.distort({idealX[k], idealY[k]});
    idealX[k] = ideal.x;
    idealY[k] = ideal.y;
  }
}

void LensRays::invert(double* x, double* y, int count) const {
  if (m_key.inverse == LensInverse::exact || m_key.inverse == LensInverse::table)
    return m_exact.undistort(x, y, count);
  const std::vector<double> distortedX(x, x + count);
  const std::vector<double> distortedY(y, y + count);
  std::vector<double> notes(std::size_t(count), 0.0);
  for (int step = 0; step < m_key.steps; ++step) {
    if (m_key.inverse == LensInverse::newton)
      newtonStep(m_key.distortion, distortedX.data(), distortedY.data(), count, x, y, notes.data());
    else
      fixedPointStep(m_key.distortion, distortedX.data(), distortedY.data(), count, x, y,
                     notes.data());
  }
}

/// Nodes lie on the pixels' outer edges, starting at the image's upper left corner.
void LensRays::makeNodes() {
  const int spacing = m_key.steps;
  const auto nodes = [spacing](int pixels) { return (pixels + spacing - 1) / spacing + 1; };
  m_nodesAcross = nodes(m_key.res[0]);
  for (int row = 0; row < nodes(m_key.res[1]); ++row)
    for (int column = 0; column < m_nodesAcross; ++column) {
      const Vec2 point = m_key.onSensor(column * spacing - 0.5, row * spacing - 0.5);
      m_nodeX.push_back(point.x);
      m_nodeY.push_back(point.y);
    }
  m_exact.undistort(m_nodeX.data(), m_nodeY.data(), int(m_nodeX.size()));
}

/// Interpolates bilinearly; no ray where one of the four nodes has none.
Vec2 LensRays::betweenNodes(double px, double py) const {
  const double column = (px + 0.5) / m_key.steps;
  const double row = (py + 0.5) / m_key.steps;
  const auto i = std::size_t(column);
  const auto j = std::size_t(row);
  const double a = column - double(i);
  const double b = row - double(j);
  const std::size_t at = j * std::size_t(m_nodesAcross) + i;
  const auto mean = [&](const std::vector<double>& node) {
    const double* upper = &node[at];
    const double* lower = upper + m_nodesAcross;
    return (1 - b) * ((1 - a) * upper[0] + a * upper[1]) + b * ((1 - a) * lower[0] + a * lower[1]);
  };
  return {mean(m_nodeX), mean(m_nodeY)};
}

}  // namespace hogelscope
