// SPDX-License-Identifier: BSD-3-Clause
// Descriptions of whole documents: `describeParts` of a struct visits its fields, the objects and
// lists in it, and the names of its files, in the order of documents. Reading, writing, names of
// edits, --set and the manual are such visitors; what one object's fields are, `describe` says
// (core/base/parameters.h).
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/plugin_params.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

class SectionVisitor {
 public:
  using Visit = std::function<void()>;
  using ReadValue = std::function<void(const Json& value, const std::string& path)>;
  using WriteValue = std::function<Json()>;

  virtual ~SectionVisitor() = default;

  /// Visits the object's own fields.
  template <class Params>
  void fields(Params& params) {
    if (ParameterVisitor* const visitor = fieldVisitor(); visitor != nullptr)
      describe(*visitor, params);
  }
  /// Visits an object in it, which documents have if `isWritten`.
  void section(std::string_view name, bool isWritten, const Visit& visit) {
    if (!begin(name, isWritten)) return;
    visit();
    end();
  }
  template <class T>
  void section(std::string_view name, T& value, bool isWritten = true) {
    section(name, isWritten, [&] { parts(value); });
  }
  /// Visits an object that documents leave out where it has its defaults.
  template <class T>
  void optional(std::string_view name, T& value) {
    section(name, value, value != T{});
  }
  /// Visits a list of objects; `what`, such as "camera states", names them in messages.
  template <class T>
  void list(std::string_view name, std::vector<T>& values, std::string_view what) {
    items(
        name, what, values.size(), [&](std::size_t count) { values.resize(count); },
        [&](std::size_t index) { parts(values[index]); });
  }
  /// Visits an object in whose place documents may have the name of a file that holds it. Returns
  /// whether the document has it.
  virtual bool document(std::string_view name, std::string& file, bool isWritten,
                        const Visit& visit) {
    section(name, isWritten || !file.empty(), visit);
    return isWritten;
  }
  /// Visits a value with a form of its own. Returns false if a document that is read lacks it.
  virtual bool value(std::string_view /*name*/, bool /*isWritten*/, const ReadValue& /*read*/,
                     const WriteValue& /*write*/) {
    return true;
  }
  /// Visits the name of a file, "" where there is none; it is one of the fields too.
  virtual void file(std::string& /*name*/) {}
  virtual void files(NamedValues& /*values*/) {}
  /// Documents leave out a field that another one replaces.
  virtual void leaveOut(std::string_view /*field*/) {}
  /// Refuses a name in a document that is read.
  virtual void refuse(std::string_view /*name*/, std::string_view /*why*/) {}
  /// Checks an object once it has been read: an InputError of `check` gets its path.
  virtual void verify(const Visit& /*check*/) {}

  /// Visits all of a value: by describeParts() if it has one, otherwise its fields.
  template <class T>
  void parts(T& value) {
    if constexpr (requires(SectionVisitor & v) { describeParts(v, value); })
      describeParts(*this, value);
    else
      fields(value);
  }

 protected:
  /// Returns the visitor of the fields of the object that is visited; null: they are passed over.
  virtual ParameterVisitor* fieldVisitor() = 0;
  /// Enters an object of the one that is visited; returns false to pass it over.
  virtual bool begin(std::string_view name, bool isWritten) = 0;
  virtual void end() = 0;
  /// Visits `count` objects of a list, or as many as a document has, after `resize`.
  virtual void items(std::string_view name, std::string_view what, std::size_t count,
                     const std::function<void(std::size_t count)>& resize,
                     const std::function<void(std::size_t index)>& visit);
};

/// Reads what a document's object has; all else keeps its value.
class SectionReader : public SectionVisitor {
 public:
  /// Returns the object that a document names as a file: `path` is where, such as "twin".
  using Load = std::function<Json(const std::string& path, const std::string& file)>;

  SectionReader(const Json& object, const std::string& path, Load load = {});
  /// Throws InputError for a key that was not read. Call it last.
  void finish() { end(); }

  bool document(std::string_view name, std::string& file, bool isWritten,
                const Visit& visit) override;
  bool value(std::string_view name, bool isWritten, const ReadValue& read,
             const WriteValue& write) override;
  void refuse(std::string_view name, std::string_view why) override;
  void verify(const Visit& check) override;

 protected:
  ParameterVisitor* fieldVisitor() override { return &m_open.back(); }
  bool begin(std::string_view name, bool isWritten) override;
  void end() override;
  void items(std::string_view name, std::string_view what, std::size_t count,
             const std::function<void(std::size_t count)>& resize,
             const std::function<void(std::size_t index)>& visit) override;

 private:
  Load m_load;
  std::deque<Json> m_loaded;
  std::deque<JsonReader> m_open;  ///< the object that is visited, and those around it
  std::vector<std::pair<std::size_t, Visit>> m_checks;  ///< of them, by their number
};

/// Reads an object of a document; `path` is its place. Throws InputError.
template <class T>
void readParts(const Json& object, const std::string& path, T& value,
               SectionReader::Load load = {}) {
  SectionReader reader(object, path, std::move(load));
  reader.parts(value);
  reader.finish();
}

class SectionWriter : public SectionVisitor {
 public:
  SectionWriter() : m_open(1, Json::object()) {}
  [[nodiscard]] Json take() { return std::move(m_open.front()); }

  bool document(std::string_view name, std::string& file, bool isWritten,
                const Visit& visit) override;
  bool value(std::string_view name, bool isWritten, const ReadValue& read,
             const WriteValue& write) override;
  void leaveOut(std::string_view field) override;

 protected:
  ParameterVisitor* fieldVisitor() override { return &m_fields.emplace(m_open.back()); }
  bool begin(std::string_view name, bool isWritten) override;
  void end() override;
  void items(std::string_view name, std::string_view what, std::size_t count,
             const std::function<void(std::size_t count)>& resize,
             const std::function<void(std::size_t index)>& visit) override;

 private:
  std::deque<Json> m_open;
  std::vector<std::string> m_names;  ///< of those in it, as m_open
  std::optional<JsonWriter> m_fields;
};

/// Returns the object of a value in documents.
template <class T>
Json writtenParts(T value) {
  SectionWriter writer;
  writer.parts(value);
  return writer.take();
}

/// Applies `change` to the name of each file that a value gives.
class FileVisitor : public SectionVisitor {
 public:
  using Change = std::function<std::string(const std::string& file)>;
  explicit FileVisitor(Change change) : m_change(std::move(change)) {}

  bool document(std::string_view name, std::string& file, bool isWritten,
                const Visit& visit) override;
  void file(std::string& name) override;
  void files(NamedValues& values) override { values.changeFiles(m_change); }

 protected:
  ParameterVisitor* fieldVisitor() override { return nullptr; }
  bool begin(std::string_view /*name*/, bool /*isWritten*/) override { return true; }
  void end() override {}

 private:
  Change m_change;
};

}  // namespace hogelscope
