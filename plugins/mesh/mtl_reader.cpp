// SPDX-License-Identifier: BSD-3-Clause
#include "mtl_reader.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "errors.h"
#include "mesh_reader.h"

namespace hogelscope::mesh {

MtlReader::MtlReader(Reading& reading, Mesh& mesh)
    : m_reading(reading), m_mesh(mesh), m_textures(reading) {
  m_mesh.materials.emplace_back();
}

void MtlReader::damaged(const std::string& why) const {
  fail(m_file, "line " + std::to_string(m_line), why);
}

std::string MtlReader::read(const std::string& name) {
  const std::string path = besides(m_reading.file(), name);
  const std::string same = sameName(path);
  const auto known = std::ranges::find(m_libraries, same, &Library::file);
  if (known != m_libraries.end()) {
    std::rotate(known, known + 1, m_libraries.end());
    return {};
  }
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return "there is no file " + shortName(path);
  const std::string text = m_reading.bytesOf(path);
  m_mesh.files.push_back(path);
  m_libraries.push_back({same, {}});
  m_file = path;
  m_current.reset();
  forLines(text, [&](std::string_view line, std::size_t number) {
    m_line = number;
    if (number % 65536 == 0) m_reading.poll();
    readLine(Words(line));
  });
  return {};
}

std::optional<std::uint32_t> MtlReader::find(const std::string& name) const {
  for (auto library = m_libraries.rbegin(); library != m_libraries.rend(); ++library)
    if (const auto found = library->materials.find(name); found != library->materials.end())
      return found->second;
  return std::nullopt;
}

void MtlReader::readLine(Words words) {
  static constexpr std::array<std::string_view, 14> others{
      "Ks",   "map_Ks", "map_Ns", "map_d", "map_bump", "map_Bump", "bump",
      "disp", "decal",  "norm",   "refl",  "map_Pr",   "map_Pm",   "map_refl"};
  const std::string_view command = words.next();
  if (command == "newmtl") return beginMaterial(std::string(words.rest()));
  if (!m_current) return;
  Material& material = m_mesh.materials[*m_current];
  if (command == "Kd") {
    material.colour = readColour(words, command);
  } else if (command == "Ke") {
    material.emission = readColour(words, command);
  } else if (command == "map_Kd") {
    material.layer.texture = readTexture(std::string(words.rest()), command);
  } else if (command == "map_Ke") {
    material.glow.texture = readTexture(std::string(words.rest()), command);
    if (material.emission == Linear{}) material.emission = {1, 1, 1};
  } else if (double opacity = 1; command == "d" || command == "Tr") {
    if (words.number(opacity) && opacity != (command == "d" ? 1 : 0)) m_skipped.emplace(command);
  } else if (std::ranges::find(others, command) != others.end()) {
    double strength = 0;  // most files have Ks 0 0 0
    if (command != "Ks" || (words.number(strength) && strength > 0)) m_skipped.emplace(command);
  }
}

/// Starts a material. In one library, a later material of the same name replaces the earlier one.
void MtlReader::beginMaterial(const std::string& name) {
  const auto [found, isNew] =
      m_libraries.back().materials.try_emplace(name, std::uint32_t(m_mesh.materials.size()));
  m_current = found->second;
  if (!isNew) {
    m_mesh.materials[*m_current] = {};
    return;
  }
  m_reading.take(2 * sizeof(Material) + 96 + double(name.size()));  // with a node of the map
  m_mesh.materials.emplace_back();
}

Linear MtlReader::readColour(Words& words, std::string_view command) const {
  double rgb[3]{};
  for (double& part : rgb)
    if (!words.number(part)) damaged(std::string(command) + " needs three numbers");
  return {linearFloat(rgb[0]), linearFloat(rgb[1]), linearFloat(rgb[2])};
}

int MtlReader::readTexture(const std::string& name, std::string_view command) {
  if (name.starts_with('-')) damaged("options of " + std::string(command) + " are not supported");
  const std::string path = besides(m_file, name);
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    damaged("there is no file " + shortName(path));
  return m_textures.add(path);
}

void MtlReader::finish() {
  m_mesh.textures = m_textures.decode();
  m_mesh.files.insert(m_mesh.files.end(), m_textures.files().begin(), m_textures.files().end());
  if (!m_skipped.empty())
    m_mesh.notes.push_back(leftOut("materials'", {m_skipped.begin(), m_skipped.end()}));
}

}  // namespace hogelscope::mesh
