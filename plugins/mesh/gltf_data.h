// SPDX-License-Identifier: BSD-3-Clause
// A glTF file taken apart: its JSON, its buffers, its lists of numbers. Everything is checked
// against the sizes of what is there.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace hogelscope::mesh {

using Json = nlohmann::json;

/// Rows of `components` numbers each.
struct Numbers {
  std::vector<float> values;
  std::size_t components = 0;

  [[nodiscard]] std::size_t rows() const { return values.size() / components; }
};

class GltfData {
 public:
  /// Reads the file and all that it names but pictures; refuses required extensions by name.
  explicit GltfData(const std::string& file);

  [[nodiscard]] const Json& root() const { return m_root; }
  [[nodiscard]] const std::string& file() const { return m_file; }
  /// All files that were read.
  [[nodiscard]] std::vector<std::string>& files() { return m_files; }

  /// Returns entry `index` of a list at the root, or throws.
  [[nodiscard]] const Json& entry(const char* list, std::size_t index) const;
  /// Returns an index that a member holds, or `none`.
  [[nodiscard]] std::size_t index(const Json& object, const char* member) const;
  static constexpr std::size_t none = std::size_t(-1);
  /// Returns a member's number, or what stands for it. Throws if it is not finite.
  [[nodiscard]] double number(const Json& object, const char* member, double otherwise) const;
  /// Returns a member's list of `count` numbers, or an empty one if there is no such member.
  [[nodiscard]] std::vector<double> list(const Json& object, const char* member,
                                         std::size_t count) const;

  /// Returns the numbers of an accessor; normalised integers become 0 … 1 or −1 … 1.
  [[nodiscard]] Numbers numbers(std::size_t accessor) const;
  /// Returns the whole numbers of an accessor.
  [[nodiscard]] std::vector<std::uint32_t> indices(std::size_t accessor) const;
  [[nodiscard]] std::string_view bufferView(std::size_t index) const;
  /// Returns what a URI means: data in it, or the file beside this one.
  [[nodiscard]] std::string resource(const std::string& uri, const std::string& what);

  [[noreturn]] void fail(const std::string& what, const std::string& why) const;

 private:
  struct Layout;  // of an accessor

  std::string_view readContainer();
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

  std::string m_file;
  std::string m_bytes;
  Json m_root;
  std::vector<std::string> m_files;
  std::vector<std::string> m_buffers;
};

}  // namespace hogelscope::mesh
