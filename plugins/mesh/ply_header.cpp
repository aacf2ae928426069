// SPDX-License-Identifier: BSD-3-Clause
#include "ply_header.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "errors.h"

namespace hogelscope::mesh {

namespace {

PlyType typeOf(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, PlyType>, 16> names{
      {{"char", PlyType::i8},
       {"uchar", PlyType::u8},
       {"short", PlyType::i16},
       {"ushort", PlyType::u16},
       {"int", PlyType::i32},
       {"uint", PlyType::u32},
       {"float", PlyType::f32},
       {"double", PlyType::f64},
       {"int8", PlyType::i8},
       {"uint8", PlyType::u8},
       {"int16", PlyType::i16},
       {"uint16", PlyType::u16},
       {"int32", PlyType::i32},
       {"uint32", PlyType::u32},
       {"float32", PlyType::f32},
       {"float64", PlyType::f64}}};
  for (const auto& [known, type] : names)
    if (known == name) return type;
  return PlyType::unknown;
}

class HeaderReader {
 public:
  HeaderReader(std::string file, std::string_view& rest) : m_file(std::move(file)), m_rest(rest) {}

  PlyHeader read() {
    if (nextLine() != "ply") damaged("its first line is not \"ply\"");
    for (std::string_view line = nextLine(); line != "end_header"; line = nextLine()) {
      const std::vector<std::string_view> words = wordsOf(line);
      if (words.size() > 2 && words[0] == "comment" && words[1] == "TextureFile")
        m_header.pictures.emplace_back(words[2].data(), words.back().data() + words.back().size());
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "format" && words.size() > 1) {
        readFormat(words[1]);
      } else if (words[0] == "element" && words.size() == 3) {
        PlyElement element{std::string(words[1]), 0, {}};
        const auto [end, error] =
            std::from_chars(words[2].data(), words[2].data() + words[2].size(), element.count);
        if (error != std::errc() || !(element.count >= 0 && element.count < 4e9))
          damaged("an element's count is no number");
        m_header.elements.push_back(element);
      } else if (words[0] == "property" && !m_header.elements.empty()) {
        readProperty(words);
      } else {
        damaged("its header has the line " + shortName(std::string(line)));
      }
    }
    for (std::size_t k = 0; k < m_header.elements.size(); ++k) {
      const PlyElement& element = m_header.elements[k];
      if (element.properties.empty() && element.count > 0)
        damaged("element " + shortName(element.name) + " has no properties");
      for (std::size_t i = 0; i < k; ++i)
        if (m_header.elements[i].name == element.name)
          damaged("its header has two elements " + shortName(element.name));
    }
    return std::move(m_header);
  }

 private:
  [[noreturn]] void damaged(const std::string& why) const { refusePly(m_file, why); }

  std::string_view nextLine() {
    const std::size_t end = m_rest.find('\n');
    if (end == std::string_view::npos) damaged("its header has no end_header");
    std::string_view line = m_rest.substr(0, end);
    m_rest.remove_prefix(end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  static std::vector<std::string_view> wordsOf(std::string_view line) {
    std::vector<std::string_view> words;
    while (true) {
      line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
      if (line.empty()) return words;
      words.push_back(line.substr(0, line.find_first_of(" \t")));
      line.remove_prefix(words.back().size());
    }
  }

  void readFormat(std::string_view name) {
    if (name == "ascii")
      m_header.format = PlyFormat::text;
    else if (name == "binary_little_endian")
      m_header.format = PlyFormat::little;
    else if (name == "binary_big_endian")
      m_header.format = PlyFormat::big;
    else
      damaged("its format is unknown");
  }

  void readProperty(const std::vector<std::string_view>& words) {
    const bool isList = words.size() == 5 && words[1] == "list";
    if (!isList && words.size() != 3) damaged("a property has no type and name");
    PlyProperty property;
    property.name = words.back();
    property.type = typeOf(words[isList ? 3 : 1]);
    if (isList) property.countType = typeOf(words[2]);
    if (property.type == PlyType::unknown || (isList && property.countType == PlyType::unknown))
      damaged("property " + shortName(property.name) + " has an unknown type");
    m_header.elements.back().properties.push_back(property);
  }

  std::string m_file;
  std::string_view& m_rest;
  PlyHeader m_header;
};

}  // namespace

const PlyElement* PlyHeader::find(std::string_view name) const {
  const auto found = std::ranges::find(elements, name, &PlyElement::name);
  return found == elements.end() ? nullptr : &*found;
}

void refusePly(const std::string& file, const std::string& why) {
  fail(file, "is no PLY that can be read", why);
}

PlyHeader readPlyHeader(const std::string& file, std::string_view& rest) {
  return HeaderReader(file, rest).read();
}

}  // namespace hogelscope::mesh
