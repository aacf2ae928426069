// SPDX-License-Identifier: BSD-3-Clause
// Layout "lenslets": an image taken through an array of lenslets.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "capture/lenslets/lenslet_light.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "io/layouts/layouts.h"
#include "io/layouts/picture_files.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Returns a value as it is stored; full scale is 1.
template <class T>
T stored(double value) {
  if constexpr (std::is_floating_point_v<T>)
    return T(value);
  else
    return T(std::lround(std::clamp(value, 0.0, 1.0) * std::numeric_limits<T>::max()));
}

/// Reads an image as the mean of its channels.
LensletPlane readGreyPlane(ImageFile& image, const Progress& progress) {
  checkFits(double(sizeof(float) * image.width() * image.height()), image.file());
  LensletPlane plane{int(image.width()), int(image.height()), {}};
  plane.values.reserve(image.width() * image.height());
  image.readRows(
      [&](std::size_t, const float* rgb) {
        for (std::size_t x = 0; x < image.width(); ++x, rgb += 3)
          plane.values.push_back((rgb[0] + rgb[1] + rgb[2]) / 3);
      },
      progress);
  return plane;
}

/// Reads an image of even light, or without light, of the same size as `like`.
LensletPlane readPlaneLike(const std::string& file, const ImageFile& like,
                           const Progress& progress) {
  ImageFile image(file);
  if (image.width() != like.width() || image.height() != like.height())
    throw InputError(file, "size",
                     "is " + pairText(image.width(), image.height()) +
                         " px, but the light field's is " + pairText(like.width(), like.height()) +
                         ": give a picture of the same camera, cut alike");
  return readGreyPlane(image, progress);
}

/// Reads an image less its dark frame, times gain, divided by the white image if there is one.
LensletLight readLight(ImageFile& image, const LensletPlane& dark, const LensletPlane& white,
                       double gain, const Progress& progress) {
  const std::size_t channels = image.channels() < 3 ? 1 : 3;
  checkFits(double(sizeof(float) * channels * image.width() * image.height()), image.file());
  LensletLight light{int(image.width()), int(image.height()), channels, {}};
  light.values.reserve(channels * image.width() * image.height());
  image.readRows(
      [&](std::size_t y, const float* rgb) {
        for (std::size_t p = y * image.width(); p < (y + 1) * image.width(); ++p, rgb += 3) {
          const float black = dark.values.empty() ? 0 : dark.values[p];
          const float even = white.values.empty() ? 1 : std::max(white.values[p], leastWhite);
          for (std::size_t c = 0; c < channels; ++c)
            light.values.push_back(float(gain) * std::max(0.0F, rgb[c] - black) / even);
        }
      },
      progress);
  return light;
}

class LensletPicture : public PictureFiles {
 public:
  LensletPicture(const LightFieldParams& params, const DisplayParams& display,
                 const Progress& progress)
      : PictureFiles(params), m_image(params.file, params.yuv) {
    takeTypeOf(m_image);
    warnOf("the picture", m_image.notesOfOne());
    const auto& [white, dark, grid, pitch, rotation, origin, gain] = params.lenslets;
    if (!dark.empty()) m_dark = readPlaneLike(dark, m_image, part(progress, 0, 0.2));
    if (!white.empty()) {
      m_white = readPlaneLike(white, m_image, part(progress, 0.2, 0.5));
      subtract(m_white, m_dark);
    }
    inFile(white.empty() ? params.file : white, [&, hasWhite = !white.empty()] {
      findIn(display, part(progress, 0.5, 1));
      if (hasWhite) normalise(m_white, m_found.lattice, m_size);
    });
  }

  [[nodiscard]] std::vector<fs::path> files() const override {
    std::vector<fs::path> files{m_image.file()};
    for (const std::string& other : {m_params.lenslets.white, m_params.lenslets.dark})
      if (!other.empty()) files.emplace_back(other);
    return files;
  }
  [[nodiscard]] const FoundLenslets& found() const { return m_found; }

  [[nodiscard]] LightField read(const Progress& progress) override {
    LightField lightField = blank(m_size.ny);
    const LensletSampler sampler = samplerOf(part(progress, 0, 0.5));
    const Progress ofRows = forThreads(part(progress, 0.5, 1));
    withStoredType(type(), [&]<class T>(T) {
      parallelRows(m_size.ny, [&](int begin, int end) {
        for (int j = begin; j < end; ++j) {
          reportProgress(ofRows, double(j) / m_size.ny);
          for (int v = 0; v < m_size.dv; ++v) takeRow<T>(sampler, j, v, lightField);
        }
      });
    });
    return lightField;
  }

  void stream(const HogelRow& row, const Progress& progress) override {
    const LensletSampler sampler = samplerOf(part(progress, 0, 0.5));
    withStoredType(type(), [&]<class T>(T) {
      LightField band({m_size.nx, 1, m_size.du, m_size.dv}, type());
      for (int j = 0; j < m_size.ny; ++j) {
        reportProgress(progress, 0.5 + 0.5 * j / m_size.ny);
        for (int v = 0; v < m_size.dv; ++v) takeRow<T>(sampler, j, v, band);
        for (int v = 0; v < m_size.dv; ++v) handOutRow(band, 0, v, row, j);
      }
    });
  }

