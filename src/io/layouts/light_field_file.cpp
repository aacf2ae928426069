// SPDX-License-Identifier: BSD-3-Clause
#include "io/layouts/light_field_file.h"

#include <stdexcept>

#include "core/base/error.h"
#include "io/files/system_limits.h"

namespace hogelscope {

namespace fs = std::filesystem;

std::shared_ptr<const LightFieldSource> LightFieldFile::source(const SourceUse& use,
                                                               const Progress& progress) {
  if (!fitsInMemory(*this, use.memory)) {
    const std::vector<fs::path> all = files();
    const double texels = double(size().width()) * double(size().height());
    checkFits(texels * double(memoryBytes(type())), all.empty() ? "" : all.front(), packIt,
              use.memory);
  }
  return std::make_shared<const LightField>(read(progress));
}

FrameNumbers listedFrames(const LightFieldParams& params, const FrameNumbers& all) {
  if (!params.frames) return all;
  for (const int frame : {params.frames->first, params.frames->last})
    if (!all.has(frame))
      throw InputError(contentName(params), "lightField.frames",
                       "lists frame " + std::to_string(frame) + ", but " +
                           (all.isStill() ? "there is one frame, " + std::to_string(all.first)
                                          : "there are frames " + std::to_string(all.first) +
                                                " … " + std::to_string(all.last)));
  return *params.frames;
}

double frameRateOf(const LightFieldParams& params, const LightFieldFile& file) {
  return params.fps != notGiven ? params.fps : file.frameRate();
}

bool fitsInMemory(const LightFieldFile& file, std::size_t memory) {
  try {
    return LightField::bytes(file.size(), file.type()) <= memory;
  } catch (const std::length_error&) {
    return false;
  }
}

void handOutRow(const LightField& lightField, int j, int v, const LightFieldFile::HogelRow& use,
                int to) {
  const LightFieldSize size = lightField.size();
  std::visit(
      [&](const auto& texels) {
        std::vector<std::decay_t<decltype(texels[0].r)>> rgb;
        rgb.reserve(3 * size.width());
        for (int i = 0; i < size.nx; ++i)
          for (int u = 0; u < size.du; ++u) {
            const auto& [r, g, b, unused] = texels[lightField.layout().address({i, j, u, v})];
            rgb.insert(rgb.end(), {r, g, b});
          }
        use(to, v, rgb.data());
      },
      lightField.texels());
}

LightField blankLightField(const LightFieldSize& size, StoredType type, const fs::path& file,
                           const std::string& advice) {
  try {
    constexpr double most = 0.9;  // of the memory that there is
    checkFits(double(LightField::bytes(size, type)), file, advice,
              std::size_t(most * double(machineMemory())));
    return {size, type};
  } catch (const std::length_error&) {
    throw InputError(file.string(), "size",
                     "is more than 2^32 directional pixels in memory: " + advice);
  }
}

LightField LightFieldFile::readStreamed(const std::filesystem::path& file,
                                        const std::string& advice, const Progress& progress) {
  LightField lightField = blankLightField(size(), type(), file, advice);
  const auto [nx, ny, du, dv] = size();
  stream(
      [&, nx = nx, du = du](int j, int v, const StoredRows& row) {
        std::visit(
            [&](const auto* rgb) {
              for (int i = 0; i < nx; ++i)
                for (int u = 0; u < du; ++u, rgb += 3) lightField.set({i, j, u, v}, rgb);
            },
            row);
      },
      progress);
  return lightField;
}

}  // namespace hogelscope
