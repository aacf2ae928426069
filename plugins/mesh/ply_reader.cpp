// SPDX-License-Identifier: BSD-3-Clause
// Stanford's PLY, text and binary: points with normals and colours, faces, triangle strips. Colours
// are interpreted as sRGB. Other elements and properties are skipped, with a note.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <string_view>

#include "errors.h"
#include "mesh_reader.h"

namespace hogelscope::mesh {

namespace {

enum class Type : std::uint8_t { i8, u8, i16, u16, i32, u32, f32, f64, unknown };

Type typeOf(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, Type>, 16> names{
      {{"char", Type::i8},
       {"uchar", Type::u8},
       {"short", Type::i16},
       {"ushort", Type::u16},
       {"int", Type::i32},
       {"uint", Type::u32},
       {"float", Type::f32},
       {"double", Type::f64},
       {"int8", Type::i8},
       {"uint8", Type::u8},
       {"int16", Type::i16},
       {"uint16", Type::u16},
       {"int32", Type::i32},
       {"uint32", Type::u32},
       {"float32", Type::f32},
       {"float64", Type::f64}}};
  for (const auto& [known, type] : names)
    if (known == name) return type;
  return Type::unknown;
}

/// The names of a point's properties, in the order of PlyReader::m_values.
constexpr std::array<std::string_view, 9> pointNames{"x",  "y",   "z",     "nx",  "ny",
                                                     "nz", "red", "green", "blue"};

constexpr std::array<std::size_t, 8> typeBytes{1, 1, 2, 2, 4, 4, 4, 8};

struct Property {
  std::string name;
  Type type = Type::unknown;
  Type countType = Type::unknown;  ///< of a list's length; unknown: not a list
};

struct Element {
  std::string name;
  double count = 0;
  std::vector<Property> properties;
};

class PlyReader {
 public:
  explicit PlyReader(Reading& reading)
      : m_file(reading.file()), m_reading(reading), m_bytes(reading.bytesOf(m_file)) {}

  Mesh read() {
    m_rest = m_bytes;
    readHeader();
    m_mesh.files.push_back(m_file);
    m_mesh.materials.emplace_back();
    for (const Element& element : m_elements) {
      // Each row has at least one byte per property.
      if (element.count * double(element.properties.size()) > double(m_rest.size())) endsEarly();
      if (element.name == "vertex") preparePoints(element);
      for (std::size_t row = 0; row < std::size_t(element.count); ++row) {
        if (row % 65536 == 0) m_reading.report(m_bytes.size() - m_rest.size(), m_bytes.size());
        readRow(element);
      }
    }
    m_mesh.materialOf.assign(m_mesh.triangles.size(), 0);
    addNotes();
    return std::move(m_mesh);
  }

 private:
  enum class Format : std::uint8_t { text, little, big };

  [[noreturn]] void damaged(const std::string& why) const {
    fail(m_file, "is no PLY that can be read", why);
  }
  [[noreturn]] void endsEarly() const {
    fail(m_file, "is damaged", "it ends before its last entry");
  }

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

  void readHeader() {
    if (nextLine() != "ply") damaged("its first line is not \"ply\"");
    for (std::string_view line = nextLine(); line != "end_header"; line = nextLine()) {
      const std::vector<std::string_view> words = wordsOf(line);
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "format" && words.size() > 1) {
        readFormat(words[1]);
      } else if (words[0] == "element" && words.size() == 3) {
        Element element{std::string(words[1]), 0, {}};
        const auto [end, error] =
            std::from_chars(words[2].data(), words[2].data() + words[2].size(), element.count);
        if (error != std::errc() || !(element.count >= 0 && element.count < 4e9))
          damaged("an element's count is no number");
        m_elements.push_back(element);
      } else if (words[0] == "property" && !m_elements.empty()) {
        readProperty(words);
      } else {
        damaged("its header has the line " + shortName(std::string(line)));
      }
    }
    for (std::size_t k = 0; k < m_elements.size(); ++k) {
      const Element& element = m_elements[k];
      if (element.properties.empty() && element.count > 0)
        damaged("element " + shortName(element.name) + " has no properties");
      for (std::size_t i = 0; i < k; ++i)
        if (m_elements[i].name == element.name)
          damaged("its header has two elements " + shortName(element.name));
    }
  }