 private:
  void findIn(const DisplayParams& display, const Progress& progress) {
    if (!m_white.values.empty()) {
      m_found = findLenslets(m_white, m_params.lenslets, progress);
    } else {
      LensletPlane own = readGreyPlane(m_image, part(progress, 0, 0.5));
      subtract(own, m_dark);
      m_found = findLenslets(own, m_params.lenslets, part(progress, 0.5, 1));
    }
    takeBlock(display);
  }

  void takeBlock(const DisplayParams& display) {
    const LensletLattice& lattice = m_found.lattice;
    const int side = int(lattice.pitch());
    const auto [across, down] = display.directions;
    const LensletArea area{int(m_image.width()), int(m_image.height()), across > 0 ? across : side,
                           down > 0 ? down : side};
    if (area.du > 2 * lattice.pitch() || area.dv > 2 * lattice.pitch())
      throw InputError(m_params.file, "display.directions",
                       "is " + pairText(area.du, area.dv) + ", but the lenslets' pitch is " +
                           rounded(lattice.pitch(), 4) + " px: give no more than that, or none");
    const HogelBlock block = m_params.lenslets.isOriginGiven() ? blockFromOrigin(lattice, area)
                                                               : largestBlock(lattice, area);
    if (block.nx < 1)
      throw InputError(m_params.file, "lenslets",
                       "are not in the picture: none of pitch " + rounded(lattice.pitch(), 4) +
                           " px is whole in " + pairText(m_image.width(), m_image.height()) +
                           " px; give another lightField.pitch or origin");
    const auto [nx, ny] = display.hogels;
    if (nx > block.nx || ny > block.ny)
      throw InputError(m_params.file, "display.hogels",
                       "is " + pairText(nx, ny) + ", but only " + pairText(block.nx, block.ny) +
                           " whole lenslets are in the picture: give no more, or none");
    m_size = {nx > 0 ? nx : block.nx, ny > 0 ? ny : block.ny, area.du, area.dv};
    m_found.lattice = block.lattice;
  }

  [[nodiscard]] LensletSampler samplerOf(const Progress& progress) {
    return {readLight(m_image, m_dark, m_white, m_params.lenslets.gain, progress), m_white,
            m_found.lattice, m_size};
  }

  /// Writes directions (·, v) of hogels (·, j) into a light field of one row, or of all.
  template <class T>
  void takeRow(const LensletSampler& sampler, int j, int v, LightField& lightField) const {
    std::array<double, 3> light{};
    for (int i = 0; i < m_size.nx; ++i)
      for (int u = 0; u < m_size.du; ++u) {
        sampler.sample({i, j, u, v}, light);
        const std::array<T, 3> rgb{stored<T>(light[0]), stored<T>(light[1]), stored<T>(light[2])};
        TexelIndex at{i, lightField.size().ny > 1 ? j : 0, u, v};
        if (m_params.incoming) at = {at.i, at.j, m_size.du - 1 - u, m_size.dv - 1 - v};
        lightField.set(at, rgb.data());
      }
  }

  ImageFile m_image;
  LensletPlane m_dark;
  LensletPlane m_white;
  FoundLenslets m_found;
};

}  // namespace

const LayoutType lensletsLayout{
    .open = [](const LightFieldParams& params, const DisplayParams& display,
               const Progress& progress) -> std::unique_ptr<LightFieldFile> {
      return std::make_unique<LensletPicture>(params, display, progress);
    },
    .words = [](const LightFieldParams& params, const DisplayParams&) -> std::string {
      return params.lenslets.grid == LensletGrid::square ? "lenslets, a square grid"
                                                         : "lenslets, a hexagonal grid";
    },
    .foundBy =
        [](const LightFieldParams&) {
          return FoundBy{"spots of light on a regular grid",
                         "a regular grid of lenslets in the picture"};
        }};

FoundLenslets lensletsOf(const LightFieldParams& params, const DisplayParams& display,
                         const Progress& progress) {
  return LensletPicture(params, display, progress).found();
}

std::string warningOf(const LightFieldParams& params, const FoundLenslets& found) {
  constexpr double mostPixels = 0.5;
  constexpr double mostDegrees = 10;
  const std::string file = params.lenslets.white.empty() ? params.file : params.lenslets.white;
  if (found.residual > mostPixels)
    return file + ": lenslets lie " + rounded(found.residual, 2) +
           " px (rms) off a regular grid: give another lightField.grid, pitch or white, or take "
           "the "
           "lens's distortion out";
  if (std::abs(found.lattice.rotation()) > mostDegrees)
    return file + ": rows of lenslets are turned by " + rounded(found.lattice.rotation(), 2) +
           "°: turn the pictures so that rows run along them";
  return {};
}

}  // namespace hogelscope
