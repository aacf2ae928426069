// SPDX-License-Identifier: BSD-3-Clause
// Compares states and sessions by a visitor of their descriptions.
#include "io/documents/edit_name.h"

#include <algorithm>
#include <vector>

#include "io/documents/light_field_params.h"

namespace hogelscope {

namespace {

/// Collects all values in the order of the descriptions.
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
    describe(*this, state.pupil);
    describe(*this, state.stereo);
    describe(*this, state.distortion);
    describe(*this, state.psf);
  }
  explicit Values(Session session) {
    describe(*this, session.display);
    if (session.display.lensParams.isGiven()) describe(*this, session.display.lensParams);
    describe(*this, session.twin.lensArray);
    describe(*this, session.twin.colour);
    describe(*this, session.twin.leakage);
    describe(*this, session.twin.light);
    describe(*this, session.twin.random);
    describe(*this, session.twin.random.shift);
    describe(*this, session.twin.random.gain);
    describe(*this, session.twin.maps);
    describe(*this, session.lightField);
    if (session.lightField.content.isGiven()) describe(*this, session.lightField.content);
    describe(*this, session.lightField.live);
    describe(*this, session.sampling);
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

/// Returns the first change. A choice comes before the fields that only one of its values has.
template <class Described>
std::string firstChange(const Described& before, const Described& after) {
  const std::vector<Values::Value> old = Values(before).values;
  const std::vector<Values::Value> now = Values(after).values;
  const auto [changed, newer] = std::mismatch(old.begin(), old.end(), now.begin(), now.end());
  if (changed != old.end()) return changed->name;
  return newer != now.end() ? newer->name : "";
}

}  // namespace

std::string changedField(const CameraState& before, const CameraState& after) {
  return firstChange(before, after);
}

std::string changedField(const Session& before, const Session& after) {
  return firstChange(before, after);
}

}  // namespace hogelscope