  void readFormat(std::string_view name) {
    if (name == "ascii")
      m_format = Format::text;
    else if (name == "binary_little_endian")
      m_format = Format::little;
    else if (name == "binary_big_endian")
      m_format = Format::big;
    else
      damaged("its format is unknown");
  }

  void readProperty(const std::vector<std::string_view>& words) {
    const bool isList = words.size() == 5 && words[1] == "list";
    if (!isList && words.size() != 3) damaged("a property has no type and name");
    Property property;
    property.name = words.back();
    property.type = typeOf(words[isList ? 3 : 1]);
    if (isList) property.countType = typeOf(words[2]);
    if (property.type == Type::unknown || (isList && property.countType == Type::unknown))
      damaged("property " + shortName(property.name) + " has an unknown type");
    m_elements.back().properties.push_back(property);
  }

  double readValue(Type type) {
    if (m_format == Format::text) {
      m_rest.remove_prefix(std::min(m_rest.find_first_not_of(" \t\r\n"), m_rest.size()));
      if (m_rest.empty()) endsEarly();
      double value = 0;
      const char* last = m_rest.data() + m_rest.size();
      const auto [end, error] =
          std::from_chars(m_rest.data() + (m_rest[0] == '+' ? 1 : 0), last, value);
      if (error != std::errc()) damaged("it has a word where a number must be");
      m_rest.remove_prefix(std::size_t(end - m_rest.data()));
      return value;
    }
    std::array<char, 8> bytes{};
    const std::size_t size = typeBytes[std::size_t(type)];
    if (m_rest.size() < size) endsEarly();
    const std::string_view stored = m_rest.substr(0, size);
    m_rest.remove_prefix(size);
    const bool isSwapped =
        (m_format == Format::big) == (std::endian::native == std::endian::little);
    if (isSwapped)
      std::ranges::reverse_copy(stored, bytes.begin());
    else
      std::ranges::copy(stored, bytes.begin());
    return valueOf(type, bytes.data());
  }

  static double valueOf(Type type, const char* bytes) {
    const auto as = [&]<class T>(T value) {
      std::memcpy(&value, bytes, sizeof value);
      return double(value);
    };
    switch (type) {
      case Type::i8:
        return as(std::int8_t{});
      case Type::u8:
        return as(std::uint8_t{});
      case Type::i16:
        return as(std::int16_t{});
      case Type::u16:
        return as(std::uint16_t{});
      case Type::i32:
        return as(std::int32_t{});
      case Type::u32:
        return as(std::uint32_t{});
      case Type::f32:
        return as(float{});
      default:
        return as(double{});
    }
  }

  void preparePoints(const Element& element) {
    const auto has = [&](std::string_view name) {
      return std::any_of(element.properties.begin(), element.properties.end(),
                         [&](const Property& p) { return p.name == name; });
    };
    if (!has("x") || !has("y") || !has("z")) damaged("its points have no x, y, z");
    m_hasNormals = has("nx") && has("ny") && has("nz");
    m_hasColours = has("red") && has("green") && has("blue");
    m_reading.take(element.count * (sceneBytesOfPoint + sizeof(Vec3) +
                                    (m_hasNormals ? sizeof(m_mesh.normals[0]) : 0) +
                                    (m_hasColours ? sizeof(Linear) : 0)));
    m_mesh.points.reserve(std::size_t(element.count));
    if (m_hasNormals) m_mesh.normals.reserve(std::size_t(element.count));
    if (m_hasColours) m_mesh.colours.reserve(std::size_t(element.count));
  }

