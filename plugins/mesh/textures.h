// SPDX-License-Identifier: BSD-3-Clause
// The textures of a mesh while it is read.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "picture.h"
#include "texture.h"

namespace hogelscope::mesh {

/// Gives each picture one number, by whatever names a file has it, and decodes none before the
/// memory for all of them is known to be there.
class Textures {
 public:
  explicit Textures(Reading& reading) : m_reading(reading) {}

  /// Returns the number of a picture file's texture.
  int add(const std::string& path);
  /// Returns that of a picture in memory, which must stay there. `key` tells it from others.
  int add(const std::string& key, const EncodedPicture& picture);
  /// Takes the bytes of a picture over, to stay as long as this.
  std::string_view keep(std::string bytes) { return m_bytes.emplace_back(std::move(bytes)); }

  /// Decodes all, in the order of their numbers.
  [[nodiscard]] std::vector<Texture> decode() const;
  /// The picture files that were read.
  [[nodiscard]] const std::vector<std::string>& files() const { return m_files; }

 private:
  Reading& m_reading;
  std::map<std::string, int> m_numbers;
  std::vector<EncodedPicture> m_pictures;
  std::deque<std::string> m_bytes;
  std::vector<std::string> m_files;
};

}  // namespace hogelscope::mesh
