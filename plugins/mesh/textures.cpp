// SPDX-License-Identifier: BSD-3-Clause
#include "textures.h"

#include "errors.h"

namespace hogelscope::mesh {

int Textures::add(const std::string& path) {
  const std::string file = sameName(path);
  if (const auto found = m_numbers.find(file); found != m_numbers.end()) return found->second;
  m_files.push_back(path);
  return add(file, {keep(m_reading.bytesOf(path)), path, "the picture"});
}

int Textures::add(const std::string& key, const EncodedPicture& picture) {
  const auto [found, isNew] = m_numbers.try_emplace(key, int(m_pictures.size()));
  if (!isNew) return found->second;
  constexpr double bytesOfPixel = 3 + 4.0 / 3 * 3 * sizeof(std::uint16_t);  // with the mip chain
  m_reading.take(bytesOfPixel * pixelsOf(picture));
  m_pictures.push_back(picture);
  return found->second;
}

std::vector<Texture> Textures::decode() const {
  std::vector<Texture> textures;
  textures.reserve(m_pictures.size());
  for (const EncodedPicture& picture : m_pictures)
    textures.emplace_back(decoded(picture, m_reading), m_reading);
  return textures;
}

}  // namespace hogelscope::mesh
