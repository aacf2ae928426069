// SPDX-License-Identifier: BSD-3-Clause
// Compares two states by a visitor of their descriptions.
#include "core/changed_field.h"

#include <vector>

namespace hogelscope {

namespace {

/// All values in the order of the descriptions.
class Values : public ParameterVisitor {
 public:
  struct Value {
    std::string name;
    std::vector<double> numbers;
    std::string text;
    bool operator==(const Value&) const = default;
  };

  explicit Values(CameraState state) {
    describe(*this, state.camera);
    describe(*this, state.intrinsics);
    describe(*this, state.distortion);
    describe(*this, state.psf);
  }
  std::vector<Value> values;

 private:
  void group(std::string_view, std::string_view) override {}
  void numbers(const Field& field, std::span<double> list, bool) override {
    values.push_back({std::string(field.name), {list.begin(), list.end()}, {}});
  }
  void integers(const Field& field, std::span<int> list, bool) override {
    values.push_back({std::string(field.name), {list.begin(), list.end()}, {}});
  }
  void flag(const Field& field, bool& value) override {
    values.push_back({std::string(field.name), {double(value)}, {}});
  }
  void text(const Field& field, std::string& value) override {
    values.push_back({std::string(field.name), {}, value});
  }
  void choice(const Field& field, int& index) override {
    values.push_back({std::string(field.name), {double(index)}, {}});
  }
};

}  // namespace

std::string changedField(const CameraState& before, const CameraState& after) {
  const std::vector<Values::Value> old = Values(before).values;
  const std::vector<Values::Value> now = Values(after).values;
  for (std::size_t k = 0; k < old.size(); ++k)
    if (!(old[k] == now[k])) return old[k].name;
  return {};
}

}  // namespace hogelscope
