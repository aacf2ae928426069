// SPDX-License-Identifier: BSD-3-Clause
// Wavefront OBJ: v (with optional colours), vt, vn, f, usemtl, mtllib. All other lines are skipped;
// those with a visible effect are noted. Colours are interpreted as sRGB.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <unordered_map>

#include "errors.h"
#include "mesh_reader.h"
#include "mtl_reader.h"
#include "words.h"

namespace hogelscope::mesh {

namespace {

/// The capacity of a growing list relative to its size, at most.
constexpr double growing = 2;

class ObjReader {
 public:
  explicit ObjReader(Reading& reading)
      : m_file(reading.file()), m_reading(reading), m_libraries(reading, m_mesh) {}

  Mesh read() {
    std::string text = m_reading.bytesOf(m_file);
    m_mesh.files.push_back(m_file);
    joinContinuedLines(text);
    forLines(text, [&](std::string_view line, std::size_t number) {
      m_line = number;
      if (number % 65536 == 0)
        m_reading.report(std::size_t(line.data() - text.data()), text.size());
      readLine(Words(line));
    });
    m_mesh.fillAttributes();
    m_libraries.finish();
    if (!m_skipped.empty()) m_mesh.notes.push_back(leftOut("lines", m_skipped));
    return std::move(m_mesh);
  }

 private:
  /// A corner of a face: indices of position, texture coordinates and normal, from 1; 0: none.
  using Corner = std::array<std::uint32_t, 3>;
  struct CornerHash {
    std::size_t operator()(const Corner& c) const {
      std::size_t hash = c[0];
      for (const std::uint32_t part : {c[1], c[2]}) hash = (hash ^ part) * 0x9E3779B97F4A7C15U;
      return hash ^ (hash >> 32U);
    }
  };

  [[noreturn]] void damaged(const std::string& why) const {
    fail(m_file, "line " + std::to_string(m_line), why);
  }

  void readLine(Words words) {
    const std::string_view command = words.next();
    if (command == "v") {
      readPlace(words);
    } else if (command == "vt") {
      double u = 0;
      double v = 0;
      if (!words.number(u)) damaged("vt needs a number");
      words.number(v);
      m_reading.take(growing * sizeof(m_uv[0]));
      m_uv.push_back({float(u), float(1 - v)});
    } else if (command == "vn") {
      Vec3 n;
      if (!words.number(n.x) || !words.number(n.y) || !words.number(n.z))
        damaged("vn needs three numbers");
      n = normalise(n);
      m_reading.take(growing * sizeof(m_normals[0]));
      m_normals.push_back({float(n.x), float(n.y), float(n.z)});
    } else if (command == "f") {
      readFace(words);
    } else if (command == "usemtl") {
      const std::string name(words.rest());
      const auto material = m_libraries.find(name);
      if (!material) damaged("no .mtl file has the material " + shortName(name));
      m_material = *material;
    } else if (command == "mtllib") {
      readLibraries(words);
    } else {
      note(command);
    }
  }

  /// The line has one name, which may have blanks, or several names.
  void readLibraries(Words& words) {
    const std::string problem = m_libraries.read(std::string(words.rest()));
    if (problem.empty()) return;
    std::vector<std::string> names;
    for (std::string_view name = words.next(); !name.empty(); name = words.next())
      names.emplace_back(name);
    for (const std::string& name : names)
      if (names.size() < 2 || !m_libraries.read(name).empty()) damaged(problem);
  }

  void note(std::string_view command) {
    static constexpr std::array<std::string_view, 4> shapes{"p", "l", "curv", "surf"};
    if (std::ranges::find(shapes, command) != shapes.end() &&
        std::ranges::find(m_skipped, command) == m_skipped.end())
      m_skipped.emplace_back(command);
  }

  void readPlace(Words& words) {
    Vec3 p;
    if (!words.number(p.x) || !words.number(p.y) || !words.number(p.z))
      damaged("v needs three numbers");
    double r = 1;
    double g = 1;
    double b = 1;
    const bool isColoured = words.number(r) && words.number(g) && words.number(b);
    if (isColoured && !m_hasColours) {
      m_hasColours = true;
      m_reading.take(growing * sizeof(Linear) * double(m_places.size()));
      m_colours.resize(m_places.size(), Linear{1, 1, 1});
    }
    m_reading.take(growing * (sizeof(Vec3) + (m_hasColours ? sizeof(Linear) : 0)));
    m_places.push_back(p);
    if (m_hasColours)
      m_colours.push_back(isColoured ? Linear{linearFloat(r), linearFloat(g), linearFloat(b)}
                                     : Linear{1, 1, 1});
  }

