// SPDX-License-Identifier: BSD-3-Clause
// The parameters of a plugin's object: the values that its describe() visits, by name. Unlike the
// object itself, they can be copied and compared.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/parameters.h"

namespace hogelscope {

/// Throws InputError at `path` unless the name is 1 to 40 lower-case letters, digits and "-",
/// starting with a letter.
void checkPluginName(const std::string& name, const std::string& path);

/// Parameter values by name.
class NamedValues {
 public:
  using Describe = std::function<void(ParameterVisitor&)>;

  /// Reads the values that `describe` visits.
  void take(const Describe& describe);
  /// Writes the values that `describe` visits and that have the same name, type and size.
  void give(const Describe& describe) const;
  /// Returns the value of this name; null if there is none of this type.
  template <class T>
  [[nodiscard]] const T* find(std::string_view name) const {
    const auto found = std::ranges::find(m_values, name, &Value::name);
    return found == m_values.end() ? nullptr : std::get_if<T>(&found->value);
  }
  /// Sets an existing value of this type; otherwise does nothing.
  template <class T>
  void set(std::string_view name, const T& value) {
    for (Value& known : m_values)
      if (known.name == name && std::holds_alternative<T>(known.value)) known.value = value;
  }
  /// Returns the file names: non-empty texts whose names begin with "file".
  [[nodiscard]] std::vector<std::string> files() const;
  /// Replaces each of files() by the result of `change`.
  void changeFiles(const std::function<std::string(const std::string&)>& change);

  bool operator==(const NamedValues&) const = default;

 private:
  struct Value {
    std::string name;
    std::variant<bool, int, std::string, std::vector<int>, std::vector<double>> value;
    bool operator==(const Value&) const = default;
  };
  class Writer;
  class Reader;

  std::vector<Value> m_values;
};

/// The values of an object with the interface `Object` of the SDK.
template <class Object>
class PluginParams : public NamedValues {
 public:
  using Make = std::function<std::unique_ptr<Object>()>;

  /// Creates parameters without an object.
  PluginParams() = default;
  /// Takes the values of a new object. Throws what `make` throws.
  explicit PluginParams(Make make) : m_make(std::move(make)) { takeFrom(*m_make()); }

  [[nodiscard]] bool isGiven() const { return bool(m_make); }
  /// Creates an object with these values, not yet opened. Requires an object.
  [[nodiscard]] std::unique_ptr<Object> make() const {
    auto object = m_make();
    give([&](ParameterVisitor& v) { object->describe(v); });
    return object;
  }
  /// Lets a visitor read and set the values.
  void visit(ParameterVisitor& v) {
    const auto object = make();
    object->describe(v);
    takeFrom(*object);
  }

  bool operator==(const PluginParams& other) const { return NamedValues::operator==(other); }

 private:
  void takeFrom(Object& object) {
    take([&](ParameterVisitor& v) { object.describe(v); });
  }

  Make m_make;
};

template <class Object>
void describe(ParameterVisitor& v, PluginParams<Object>& p) {
  p.visit(v);
}

}  // namespace hogelscope
