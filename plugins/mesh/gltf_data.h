// SPDX-License-Identifier: BSD-3-Clause
// A parsed glTF file: its JSON, its buffers, its accessors. Everything is checked against the
// existing sizes.
#pragma once

#include <array>
#include <deque>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "reading.h"

namespace hogelscope::mesh {

using Json = nlohmann::json;

/// Returns the name of a list's entry, for messages.
inline std::string named(const char* list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

/// Rows of `components` numbers each.
struct Numbers {
  std::vector<float> values;
  std::size_t components = 0;

  [[nodiscard]] std::size_t rows() const { return values.size() / components; }
};

/// The supported extensions.
constexpr std::array<std::string_view, 5> knownExtensions{
    "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_unlit",
    "KHR_mesh_quantization", "KHR_texture_transform"};

class GltfData {
 public:
  /// Reads the file and all files that it names except images; throws for unsupported required
  /// extensions.
  explicit GltfData(Reading& reading);

  [[nodiscard]] const Json& root() const { return m_root; }
  [[nodiscard]] const std::string& file() const { return m_reading.file(); }
  [[nodiscard]] Reading& reading() const { return m_reading; }
  /// Returns all files that were read.
  [[nodiscard]] std::vector<std::string>& files() { return m_files; }

  /// Returns the object of a member; an empty one if there is none.
  [[nodiscard]] static const Json& part(const Json& object, const char* member);
  /// Returns a list at the root; an empty one if there is none.
  [[nodiscard]] const Json& listAt(const char* member) const;
  /// Returns entry `index` of a list at the root, or throws.
  [[nodiscard]] const Json& entry(const char* list, std::size_t index) const;
  /// Returns the index in a member, or `none`.
  [[nodiscard]] std::size_t index(const Json& object, const char* member) const;
  static constexpr std::size_t none = std::size_t(-1);
  /// Returns a member's number, or `otherwise`. Throws if it is not finite.
  [[nodiscard]] double number(const Json& object, const char* member, double otherwise) const;
  /// Returns a member's list of `count` numbers, or an empty one if there is no such member.
  [[nodiscard]] std::vector<double> list(const Json& object, const char* member,
                                         std::size_t count) const;

  /// Returns how many rows an accessor has.
  [[nodiscard]] std::size_t rows(std::size_t accessor) const;
  /// Returns the memory of its numbers while they are read.
  [[nodiscard]] double bytes(std::size_t accessor) const;
  /// Returns the numbers of an accessor; normalised integers become 0 … 1 or −1 … 1.
  [[nodiscard]] Numbers numbers(std::size_t accessor) const;
  /// Returns the integers of an accessor with so many in a row.
  [[nodiscard]] std::vector<std::uint32_t> indices(std::size_t accessor,
                                                   std::size_t components = 1) const;
  [[nodiscard]] std::string_view bufferView(std::size_t index) const;
  /// Returns the path of the existing file beside this one that a URI refers to.
  [[nodiscard]] std::string fileOf(const std::string& uri, const std::string& what) const;
  /// Returns the bytes in a data URI and counts their memory.
  [[nodiscard]] std::string dataOf(const std::string& uri, const std::string& what) const;
  [[nodiscard]] static bool isData(const std::string& uri) { return uri.starts_with("data:"); }

  [[noreturn]] void fail(const std::string& what, const std::string& why) const;

 private:
  struct Layout;  // of an accessor

  std::string_view readContainer();
  void parse(std::string_view json);
  std::string_view readBuffer(const std::string& uri, const std::string& name);
  void checkExtensions() const;
  void readBuffers(std::string_view binary);
  [[nodiscard]] Layout layout(std::size_t accessor) const;
  template <class T>
  std::vector<T> elements(std::size_t accessor, const Layout& layout) const;
  template <class T>
  void replaceSparse(std::vector<T>& values, const Json& sparse, const Layout& layout) const;
  template <class T>
  void copyRows(std::vector<T>& values, std::string_view bytes, std::size_t stride,
                const Layout& layout) const;

  Reading& m_reading;
  std::string m_bytes;
  Json m_root;
  std::vector<std::string> m_files;
  std::map<std::string, std::string> m_contents;  ///< of the buffers' files, by sameName()
  std::deque<std::string> m_data;                 ///< of the buffers in the JSON
  std::vector<std::string_view> m_buffers;
};

}  // namespace hogelscope::mesh
