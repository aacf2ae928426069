// SPDX-License-Identifier: BSD-3-Clause
// Wavefront OBJ: v (with colours after the place), vt, vn, f, usemtl, mtllib; of MTL: newmtl, Kd,
// map_Kd. All other lines are skipped. Colours are taken for sRGB.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <string_view>
#include <unordered_map>

#include "errors.h"
#include "mesh_reader.h"

namespace hogelscope::mesh {

namespace {

/// The words of one line.
class Words {
 public:
  explicit Words(std::string_view line) : m_rest(line) {}

  /// Returns the next word, or "".
  std::string_view next() {
    m_rest.remove_prefix(std::min(m_rest.find_first_not_of(" \t\r"), m_rest.size()));
    const std::string_view word = m_rest.substr(0, m_rest.find_first_of(" \t\r"));
    m_rest.remove_prefix(word.size());
    return word;
  }

  /// Returns all that is left, without blanks at its ends.
  std::string_view rest() {
    m_rest.remove_prefix(std::min(m_rest.find_first_not_of(" \t\r"), m_rest.size()));
    return m_rest.substr(0, m_rest.find_last_not_of(" \t\r") + 1);
  }

  /// Reads the next word as a number. Returns false if it is none.
  bool number(double& value) {
    std::string_view word = next();
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
  }

 private:
  std::string_view m_rest;
};

/// Calls `read` with each line and its number.
template <class Read>
void forLines(std::string_view text, const Read& read) {
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    read(text.substr(0, end), number);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

float linearFloat(double encoded) {
  return float(linearOf(std::clamp(encoded, 0.0, 1.0)));
}

class ObjReader {
 public:
  ObjReader(const std::string& file, const plugin::Progress& progress)
      : m_file(file), m_progress(progress) {}

  Mesh read() {
    std::string text = readBytes(m_file);
    m_mesh.files.push_back(m_file);
    m_mesh.materials.emplace_back();
    // A backslash carries a line on.
    for (std::size_t at = text.find("\\\n"); at != std::string::npos; at = text.find("\\\n", at))
      text[at] = text[at + 1] = ' ';
    forLines(text, [&](std::string_view line, std::size_t number) {
      m_line = number;
      if (number % 65536 == 0)
        report(m_progress, std::size_t(line.data() - text.data()), text.size());
      readLine(Words(line));
    });
    m_mesh.fillAttributes();
    return std::move(m_mesh);
  }

 private:
  /// A corner of a face: numbers of its place, texture coordinates and normal, from 1; 0: none.
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
      m_uv.push_back({float(u), float(1 - v)});
    } else if (command == "vn") {
      Vec3 n;
      if (!words.number(n.x) || !words.number(n.y) || !words.number(n.z))
        damaged("vn needs three numbers");
      n = normalise(n);
      m_normals.push_back({float(n.x), float(n.y), float(n.z)});
    } else if (command == "f") {
      readFace(words);
    } else if (command == "usemtl") {
      useMaterial(std::string(words.rest()));
    } else if (command == "mtllib") {
      readLibrary(std::string(words.rest()));
    }
  }

  void readPlace(Words& words) {
    Vec3 p;
    if (!words.number(p.x) || !words.number(p.y) || !words.number(p.z))
      damaged("v needs three numbers");
    double r = 1;
    double g = 1;
    double b = 1;
    const bool isColoured = words.number(r) && words.number(g) && words.number(b);
    if (isColoured && m_colours.empty()) m_colours.resize(m_places.size(), Linear{1, 1, 1});
    m_places.push_back(p);
    if (!m_colours.empty())
      m_colours.push_back(isColoured ? Linear{linearFloat(r), linearFloat(g), linearFloat(b)}
                                     : Linear{1, 1, 1});
  }

  /// Reads "7", "7/2", "7//3" or "7/2/3"; negative numbers count back from the newest.
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
    for (std::string_view word = words.next(); !word.empty(); word = words.next())
      corners.push_back(pointOf(readCorner(word)));
    if (corners.size() < 3) damaged("a face needs three corners");
    if (m_mesh.triangles.size() + corners.size() > mostTriangles)
      fail(m_file, "the file", "has more than 33554432 triangles");
    for (std::size_t k = 2; k < corners.size(); ++k)
      m_mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
    m_mesh.materialOf.resize(m_mesh.triangles.size(), m_material);
  }

  /// The mesh's point for a corner: a new one for a new combination.
  std::uint32_t pointOf(const Corner& corner) {
    const auto [found, isNew] = m_points.try_emplace(corner, std::uint32_t(m_mesh.points.size()));
    if (!isNew) return found->second;
    const std::size_t count = m_mesh.points.size();
    const std::size_t place = corner[0] - 1;
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

  void useMaterial(const std::string& name) {
    const auto found = m_materials.find(name);
    if (found == m_materials.end()) damaged("no .mtl file has the material " + shortName(name));
    m_material = found->second;
  }

  void readLibrary(const std::string& name) {
    const std::string path = besides(m_file, name);
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
      damaged("there is no file " + shortName(path));
    const std::string text = readBytes(path);
    m_mesh.files.push_back(path);
    Material* material = nullptr;
    forLines(text, [&](std::string_view line, std::size_t number) {
      Words words(line);
      const std::string_view command = words.next();
      if (command == "newmtl") {
        m_materials[std::string(words.rest())] = std::uint32_t(m_mesh.materials.size());
        material = &m_mesh.materials.emplace_back();
      } else if (command == "Kd" && material != nullptr) {
        double rgb[3]{};
        for (double& part : rgb)
          if (!words.number(part))
            fail(path, "line " + std::to_string(number), "Kd needs three numbers");
        material->colour = {linearFloat(rgb[0]), linearFloat(rgb[1]), linearFloat(rgb[2])};
      } else if (command == "map_Kd" && material != nullptr) {
        material->texture = readTexture(std::string(words.rest()), path, number);
      }
    });
  }

  int readTexture(const std::string& name, const std::string& library, std::size_t line) {
    if (name.starts_with('-'))
      fail(library, "line " + std::to_string(line), "options of map_Kd are not supported");
    const std::string path = besides(library, name);
    const auto [found, isNew] = m_textures.try_emplace(path, int(m_mesh.textures.size()));
    if (!isNew) return found->second;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
      fail(library, "line " + std::to_string(line), "there is no file " + shortName(path));
    m_mesh.textures.emplace_back(decodePicture(readBytes(path), path, "the picture"));
    m_mesh.files.push_back(path);
    return found->second;
  }

  std::string m_file;
  const plugin::Progress& m_progress;
  Mesh m_mesh;
  std::vector<Vec3> m_places;
  std::vector<Linear> m_colours;
  std::vector<std::array<float, 2>> m_uv;
  std::vector<std::array<float, 3>> m_normals;
  std::unordered_map<Corner, std::uint32_t, CornerHash> m_points;
  std::map<std::string, std::uint32_t> m_materials;
  std::map<std::string, int> m_textures;
  std::uint32_t m_material = 0;
  std::size_t m_line = 0;
};

}  // namespace

Mesh readObj(const std::string& file, const plugin::Progress& progress) {
  return ObjReader(file, progress).read();
}

}  // namespace hogelscope::mesh
