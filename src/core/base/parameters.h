// SPDX-License-Identifier: BSD-3-Clause
// The single declaration of each parameter: a struct's `describe` passes each field's name, value,
// range, unit and help to a visitor. JSON, forms, --set, --help and the manual are such visitors.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/base/geometry.h"

namespace hogelscope {

/// The allowed values: min to max. Integers go in steps from min; for real numbers only forms use
/// the step. A default outside its own range means "not given" and is never written.
struct Range {
  double min = 0;
  double max = 0;
  double step = 1;
  bool mayBeLeftOut = false;  ///< left out is notGiven for a real number, min - 1 for an integer
  /// The values that people use, if they are fewer than the allowed ones; otherwise all of them.
  double slideMin = 0;
  double slideMax = 0;
};

/// A field's name in documents and its label in forms; without a label, forms derive it, "Window
/// size" from "windowSize".
struct FieldName {
  std::string_view name;
  std::string_view label = {};
  FieldName(const char* document) : name(document) {}  // NOLINT: implicit conversion
  FieldName(const char* document, const char* form) : name(document), label(form) {}
};

/// The value of an omitted real number; it is outside every range.
constexpr double notGiven = std::numeric_limits<double>::lowest();

struct Field {
  std::string_view name;
  std::string_view help;
  std::string_view unit = {};
  Range range = {};
  std::span<const std::string_view> choices = {};  ///< names of an enumeration's values, in order
  std::string_view label = {};
  bool counts = true;  ///< false if another field's value makes it meaningless; forms then hide it
  bool mayBeNumber = false;  ///< of a text: a whole number stands for its digits
};

class ParameterVisitor {
 public:
  virtual ~ParameterVisitor() = default;

  /// Starts a section. Every `describe` calls it first.
  virtual void group(std::string_view name, std::string_view help) = 0;
  /// Sets whether the following fields count, which other fields decide.
  void count(bool doCount) { m_count = doCount; }

  void field(const FieldName& name, double& value, Range range, std::string_view unit,
             std::string_view help) {
    numbers(described(name, help, unit, range), {&value, 1}, false);
  }
  void field(const FieldName& name, int& value, Range range, std::string_view unit,
             std::string_view help) {
    integers(described(name, help, unit, range), {&value, 1}, false);
  }
  template <std::size_t N>
  void field(const FieldName& name, std::array<double, N>& value, Range range,
             std::string_view unit, std::string_view help) {
    numbers(described(name, help, unit, range), value, true);
  }
  template <std::size_t N>
  void field(const FieldName& name, std::array<int, N>& value, Range range, std::string_view unit,
             std::string_view help) {
    integers(described(name, help, unit, range), value, true);
  }
  void field(const FieldName& name, Vec3& value, Range range, std::string_view unit,
             std::string_view help) {
    std::array<double, 3> list{value.x, value.y, value.z};
    numbers(described(name, help, unit, range), list, true);
    value = {list[0], list[1], list[2]};
  }
  void field(const FieldName& name, bool& value, std::string_view help) {
    flag(described(name, help), value);
  }
  void field(const FieldName& name, std::string& value, std::string_view help) {
    text(described(name, help), value);
  }
  /// Visits a text that documents may also give as a whole number, such as a part of a file.
  void nameOrNumber(const FieldName& name, std::string& value, std::string_view help) {
    Field described = this->described(name, help);
    described.mayBeNumber = true;
    text(described, value);
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void field(const FieldName& name, Enum& value, std::span<const std::string_view> names,
             std::string_view help) {
    int index = static_cast<int>(value);
    choice(described(name, help, {}, {}, names), index);
    value = static_cast<Enum>(index);
  }

 protected:
  /// Visits a list of numbers, or one number if `isList` is false.
  virtual void numbers(const Field& field, std::span<double> values, bool isList) = 0;
  virtual void integers(const Field& field, std::span<int> values, bool isList) = 0;
  virtual void flag(const Field& field, bool& value) = 0;
  virtual void text(const Field& field, std::string& value) = 0;
  virtual void choice(const Field& field, int& index) = 0;

 private:
  [[nodiscard]] Field described(const FieldName& name, std::string_view help,
                                std::string_view unit = {}, const Range& range = {},
                                std::span<const std::string_view> choices = {}) const {
    return {name.name, help, unit, range, choices, name.label, m_count};
  }

  bool m_count = true;
};

/// Returns the name nearest to a mistyped one (edit distance), or "" if none is near.
std::string_view nearestName(std::string_view name, std::span<const std::string_view> known);

}  // namespace hogelscope
