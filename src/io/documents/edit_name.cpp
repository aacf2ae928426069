// SPDX-License-Identifier: BSD-3-Clause
// Compares states and sessions by a visitor of their descriptions.
#include "io/documents/edit_name.h"

#include <algorithm>
#include <vector>

#include "io/documents/session_parts.h"

namespace hogelscope {

namespace {

/// Collects all values in the order of the descriptions.
class Values : public ParameterVisitor, public SectionVisitor {
 public:
  struct Value {
    std::string name;
    std::vector<double> numbers;
    std::string text;
    bool operator==(const Value&) const = default;
  };

  template <class Described>
  explicit Values(Described described) {
    parts(described);
  }
  std::vector<Value> all;

 private:
  ParameterVisitor* fieldVisitor() override { return this; }
  bool begin(std::string_view /*name*/, bool /*isWritten*/) override { return true; }
  void end() override {}
  /// A file's name comes last, since an edit of what is in it drops the name.
  bool document(std::string_view name, std::string& file, bool isWritten,
                const Visit& visit) override {
    visit();
    all.push_back({std::string(name), {}, file});
    return isWritten;
  }
  bool value(std::string_view name, bool isWritten, const ReadValue& /*read*/,
             const WriteValue& write) override {
    all.push_back({std::string(name), {}, isWritten ? write().dump() : ""});
    return true;
  }

  void group(std::string_view, std::string_view) override {}
  void numbers(const Field& field, std::span<double> list, bool) override {
    all.push_back({std::string(field.name), {list.begin(), list.end()}, {}});
  }
  void integers(const Field& field, std::span<int> list, bool) override {
    all.push_back({std::string(field.name), {list.begin(), list.end()}, {}});
  }
  void flag(const Field& field, bool& value) override {
    all.push_back({std::string(field.name), {double(value)}, {}});
  }
  void text(const Field& field, std::string& value) override {
    all.push_back({std::string(field.name), {}, value});
  }
  void choice(const Field& field, int& index) override {
    all.push_back({std::string(field.name), {double(index)}, {}});
  }
};

/// Returns the first change. A choice comes before the fields that only one of its values has.
template <class Described>
std::string firstChange(const Described& before, const Described& after) {
  const std::vector<Values::Value> old = Values(before).all;
  const std::vector<Values::Value> now = Values(after).all;
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
