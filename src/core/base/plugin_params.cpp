// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/plugin_params.h"

#include "core/base/error.h"

namespace hogelscope {

void checkPluginName(const std::string& name, const std::string& path) {
  constexpr std::size_t longest = 40;
  const auto isLetter = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto isAllowed = [&](char c) { return isLetter(c) || (c >= '0' && c <= '9') || c == '-'; };
  if (!name.empty() && name.size() <= longest && isLetter(name[0]) &&
      std::ranges::all_of(name, isAllowed))
    return;
  throw InputError(path, "\"" + name.substr(0, longest) +
                             "\" is not a plugin's name: small letters, digits and \"-\"");
}

/// Collects the visited values.
class NamedValues::Reader : public ParameterVisitor {
 public:
  void group(std::string_view, std::string_view) override {}
  std::vector<Value> values;

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

/// Sets the visited values.
class NamedValues::Writer : public ParameterVisitor {
 public:
  explicit Writer(const NamedValues& values) : m_values(values) {}
  void group(std::string_view, std::string_view) override {}

 protected:
  void numbers(const Field& field, std::span<double> list, bool) override { copy(field, list); }
  void integers(const Field& field, std::span<int> list, bool) override { copy(field, list); }
  void flag(const Field& field, bool& value) override { assign(field, value); }
  void text(const Field& field, std::string& value) override { assign(field, value); }
  void choice(const Field& field, int& index) override { assign(field, index); }

 private:
  template <class T>
  void assign(const Field& field, T& value) const {
    if (const T* known = m_values.find<T>(field.name)) value = *known;
  }
  template <class T>
  void copy(const Field& field, std::span<T> list) const {
    const auto* known = m_values.find<std::vector<T>>(field.name);
    if (known != nullptr && known->size() == list.size()) std::ranges::copy(*known, list.begin());
  }

  const NamedValues& m_values;
};

void NamedValues::take(const Describe& describe) {
  Reader reader;
  describe(reader);
  m_values = std::move(reader.values);
}

void NamedValues::give(const Describe& describe) const {
  Writer writer(*this);
  describe(writer);
}

std::vector<std::string> NamedValues::files() const {
  std::vector<std::string> names;
  for (const auto& [name, value] : m_values)
    if (const auto* text = std::get_if<std::string>(&value);
        text != nullptr && !text->empty() && name.starts_with("file"))
      names.push_back(*text);
  return names;
}

void NamedValues::changeFiles(const std::function<std::string(const std::string&)>& change) {
  for (auto& [name, value] : m_values)
    if (auto* text = std::get_if<std::string>(&value);
        text != nullptr && !text->empty() && name.starts_with("file"))
      *text = change(*text);
}

}  // namespace hogelscope
