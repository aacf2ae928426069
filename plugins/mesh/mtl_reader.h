// SPDX-License-Identifier: BSD-3-Clause
// Wavefront MTL, the materials of OBJ files: newmtl, Kd, map_Kd, Ke, map_Ke. All other lines are
// skipped; what they would show is noted.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mesh.h"
#include "textures.h"
#include "words.h"

namespace hogelscope::mesh {

class MtlReader {
 public:
  /// Adds what it reads to the mesh, after a material for faces without one.
  MtlReader(Reading& reading, Mesh& mesh);

  /// Reads the file that an OBJ names; once, by whatever names. Of two materials of one name that
  /// of the library that was named last counts. Returns what is wrong with the name.
  [[nodiscard]] std::string read(const std::string& name);
  /// Returns the number of a material.
  [[nodiscard]] std::optional<std::uint32_t> find(const std::string& name) const;
  /// Decodes the textures, and adds the notes.
  void finish();

 private:
  void readLine(Words words);
  void beginMaterial(const std::string& name);
  [[nodiscard]] Linear readColour(Words& words, std::string_view command) const;
  [[nodiscard]] int readTexture(const std::string& name, std::string_view command);
  [[noreturn]] void damaged(const std::string& why) const;

  struct Library {
    std::string file;  ///< sameName()
    std::map<std::string, std::uint32_t> materials;
  };

  Reading& m_reading;
  Mesh& m_mesh;
  Textures m_textures;
  std::vector<Library> m_libraries;  ///< in the order in which they were named last
  std::set<std::string> m_skipped;   ///< commands that would show something
  std::string m_file;                ///< that is being read
  std::size_t m_line = 0;
  std::optional<std::uint32_t> m_current;
};

}  // namespace hogelscope::mesh
