// SPDX-License-Identifier: BSD-3-Clause
#include "mtl_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include "errors.h"
#include "found_files.h"

namespace hogelscope::mesh {

MtlReader::MtlReader(Reading& reading, Mesh& mesh)
    : m_reading(reading), m_mesh(mesh), m_textures(reading) {
  m_mesh.materials.emplace_back();
}

void MtlReader::damaged(const std::string& why) const {
  fail(m_file, "line " + std::to_string(m_line), why);
}

std::string MtlReader::read(const std::string& name) {
  const auto [path, isThere, isElsewhere] = foundBesides(m_reading.file(), name);
  const std::string same = sameName(path);
  const auto known = std::ranges::find(m_libraries, same, &Library::file);
  if (known != m_libraries.end()) {
    std::rotate(known, known + 1, m_libraries.end());
    return {};
  }
  if (!isThere) return "there is no file " + shortName(path);
  if (isElsewhere) noteElsewhere(name, path);
  std::string text = m_reading.bytesOf(path);
  joinContinuedLines(text);
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
    readTexture(words, command, material.layer);
  } else if (command == "map_Ke") {
    readTexture(words, command, material.glow);
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

/// Options stand before the name. Those that change nothing are skipped; -s and -o scale and shift
/// the coordinates, whose v points up.
void MtlReader::readTexture(Words words, std::string_view command, Layer& layer) {
  layer = {};
  Words rest = words;
  for (std::string_view option = rest.next(); option.starts_with('-'); option = rest.next()) {
    const bool isScale = option == "-s";
    if (isScale || option == "-o" || option == "-t" || option == "-mm") {
      std::array<double, 3> values{};
      values.fill(isScale ? 1 : 0);
      if (option == "-mm") values[1] = 1;
      Words numbers = rest;
      for (double& value : values) {
        double read = 0;
        if (!numbers.number(read)) break;
        value = read;
        (void)rest.next();
      }
      applyOption(option, values, layer);
    } else {
      static constexpr std::array<std::array<std::string_view, 2>, 8> neutral{
          {{"-clamp", "off"},
           {"-blendu", "on"},
           {"-blendv", "on"},
           {"-cc", "off"},
           {"-boost", "0"},
           {"-bm", "1"},
           {"-imfchan", "l"},
           {"-type", "sphere"}}};
      const std::string_view value = rest.next();
      const bool isClamp = option == "-clamp" && value == "on";
      if (isClamp) layer.wrap[0] = layer.wrap[1] = Wrap::clamp;
      if (!isClamp && std::ranges::find(neutral, std::array{option, value}) == neutral.end())
        damaged("option " + shortName(std::string(option)) + " of " + std::string(command) +
                " is not supported");
    }
    words = rest;
  }
  const std::string name(words.rest());
  const auto [path, isThere, isElsewhere] = foundBesides(m_file, name);
  if (!isThere) damaged("there is no file " + shortName(path));
  if (isElsewhere) noteElsewhere(name, path);
  layer.texture = m_textures.add(path);
}

void MtlReader::applyOption(std::string_view option, const std::array<double, 3>& values,
                            Layer& layer) const {
  if (option == "-s") {
    layer.axes = {Vec2{values[0], 0}, Vec2{0, values[1]}};
    layer.origin.y += 1 - values[1];
  } else if (option == "-o") {
    layer.origin.x += values[0];
    layer.origin.y -= values[1];
  } else if (values != std::array<double, 3>{0, option == "-mm" ? 1.0 : 0.0, 0}) {
    damaged("option " + std::string(option) + " of a picture is not supported");
  }
}

void MtlReader::noteElsewhere(const std::string& name, const std::string& path) {
  m_mesh.notes.push_back("Its file " + shortName(name) + " is read as " + shortName(path) + ".");
}

void MtlReader::finish() {
  m_mesh.textures = m_textures.decode();
  m_mesh.files.insert(m_mesh.files.end(), m_textures.files().begin(), m_textures.files().end());
  if (!m_skipped.empty())
    m_mesh.notes.push_back(leftOut("materials'", {m_skipped.begin(), m_skipped.end()}));
}

}  // namespace hogelscope::mesh
