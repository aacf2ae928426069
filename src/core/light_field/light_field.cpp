// SPDX-License-Identifier: BSD-3-Clause
#include "core/light_field/light_field.h"

#include <stdexcept>

namespace hogelscope {

namespace {

LightField::Texels blackTexels(std::size_t count, StoredType type) {
  switch (type) {
    case StoredType::uint8:
      return TexelArray<std::uint8_t>(count);
    case StoredType::uint16:
      return TexelArray<std::uint16_t>(count);
    default:
      return TexelArray<float>(count);
  }
}

}  // namespace

bool isNumbered(const LightFieldParams& params) {
  return params.file.find(frameMark) != std::string::npos ||
         params.pattern.find(frameMark) != std::string::npos;
}

std::string contentName(const LightFieldParams& params) {
  if (!params.isLive()) return params.file;
  const auto* file = params.content.find<std::string>("file");
  return file != nullptr && !file->empty() ? *file : params.source;
}

std::array<std::uint32_t, 4> LightField::blockFor(const LightFieldSize& size) {
  if (size.du == 1 && size.dv == 1) return {1, 3, 0, 0};
  const auto shiftOf = [](int directions, std::uint32_t shift) {
    const auto padding = [&] { return (-directions) & ((1 << shift) - 1); };
    while (shift > 0 && 16 * padding() > directions) --shift;
    return shift;
  };
  return {standardBlock[0], standardBlock[1], shiftOf(size.du, standardBlock[2]),
          shiftOf(size.dv, standardBlock[3])};
}

LightField::LightField(LightFieldSize size, StoredType type,
                       const std::array<std::uint32_t, 4>& block)
    : m_size(size),
      m_layout(size, block),
      m_texels(blackTexels(std::size_t(m_layout.texels) + 1, type)) {}

LightField::LightField(LightFieldSize size, const Values& values)
    : LightField(size, static_cast<StoredType>(values.index())) {
  std::visit(
      [&](const auto& list) {
        if (list.size() != 3 * size.width() * size.height())
          throw std::invalid_argument("LightField: not three values for each directional pixel");
        auto rgb = list.data();
        const auto [nx, ny, du, dv] = size;
        for (int y = 0; y < ny * dv; ++y)
          for (int x = 0; x < nx * du; ++x, rgb += 3) set({x / du, y / dv, x % du, y % dv}, rgb);
      },
      values);
}

LightField::LightField(LightFieldSize size, StoredType type, SliceLayout slice)
    : m_size(size),
      m_slice(std::make_shared<const SliceLayout>(std::move(slice))),
      m_layout(*m_slice),
      m_texels(blackTexels(std::size_t(m_layout.texels) + 1, type)) {}

template <class T>
void LightField::takeRow(int j, int v, const T* rgb) {
  for (const auto& [i, u] : m_slice->runs)
    setRun({i, j, u.first, v}, int(u.size()), rgb + 3 * (std::ptrdiff_t(i) * m_size.du + u.first));
}

template void LightField::takeRow(int, int, const std::uint8_t*);
template void LightField::takeRow(int, int, const std::uint16_t*);
template void LightField::takeRow(int, int, const float*);

std::size_t LightField::bytes(const LightFieldSize& size, StoredType type) {
  const BlockLayout layout(size, blockFor(size));
  return (std::size_t(layout.texels) + 1) * memoryBytes(type);
}

Rgb LightField::texel(const TexelIndex& at) const {
  return std::visit(
      [address = m_layout.address(at)](const auto& list) {
        const auto& stored = list[address];
        return Rgb{codeValue(stored.r), codeValue(stored.g), codeValue(stored.b)};
      },
      m_texels);
}

}  // namespace hogelscope
