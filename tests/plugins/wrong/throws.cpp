// SPDX-License-Identifier: BSD-3-Clause
// A plugin whose every function throws WHAT, except the one that makes its metric.
#include <hogelscope/plugin.h>

#include <stdexcept>

namespace {

using namespace hogelscope;

[[noreturn]] void fail() {
  throw WHAT;
}

class Content final : public plugin::ContentSource {
 public:
  void describe(ParameterVisitor&) override { fail(); }
  void open(const plugin::Panel&, const plugin::Place&, const plugin::Progress& progress) override {
    (void)progress.go(0.5);
    fail();
  }
  [[nodiscard]] std::vector<std::string> files() const override { fail(); }
  [[nodiscard]] std::vector<std::string> notes() const override { fail(); }
  void depths(double&, double&) const override { fail(); }
  void trace(std::span<const plugin::Ray>, std::span<plugin::Colour>) const override { fail(); }
  [[nodiscard]] bool traceDepths(std::span<const plugin::Ray>, std::span<double>) const override {
    fail();
  }
  [[nodiscard]] plugin::Triangles triangles() const override { fail(); }
};

class Metric final : public plugin::Metric {
 public:
  [[nodiscard]] const char* title() const override { fail(); }
  [[nodiscard]] const char* unit() const override { fail(); }
  [[nodiscard]] std::int32_t decimals() const override { fail(); }
  [[nodiscard]] double compare(const plugin::View&, const plugin::View&,
                               const plugin::Viewing&) const override {
    fail();
  }
};

class Lens final : public plugin::HogelLens {
 public:
  void describe(ParameterVisitor&) override { fail(); }
  void open(std::int32_t, double, const plugin::Place&) override { fail(); }
  [[nodiscard]] double directionOf(double) const override { fail(); }
  [[nodiscard]] double slopeOf(double) const override { fail(); }
};

plugin::ContentSource* makeContent() {
  return new Content;
}
plugin::HogelLens* makeLens() {
  return new Lens;
}
plugin::Metric* makeMetric() {
  return new Metric;
}

}  // namespace

HOGELSCOPE_PLUGIN("wrong", "1.0", makeContent, makeLens, makeMetric);
