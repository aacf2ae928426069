// SPDX-License-Identifier: BSD-3-Clause
// Takes the values out of content, and puts them into it.
#include "core/light_field/content_params.h"

#include <algorithm>

namespace hogelscope {

/// Lists the values of content.
class ContentParams::Reader : public ParameterVisitor {
 public:
  void group(std::string_view, std::string_view) override {}
  std::vector<NamedValue> values;

 protected:
  void numbers(const Field& field, std::span<double> list, bool) override {
    values.push_back({std::string(field.name), std::vector<double>(list.begin(), list.end())});
  }
  void integers(const Field& field, std::span<int> list, bool) override {
    values.push_back({std::string(field.name), std::vector<int>(list.begin(), list.end())});
  }
  void flag(const Field& field, bool& value) override {
    values.push_back({std::string(field.name), value});
  }
  void text(const Field& field, std::string& value) override {
    values.push_back({std::string(field.name), value});
  }
  void choice(const Field& field, int& index) override {
    values.push_back({std::string(field.name), index});
  }
};

/// Sets the values of content.
class ContentParams::Writer : public ParameterVisitor {
 public:
  explicit Writer(const std::vector<NamedValue>& values) : m_values(values) {}
  void group(std::string_view, std::string_view) override {}

 protected:
  void numbers(const Field& field, std::span<double> list, bool) override { copy(field, list); }
  void integers(const Field& field, std::span<int> list, bool) override { copy(field, list); }
  void flag(const Field& field, bool& value) override { assign(field, value); }
  void text(const Field& field, std::string& value) override { assign(field, value); }
  void choice(const Field& field, int& index) override { assign(field, index); }

 private:
  template <class T>
  [[nodiscard]] const T* find(const Field& field) const {
    const auto found = std::ranges::find(m_values, field.name, &NamedValue::name);
    return found == m_values.end() ? nullptr : std::get_if<T>(&found->value);
  }
  template <class T>
  void assign(const Field& field, T& value) const {
    if (const T* known = find<T>(field)) value = *known;
  }
  template <class T>
  void copy(const Field& field, std::span<T> list) const {
    const auto* known = find<std::vector<T>>(field);
    if (known != nullptr && known->size() == list.size()) std::ranges::copy(*known, list.begin());
  }

  const std::vector<NamedValue>& m_values;
};

ContentParams::ContentParams(MakeContent make) : m_make(std::move(make)) {
  Reader reader;
  m_make()->describe(reader);
  m_values = std::move(reader.values);
}

std::unique_ptr<plugin::ContentSource> ContentParams::makeContent() const {
  auto content = m_make();
  Writer writer(m_values);
  content->describe(writer);
  return content;
}

void ContentParams::visit(ParameterVisitor& v) {
  const auto content = makeContent();
  content->describe(v);
  Reader reader;
  content->describe(reader);
  m_values = std::move(reader.values);
}

void ContentParams::changeFile(const std::function<std::string(const std::string&)>& change) {
  for (auto& [name, value] : m_values)
    if (auto* text = std::get_if<std::string>(&value); text != nullptr && name == "file")
      *text = change(*text);
}

void describe(ParameterVisitor& v, LiveParams& p) {
  auto& [samples, fill, depth] = p;
  v.group("live", "How a 3-D scene becomes directional pixels.");
  v.field("samples", samples, {1, 4096, 1}, "",
          "Rays of a directional pixel, over its hogel's area and its angle; 1: the middle ray.");
  v.field("fill", fill, {0, 1, 0.05}, "",
          "Part of a hogel's side, and of a direction's, over which the rays are spread.");
  v.field("depth", depth, {-1e6, 1e6, 0.01}, "m",
          "Content behind the first and in front of the second depth is left out.");
}

}  // namespace hogelscope
