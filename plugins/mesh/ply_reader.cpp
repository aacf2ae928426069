// SPDX-License-Identifier: BSD-3-Clause
// Stanford's PLY, text and binary: points with normals, colours and texture coordinates, faces with
// colours or with texture coordinates of their corners, triangle strips. Colours are interpreted as
// sRGB; the pictures are named by comments "TextureFile NAME", as VCGLIB writes them. Other
// elements and properties are skipped, with a note.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <fstream>
#include <optional>
#include <string_view>
#include <utility>

#include "errors.h"
#include "found_files.h"
#include "mesh_reader.h"
#include "ply_header.h"
#include "textures.h"

namespace hogelscope::mesh {

namespace {

/// The names of a row's properties, with their places in PlyReader::m_values. A face has colours
/// and the number of its picture.
constexpr std::array<std::pair<std::string_view, std::size_t>, 18> valueNames{{{"x", 0},
                                                                               {"y", 1},
                                                                               {"z", 2},
                                                                               {"nx", 3},
                                                                               {"ny", 4},
                                                                               {"nz", 5},
                                                                               {"red", 6},
                                                                               {"green", 7},
                                                                               {"blue", 8},
                                                                               {"s", 9},
                                                                               {"t", 10},
                                                                               {"u", 9},
                                                                               {"v", 10},
                                                                               {"texture_u", 9},
                                                                               {"texture_v", 10},
                                                                               {"texture_s", 9},
                                                                               {"texture_t", 10},
                                                                               {"texnumber", 11}}};
constexpr std::size_t firstColour = 6;
constexpr std::size_t firstCoordinate = 9;
constexpr std::size_t pictureNumber = 11;

std::optional<std::size_t> placeOf(std::string_view name) {
  const auto found = std::ranges::find(valueNames, name, &decltype(valueNames)::value_type::first);
  return found == valueNames.end() ? std::nullopt : std::optional(found->second);
}

class PlyReader {
 public:
  explicit PlyReader(Reading& reading)
      : m_file(reading.file()),
        m_reading(reading),
        m_bytes(reading.bytesOf(m_file)),
        m_textures(reading) {}

  Mesh read() {
    m_rest = m_bytes;
    m_header = readPlyHeader(m_file, m_rest);
    m_mesh.files.push_back(m_file);
    m_mesh.materials.emplace_back();
    addPictures();
    for (const PlyElement& element : m_header.elements) {
      // Each row has at least one byte per property.
      if (element.count * double(element.properties.size()) > double(m_rest.size())) endsEarly();
      if (element.name == "vertex") preparePoints(element);
      for (std::size_t row = 0; row < std::size_t(element.count); ++row) {
        if (row % 65536 == 0) m_reading.report(m_bytes.size() - m_rest.size(), m_bytes.size());
        readRow(element);
      }
    }
    const bool isOnePicture =
        !m_mesh.uv.empty() && m_corners.empty() && m_mesh.materials.size() > 1;
    m_mesh.materialOf.resize(m_mesh.triangles.size(), isOnePicture ? 1 : 0);
    splitCorners();
    m_mesh.textures = m_textures.decode();
    m_mesh.files.insert(m_mesh.files.end(), m_textures.files().begin(), m_textures.files().end());
    addNotes();
    return std::move(m_mesh);
  }

 private:
  [[noreturn]] void damaged(const std::string& why) const { refusePly(m_file, why); }
  [[noreturn]] void endsEarly() const {
    fail(m_file, "is damaged", "it ends before its last entry");
  }

