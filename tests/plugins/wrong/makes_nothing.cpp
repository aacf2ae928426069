// SPDX-License-Identifier: BSD-3-Clause
// A plugin whose functions make nothing: one throws, one returns null, one is missing.
#include <hogelscope/plugin.h>

#include <stdexcept>

namespace {

using namespace hogelscope;

plugin::ContentSource* makeContent() {
  throw std::runtime_error("no licence\nfor this machine\n");
}
plugin::HogelLens* makeLens() {
  return nullptr;
}

}  // namespace

HOGELSCOPE_PLUGIN("wrong", "1.0", makeContent, makeLens, nullptr);
