// SPDX-License-Identifier: BSD-3-Clause
// A metric that returns WHAT of what it is told. Nothing is wrong with it, but for that.
#include <hogelscope/plugin.h>
#include <unistd.h>

#include <cstdlib>
#include <new>
#include <numeric>

namespace {

using namespace hogelscope;

[[maybe_unused]] double meanOf(const plugin::View& view) {
  return std::accumulate(view.values.begin(), view.values.end(), 0.0) / double(view.values.size());
}

[[noreturn, maybe_unused]] double leave() {
  std::exit(0);
}
[[noreturn, maybe_unused]] double askTooMuch() {
  throw std::bad_alloc();
}

class Told final : public plugin::Metric {
 public:
  [[nodiscard]] const char* title() const override { return NAME; }
  [[nodiscard]] double compare([[maybe_unused]] const plugin::View& reference,
                               [[maybe_unused]] const plugin::View& test,
                               [[maybe_unused]] const plugin::Viewing& viewing) const override {
    return WHAT;
  }
};

plugin::Metric* makeTold() {
  return new Told;
}

}  // namespace

HOGELSCOPE_PLUGIN(NAME, "1.0", nullptr, nullptr, makeTold);
