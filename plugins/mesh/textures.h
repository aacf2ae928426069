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

/// Gives each image one index, under any of its names in a file, and decodes none before the memory
/// for all of them is reserved.
class Textures {
 public:
  explicit Textures(Reading& reading) : m_reading(reading) {}

  /// Returns the texture index of an image file.
  int add(const std::string& path);
  /// Returns the texture index of an image in memory, which must stay there. `key` identifies it.
  int add(const std::string& key, const EncodedPicture& picture);
  /// Takes ownership of an image's bytes and returns a view of them.
  std::string_view keep(std::string bytes) { return m_bytes.emplace_back(std::move(bytes)); }

  /// Decodes all images, in the order of their indices.
  [[nodiscard]] std::vector<Texture> decode() const;
  /// Returns the image files that were read.
  [[nodiscard]] const std::vector<std::string>& files() const { return m_files; }

 private:
  Reading& m_reading;
  std::map<std::string, int> m_numbers;
  std::vector<EncodedPicture> m_pictures;
  std::deque<std::string> m_bytes;
  std::vector<std::string> m_files;
};

}  // namespace hogelscope::mesh
