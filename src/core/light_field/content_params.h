// SPDX-License-Identifier: BSD-3-Clause
// The parameters of a live scene's content, whatever they are: the values that its describe()
// visits, by name.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

/// A value that can be copied and compared, unlike the content itself.
class ContentParams {
 public:
  using Value = std::variant<bool, int, std::string, std::vector<int>, std::vector<double>>;
  using MakeContent = std::function<std::unique_ptr<plugin::ContentSource>()>;

  /// No content.
  ContentParams() = default;
  /// The content's own values. Throws what `make` throws.
  explicit ContentParams(MakeContent make);

  [[nodiscard]] bool isGiven() const { return bool(m_make); }
  /// Makes content with these values, to be opened. There must be content.
  [[nodiscard]] std::unique_ptr<plugin::ContentSource> makeContent() const;
  /// Lets a visitor read and set the values.
  void visit(ParameterVisitor& v);
  /// Passes the content's file to `change`, and sets it to the result: a text named "file".
  void changeFile(const std::function<std::string(const std::string&)>& change);
  /// Returns the value of this name; null unless there is one of this type.
  template <class T>
  [[nodiscard]] const T* find(std::string_view name) const {
    const auto found = std::ranges::find(m_values, name, &NamedValue::name);
    return found == m_values.end() ? nullptr : std::get_if<T>(&found->value);
  }
  /// Sets a value that find() finds; changes nothing else.
  template <class T>
  void set(std::string_view name, const T& value) {
    for (NamedValue& known : m_values)
      if (known.name == name && std::holds_alternative<T>(known.value)) known.value = value;
  }

  bool operator==(const ContentParams& other) const { return m_values == other.m_values; }

 private:
  struct NamedValue {
    std::string name;
    Value value;
    bool operator==(const NamedValue&) const = default;
  };
  class Writer;
  class Reader;

  MakeContent m_make;
  std::vector<NamedValue> m_values;
};

inline void describe(ParameterVisitor& v, ContentParams& p) {
  p.visit(v);
}

/// The sampling of a live scene. A texel is the mean over `samples` points of hogel aperture ×
/// directional pixel, on a rank-1 lattice that is the same for every texel.
struct LiveParams {
  int samples = 1;                       ///< 1: the middle alone
  std::array<double, 2> fill{1, 1};      ///< sampled part of a hogel's side, of a direction's
  std::array<double, 2> depth{-10, 10};  ///< content is cut to these z, metres
  bool operator==(const LiveParams&) const = default;
};

void describe(ParameterVisitor& v, LiveParams& p);

}  // namespace hogelscope
