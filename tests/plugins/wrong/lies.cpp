// SPDX-License-Identifier: BSD-3-Clause
// A plugin whose results are not what the SDK says. Its parameters choose which.
#include <hogelscope/plugin.h>

#include <limits>

namespace {

using namespace hogelscope;

class Content final : public plugin::ContentSource {
 public:
  void describe(ParameterVisitor& v) override {
    v.group("wrong", "What is wrong.");
    v.field("corner", m_corner, {-1, 9, 1}, "", "A triangle's last point, of three.");
    v.field("fill", m_fill, {0, 9, 1}, "", "Has the name of a parameter of every live scene.");
  }
  void open(const plugin::Panel&, const plugin::Place&, const plugin::Progress&) override {}
  [[nodiscard]] std::vector<std::string> notes() const override {
    return std::vector<std::string>(1000, "two\nlines\x1b[2J");
  }
  void depths(double& back, double& front) const override {
    back = 1;
    front = std::numeric_limits<double>::quiet_NaN();
  }
  void trace(std::span<const plugin::Ray>, std::span<plugin::Colour>) const override {}
  [[nodiscard]] plugin::Triangles triangles() const override {
    return {std::vector<float>(9), {0, 1, std::uint32_t(m_corner)}, std::vector<std::uint8_t>(9)};
  }

 private:
  int m_corner = 2;
  int m_fill = 0;
};

class Metric final : public plugin::Metric {
 public:
  [[nodiscard]] const char* title() const override { return nullptr; }
  [[nodiscard]] const char* unit() const override { return "two\nlines"; }
  [[nodiscard]] std::int32_t decimals() const override { return -5; }
  [[nodiscard]] double compare(const plugin::View&, const plugin::View&,
                               const plugin::Viewing&) const override {
    return 0;
  }
};

plugin::ContentSource* makeContent() {
  return new Content;
}
plugin::Metric* makeMetric() {
  return new Metric;
}

}  // namespace

HOGELSCOPE_PLUGIN("wrong", "1.0", makeContent, nullptr, makeMetric);
