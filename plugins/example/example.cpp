// SPDX-License-Identifier: BSD-3-Clause
// A minimal plugin: a plane with a grating, parallel to the panel.
#include <hogelscope/plugin.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace {

using namespace hogelscope;

class Grating final : public plugin::ContentSource {
 public:
  void describe(ParameterVisitor& v) override {
    v.group("example", "A plane with upright bars, parallel to the panel.");
    v.field("z", m_depth, {-10, 10, 0.01}, "m", "Where the plane is; above 0 in front.");
    v.field("frequency", m_frequency, {0, 10000, 10}, "1/m", "Bars in a metre.");
    v.field("size", m_size, {0, 100, 0.01}, "m", "Width and height of the plane; 0: no end.");
  }

  void open(const plugin::Panel& panel, const plugin::Place&, const plugin::Progress&) override {
    // A pair of bars narrower than two hogels would alias.
    if (m_depth == 0 && m_frequency * 2 * panel.size[0] > panel.hogels[0])
      throw std::runtime_error("frequency: is above what the panel's hogels can show");
  }

  void depths(double& back, double& front) const override { back = front = m_depth; }

  void trace(std::span<const plugin::Ray> rays, std::span<plugin::Colour> colours) const override {
    for (std::size_t k = 0; k < rays.size(); ++k) {
      const plugin::Ray& ray = rays[k];
      const double t = ray.z - m_depth;  // from the viewer's side towards smaller z
      const double x = ray.x - ray.a * t;
      const double y = ray.y - ray.b * t;
      const bool isOnPlane = m_size == 0 || std::max(std::abs(x), std::abs(y)) <= m_size / 2;
      const bool isHit = t >= 0 && t <= ray.reach && isOnPlane;
      const auto light = float(127.5 + 127.5 * std::cos(2 * std::numbers::pi * m_frequency * x));
      colours[k] = isHit ? plugin::Colour{light, light, light} : plugin::Colour{};
    }
  }

  [[nodiscard]] plugin::Triangles triangles() const override {
    const auto half = float(m_size == 0 ? 1 : m_size / 2);
    const auto z = float(m_depth);
    return {{-half, -half, z, half, -half, z, half, half, z, -half, half, z},
            {0, 1, 2, 0, 2, 3},
            std::vector<std::uint8_t>(12, 128)};
  }

 private:
  double m_depth = -0.05;
  double m_frequency = 40;
  double m_size = 0;
};

plugin::ContentSource* makeGrating() {
  return new Grating;
}

}  // namespace

HOGELSCOPE_PLUGIN("example", "1.0", makeGrating, nullptr, nullptr);