  double readValue(PlyType type) {
    if (m_header.format == PlyFormat::text) {
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
    const std::size_t size = plyTypeBytes[std::size_t(type)];
    if (m_rest.size() < size) endsEarly();
    const std::string_view stored = m_rest.substr(0, size);
    m_rest.remove_prefix(size);
    const bool isSwapped =
        (m_header.format == PlyFormat::big) == (std::endian::native == std::endian::little);
    if (isSwapped)
      std::ranges::reverse_copy(stored, bytes.begin());
    else
      std::ranges::copy(stored, bytes.begin());
    return valueOf(type, bytes.data());
  }

  static double valueOf(PlyType type, const char* bytes) {
    const auto as = [&]<class T>(T value) {
      std::memcpy(&value, bytes, sizeof value);
      return double(value);
    };
    switch (type) {
      case PlyType::i8:
        return as(std::int8_t{});
      case PlyType::u8:
        return as(std::uint8_t{});
      case PlyType::i16:
        return as(std::int16_t{});
      case PlyType::u16:
        return as(std::uint16_t{});
      case PlyType::i32:
        return as(std::int32_t{});
      case PlyType::u32:
        return as(std::uint32_t{});
      case PlyType::f32:
        return as(float{});
      default:
        return as(double{});
    }
  }

  /// Whether an element has single values for these places in m_values.
  static bool has(const PlyElement& element, std::size_t first, std::size_t count) {
    for (std::size_t place = first; place < first + count; ++place)
      if (std::ranges::none_of(element.properties, [&](const PlyProperty& p) {
            return !p.isList() && placeOf(p.name) == place;
          }))
        return false;
    return true;
  }

  /// Gives each picture that can be shown a material; says what of the header decides on colours.
  void addPictures() {
    const PlyElement* const points = m_header.find("vertex");
    const PlyElement* const faces = m_header.find("face");
    m_hasCornerPlaces = faces != nullptr && std::ranges::any_of(faces->properties, isCornerPlaces);
    m_hasPlaces = !m_hasCornerPlaces && points != nullptr && has(*points, firstCoordinate, 2);
    m_hasFaceColours = faces != nullptr && has(*faces, firstColour, 3) &&
                       !(points != nullptr && has(*points, firstColour, 3));
    for (const std::string& name : m_header.pictures) {
      const auto [path, isThere, isElsewhere] = foundBesides(m_file, name);
      std::string why;
      if (!m_hasCornerPlaces && !m_hasPlaces)
        why = "no texture coordinates are there";
      else if (!isThere)
        why = "there is no file " + shortName(path);
      else if (!isPngOrJpeg(path))
        why = "it is neither PNG nor JPEG";
      if (why.empty() && isElsewhere)
        m_mesh.notes.push_back("Its file " + shortName(name) + " is read as " + shortName(path) +
                               ".");
      if (!why.empty())
        m_mesh.notes.push_back("Its picture " + shortName(name) + " is not shown: " + why + ".");
      m_mesh.materials.emplace_back();
      if (why.empty()) m_mesh.materials.back().layer.texture = m_textures.add(path);
    }
    if (m_header.pictures.empty()) m_hasCornerPlaces = m_hasPlaces = false;
  }

  static bool isPngOrJpeg(const std::string& path) {
    std::array<char, 3> begin{};
    std::ifstream(path, std::ios::binary).read(begin.data(), begin.size());
    const std::string_view text(begin.data(), begin.size());
    return text == "\x89PN" || text == "\xff\xd8\xff";
  }

  void preparePoints(const PlyElement& element) {
    if (!has(element, 0, 3)) damaged("its points have no x, y, z");
    m_hasNormals = has(element, 3, 3);
    m_hasColours = has(element, firstColour, 3);
    m_reading.take(
        element.count *
        (sceneBytesOfPoint + sizeof(Vec3) + (m_hasNormals ? sizeof(m_mesh.normals[0]) : 0) +
         (m_hasColours ? sizeof(Linear) : 0) + (m_hasPlaces ? sizeof(m_mesh.uv[0]) : 0)));
    m_mesh.points.reserve(std::size_t(element.count));
    if (m_hasNormals) m_mesh.normals.reserve(std::size_t(element.count));
    if (m_hasColours) m_mesh.colours.reserve(std::size_t(element.count));
    if (m_hasPlaces) m_mesh.uv.reserve(std::size_t(element.count));
  }

  void readRow(const PlyElement& element) {
    const bool isPoint = element.name == "vertex";
    m_values.fill(0);
    m_polygon.clear();
    m_polygonPlaces.clear();
    for (const PlyProperty& property : element.properties) {
      if (property.isList())
        readList(property, shapeOf(element, property));
      else
        keepValue(property, readValue(property.type));
    }
    if (isPoint) appendPoint();
    if (!m_polygon.empty()) addPolygon();
  }

  void keepValue(const PlyProperty& property, double value) {
    const std::optional<std::size_t> at = placeOf(property.name);
    if (!at) return;
    // Colours are 0 … 255, 0 … 65535, or real numbers 0 … 1.
    const double white = property.type == PlyType::u8    ? 255
                         : property.type == PlyType::u16 ? 65535
                                                         : 1;
    const bool isColour = *at >= firstColour && *at < firstCoordinate;
    m_values[*at] = isColour ? linearOf(std::clamp(value / white, 0.0, 1.0)) : value;
  }

  void appendPoint() {
    const auto& v = m_values;
    m_mesh.points.push_back({v[0], v[1], v[2]});
    if (m_hasNormals) {
      const Vec3 n = normalise({v[3], v[4], v[5]});
      m_mesh.normals.push_back({float(n.x), float(n.y), float(n.z)});
    }
    if (m_hasColours) m_mesh.colours.push_back({float(v[6]), float(v[7]), float(v[8])});
    if (m_hasPlaces) m_mesh.uv.push_back({float(v[9]), float(1 - v[10])});  // v points up there
  }

  enum class Shape : std::uint8_t { none, polygon, strips, places };

  static bool isCornerPlaces(const PlyProperty& property) {
    return property.isList() && property.name == "texcoord";
  }

  [[nodiscard]] Shape shapeOf(const PlyElement& element, const PlyProperty& property) const {
    if (element.name == "face" && m_hasCornerPlaces && isCornerPlaces(property))
      return Shape::places;
    if (!property.name.starts_with("vertex_ind")) return Shape::none;
    if (element.name == "tristrips") return Shape::strips;
    return element.name == "face" ? Shape::polygon : Shape::none;
  }

  /// Keeps the points of a polygon, or the texture coordinates of its corners; converts strips to
  /// triangles, of which -1 ends one.
  void readList(const PlyProperty& property, Shape shape) {
    const double count = readValue(property.countType);
    if (!(count >= 0 && count <= double(m_rest.size()))) endsEarly();
    Corners corners{};
    std::size_t known = 0;  // corners of the next triangle so far
    for (std::size_t k = 0; k < std::size_t(count); ++k) {
      if (k % 65536 == 65535) m_reading.poll();
      const double index = readValue(property.type);
      if (shape == Shape::none) continue;
      if (shape == Shape::places) {
        m_polygonPlaces.push_back(float(index));
        continue;
      }
      if (shape == Shape::strips && index == -1) {
        known = 0;
        continue;
      }
      if (!(index >= 0 && index < 4294967295.0)) damaged("a face names a point that is not there");
      if (shape == Shape::polygon) {
        m_polygon.push_back(std::uint32_t(index));
        continue;
      }
      corners[known] = std::uint32_t(index);
      if (known < 2) {
        ++known;
        continue;
      }
      addTriangle(corners);
      corners[0] = corners[1];
      corners[1] = corners[2];
    }
  }

  /// Converts a polygon to a fan of triangles.
  void addPolygon() {
    const bool hasPlaces =
        !m_polygonPlaces.empty() && m_polygonPlaces.size() >= 2 * m_polygon.size();
    const double picture = m_values[pictureNumber];
    const bool isShown = hasPlaces && picture >= 0 && picture < double(m_header.pictures.size());
    const auto placeAt = [&](std::size_t k) {
      if (!hasPlaces) return std::array<float, 2>{};
      return std::array{m_polygonPlaces[2 * k], 1 - m_polygonPlaces[2 * k + 1]};
    };
    for (std::size_t k = 2; k < m_polygon.size(); ++k) {
      addTriangle({m_polygon[0], m_polygon[k - 1], m_polygon[k]});
      if (!m_hasCornerPlaces && !m_hasFaceColours) continue;
      m_reading.take(sizeof(CornerValues) + sizeof(std::uint32_t));
      m_mesh.materialOf.resize(m_mesh.triangles.size() - 1, 0);
      m_mesh.materialOf.push_back(isShown ? std::uint32_t(picture) + 1 : 0);
      m_corners.resize(m_mesh.triangles.size() - 1);
      m_corners.push_back({{placeAt(0), placeAt(k - 1), placeAt(k)},
                           {float(m_values[6]), float(m_values[7]), float(m_values[8])}});
    }
  }

  /// Gives each corner a point of its own where faces have colours or coordinates.
  void splitCorners() {
    if (m_corners.empty()) return;
    m_corners.resize(m_mesh.triangles.size());
    for (const Corners& corners : m_mesh.triangles)
      if (std::ranges::max(corners) >= m_mesh.points.size()) return;  // refused by readMesh()
    const std::size_t count = 3 * m_mesh.triangles.size();
    m_reading.take(double(count) * (sceneBytesOfPoint + sizeof(Vec3) + sizeof(Linear) +
                                    sizeof(m_mesh.normals[0]) + sizeof(m_mesh.uv[0])));
    Mesh split;
    split.points.reserve(count);
    for (std::size_t t = 0; t < m_mesh.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t point = std::exchange(m_mesh.triangles[t][k], std::uint32_t(3 * t + k));
        split.points.push_back(m_mesh.points[point]);
        if (m_hasNormals) split.normals.push_back(m_mesh.normals[point]);
        if (m_hasColours) split.colours.push_back(m_mesh.colours[point]);
        if (m_hasFaceColours) split.colours.push_back(m_corners[t].colour);
        if (m_hasCornerPlaces) split.uv.push_back(m_corners[t].places[k]);
      }
    m_mesh.points = std::move(split.points);
    m_mesh.normals = std::move(split.normals);
    m_mesh.colours = std::move(split.colours);
    m_mesh.uv = std::move(split.uv);
  }

  void addTriangle(const Corners& corners) {
    if (m_mesh.triangles.size() >= mostTriangles)
      fail(m_file, "the file", "has more than 33554432 triangles");
    m_reading.take(2 * sizeof(Corners) + sizeof(std::uint32_t) + sceneBytesOfTriangle);
    m_mesh.triangles.push_back(corners);
  }

  void addNotes() {
    std::vector<std::string> elements;
    std::vector<std::string> ofPoints;
    std::vector<std::string> ofFaces;
    for (const PlyElement& element : m_header.elements) {
      const bool isPoint = element.name == "vertex";
      const bool isFace = element.name == "face";
      if (!isPoint && !isFace && element.name != "tristrips" && element.count > 0)
        elements.push_back(element.name);
      for (const PlyProperty& property : element.properties) {
        if (isPoint && !isShownOfPoint(property)) ofPoints.push_back(property.name);
        if (isFace && !isShownOfFace(property)) ofFaces.push_back(property.name);
      }
    }
    if (!elements.empty()) m_mesh.notes.push_back(leftOut("elements", elements));
    if (!ofPoints.empty()) m_mesh.notes.push_back(leftOut("points' properties", ofPoints));
    if (!ofFaces.empty()) m_mesh.notes.push_back(leftOut("faces' properties", ofFaces));
  }

  [[nodiscard]] bool isShownOfPoint(const PlyProperty& property) const {
    const std::optional<std::size_t> place = placeOf(property.name);
    return place && (*place < firstCoordinate || (*place < pictureNumber && m_hasPlaces));
  }

  [[nodiscard]] bool isShownOfFace(const PlyProperty& property) const {
    if (property.name.starts_with("vertex_ind")) return true;
    if (isCornerPlaces(property) || property.name == "texnumber") return m_hasCornerPlaces;
    const std::optional<std::size_t> place = placeOf(property.name);
    return place && *place >= firstColour && *place < firstCoordinate && m_hasFaceColours;
  }

  std::string m_file;
  Reading& m_reading;
  std::string m_bytes;
  std::string_view m_rest;  ///< the unread rest
  Mesh m_mesh;
  /// What a triangle has beyond its points.
  struct CornerValues {
    std::array<std::array<float, 2>, 3> places{};  ///< texture coordinates
    Linear colour{1, 1, 1};
  };

  Textures m_textures;
  PlyHeader m_header;
  std::array<double, 12> m_values{};     ///< of a single row
  std::vector<std::uint32_t> m_polygon;  ///< points of a row
  std::vector<float> m_polygonPlaces;    ///< texture coordinates of a row
  std::vector<CornerValues> m_corners;   ///< of each triangle; empty if none has any
  bool m_hasNormals = false;
  bool m_hasColours = false;
  bool m_hasPlaces = false;        ///< points have texture coordinates, which are shown
  bool m_hasCornerPlaces = false;  ///< corners have
  bool m_hasFaceColours = false;   ///< and points have none
};

}  // namespace

Mesh readPly(Reading& reading) {
  return PlyReader(reading).read();
}

}  // namespace hogelscope::mesh
