// SPDX-License-Identifier: BSD-3-Clause
// Wavefront MTL, the materials of OBJ files: newmtl, Kd, map_Kd, Ke, map_Ke. All other lines are
// skipped; those with a visible effect are noted.
#pragma once

#include <array>
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
  /// Adds a material for faces without one to the mesh, followed by those that it reads.
  MtlReader(Reading& reading, Mesh& mesh);

  /// Reads a file named by an OBJ, once, under any name. Of two materials of one name, that of the
  /// library named last counts. Returns the problem with the name, or "".
  [[nodiscard]] std::string read(const std::string& name);
  /// Returns the index of a material.
  [[nodiscard]] std::optional<std::uint32_t> find(const std::string& name) const;
  /// Decodes the textures, and adds the notes.
  void finish();

 private:
  void readLine(Words words);
  void beginMaterial(const std::string& name);
  [[nodiscard]] Linear readColour(Words& words, std::string_view command) const;
  void readTexture(Words words, std::string_view command, Layer& layer);
  void applyOption(std::string_view option, const std::array<double, 3>& values,
                   Layer& layer) const;
  void noteElsewhere(const std::string& name, const std::string& path);
  [[noreturn]] void damaged(const std::string& why) const;

  struct Library {
    std::string file;  ///< sameName()
    std::map<std::string, std::uint32_t> materials;
  };

  Reading& m_reading;
  Mesh& m_mesh;
  Textures m_textures;
  std::vector<Library> m_libraries;  ///< in the order of their latest naming
  std::set<std::string> m_skipped;   ///< commands with a visible effect
  std::string m_file;                ///< the file being read
  std::size_t m_line = 0;
  std::optional<std::uint32_t> m_current;
};

}  // namespace hogelscope::mesh