  void readRow(const Element& element) {
    const bool isPoint = element.name == "vertex";
    m_values.fill(0);
    for (const Property& property : element.properties) {
      if (property.countType != Type::unknown)
        readList(property, shapeOf(element, property));
      else
        keepValue(property, readValue(property.type));
    }
    if (isPoint) appendPoint();
  }

  void keepValue(const Property& property, double value) {
    const auto found = std::ranges::find(pointNames, property.name);
    if (found == pointNames.end()) return;
    const auto at = std::size_t(found - pointNames.begin());
    // Colours are 0 … 255, 0 … 65535, or real numbers 0 … 1.
    const double white = property.type == Type::u8 ? 255 : property.type == Type::u16 ? 65535 : 1;
    m_values[at] = at >= 6 ? linearOf(std::clamp(value / white, 0.0, 1.0)) : value;
  }

  void appendPoint() {
    const auto& v = m_values;
    m_mesh.points.push_back({v[0], v[1], v[2]});
    if (m_hasNormals) {
      const Vec3 n = normalise({v[3], v[4], v[5]});
      m_mesh.normals.push_back({float(n.x), float(n.y), float(n.z)});
    }
    if (m_hasColours) m_mesh.colours.push_back({float(v[6]), float(v[7]), float(v[8])});
  }

  enum class Shape : std::uint8_t { none, polygon, strips };

  static Shape shapeOf(const Element& element, const Property& property) {
    if (!property.name.starts_with("vertex_ind")) return Shape::none;
    if (element.name == "tristrips") return Shape::strips;
    return element.name == "face" ? Shape::polygon : Shape::none;
  }

  /// Converts a polygon to a fan of triangles. In a list of strips, -1 ends a strip.
  void readList(const Property& property, Shape shape) {
    const double count = readValue(property.countType);
    if (!(count >= 0 && count <= double(m_rest.size()))) endsEarly();
    Corners corners{};
    std::size_t known = 0;  // corners of the next triangle so far
    for (std::size_t k = 0; k < std::size_t(count); ++k) {
      if (k % 65536 == 65535) m_reading.poll();
      const double index = readValue(property.type);
      if (shape == Shape::none) continue;
      if (shape == Shape::strips && index == -1) {
        known = 0;
        continue;
      }
      if (!(index >= 0 && index < 4294967295.0)) damaged("a face names a point that is not there");
      corners[known] = std::uint32_t(index);
      if (known < 2) {
        ++known;
        continue;
      }
      addTriangle(corners);
      if (shape == Shape::strips) corners[0] = corners[1];
      corners[1] = corners[2];
    }
  }

  void addTriangle(const Corners& corners) {
    if (m_mesh.triangles.size() >= mostTriangles)
      fail(m_file, "the file", "has more than 33554432 triangles");
    m_reading.take(2 * sizeof(Corners) + sizeof(std::uint32_t) + sceneBytesOfTriangle);
    m_mesh.triangles.push_back(corners);
  }

  void addNotes() {
    std::vector<std::string> elements;
    std::vector<std::string> properties;
    for (const Element& element : m_elements) {
      const bool isPoint = element.name == "vertex";
      const bool isShown = isPoint || element.name == "face" || element.name == "tristrips";
      if (!isShown && element.count > 0) elements.push_back(element.name);
      for (const Property& property : element.properties)
        if (isPoint && std::ranges::find(pointNames, property.name) == pointNames.end())
          properties.push_back(property.name);
    }
    if (!elements.empty()) m_mesh.notes.push_back(leftOut("elements", elements));
    if (!properties.empty()) m_mesh.notes.push_back(leftOut("points' properties", properties));
  }

  std::string m_file;
  Reading& m_reading;
  std::string m_bytes;
  std::string_view m_rest;  ///< the unread rest
  Mesh m_mesh;
  std::vector<Element> m_elements;
  std::array<double, 9> m_values{};  ///< of a single point
  Format m_format = Format::text;
  bool m_hasNormals = false;
  bool m_hasColours = false;
};

}  // namespace

Mesh readPly(Reading& reading) {
  return PlyReader(reading).read();
}

}  // namespace hogelscope::mesh