  /// Parses "7", "7/2", "7//3" or "7/2/3"; negative numbers count back from the newest.
  [[nodiscard]] Corner readCorner(std::string_view word) const {
    const std::array<std::size_t, 3> counts{m_places.size(), m_uv.size(), m_normals.size()};
    Corner corner{};
    for (std::size_t k = 0; k < 3 && !word.empty(); ++k) {
      const std::string_view text = word.substr(0, word.find('/'));
      word.remove_prefix(std::min(text.size() + 1, word.size()));
      if (text.empty() && k > 0) continue;
      long long number = 0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
      if (error != std::errc() || end != text.data() + text.size())
        damaged("a face's corner is no number");
      if (number < 0) number += (long long)(counts[k]) + 1;
      if (number < 1 || number > (long long)(counts[k]))
        damaged("a face names entry " + std::string(text) + " of " + std::to_string(counts[k]));
      corner[k] = std::uint32_t(number);
    }
    return corner;
  }

  void readFace(Words& words) {
    std::vector<std::uint32_t> corners;
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      corners.push_back(pointOf(readCorner(word)));
      if (corners.size() % 65536 == 0) m_reading.poll();
      if (m_mesh.triangles.size() + corners.size() > mostTriangles + 2)
        fail(m_file, "the file", "has more than 33554432 triangles");
    }
    if (corners.size() < 3) damaged("a face needs three corners");
    m_reading.take(double(corners.size() - 2) *
                   (growing * (sizeof(Corners) + sizeof(std::uint32_t)) + sceneBytesOfTriangle));
    for (std::size_t k = 2; k < corners.size(); ++k)
      m_mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
    m_mesh.materialOf.resize(m_mesh.triangles.size(), m_material);
  }

  [[nodiscard]] double bytesOfPoint(const Corner& corner) const {
    return double(sizeof(Vec3) + (m_hasColours ? sizeof(Linear) : 0) +
                  (corner[1] != 0 ? sizeof(m_uv[0]) : 0) +
                  (corner[2] != 0 ? sizeof(m_normals[0]) : 0));
  }

  /// Returns the mesh's point for a corner, a new one for a new combination.
  std::uint32_t pointOf(const Corner& corner) {
    const auto [found, isNew] = m_points.try_emplace(corner, std::uint32_t(m_mesh.points.size()));
    if (!isNew) return found->second;
    const std::size_t count = m_mesh.points.size();
    const std::size_t place = corner[0] - 1;
    // The map of known corners has a node and a table entry.
    m_reading.take(sceneBytesOfPoint + sizeof(Corner) + 48 + growing * bytesOfPoint(corner));
    m_mesh.points.push_back(m_places[place]);
    if (!m_colours.empty()) {
      m_mesh.colours.resize(count, Linear{1, 1, 1});
      m_mesh.colours.push_back(m_colours[place]);
    }
    if (corner[1] != 0) {
      m_mesh.uv.resize(count);
      m_mesh.uv.push_back(m_uv[corner[1] - 1]);
    }
    if (corner[2] != 0) {
      m_mesh.normals.resize(count);
      m_mesh.normals.push_back(m_normals[corner[2] - 1]);
    }
    return found->second;
  }

  std::string m_file;
  Reading& m_reading;
  Mesh m_mesh;
  MtlReader m_libraries;
  std::vector<Vec3> m_places;
  std::vector<Linear> m_colours;
  std::vector<std::array<float, 2>> m_uv;
  std::vector<std::array<float, 3>> m_normals;
  std::unordered_map<Corner, std::uint32_t, CornerHash> m_points;
  std::vector<std::string> m_skipped;  ///< skipped commands with a visible effect
  bool m_hasColours = false;
  std::uint32_t m_material = 0;
  std::size_t m_line = 0;
};

}  // namespace

Mesh readObj(Reading& reading) {
  return ObjReader(reading).read();
}

}  // namespace hogelscope::mesh
