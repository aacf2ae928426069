// SPDX-License-Identifier: BSD-3-Clause
// Readers shared by the layouts of light fields in images. Views are sheared by whole pixels, so
// that a codec's own values reach the metrics.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "io/files/system_limits.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// A light field in one file, or in several, whose first one gives type and size.
class PictureFiles : public LightFieldFile {
 public:
  explicit PictureFiles(const LightFieldParams& params) : m_params(params) {}
  [[nodiscard]] LightFieldSize size() const override { return m_size; }
  [[nodiscard]] StoredType type() const override { return m_type; }
  [[nodiscard]] int bits() const override { return m_bits; }
  [[nodiscard]] std::vector<std::string> warnings() const override { return m_warnings; }
  [[nodiscard]] std::vector<std::filesystem::path> files() const override {
    return {m_params.file};
  }
  [[nodiscard]] std::string format() const override { return m_format; }
  [[nodiscard]] FrameNumbers frames() const override { return m_frames; }
  [[nodiscard]] std::size_t framesInFiles() const override { return m_framesInFiles; }
  [[nodiscard]] double frameRate() const override { return m_rate; }
  void select(int frame) override { m_frame = frame; }

 protected:
  /// Gives texels the type, bits and format of an image.
  void takeTypeOf(const ImageFile& image) {
    m_type = image.type();
    m_bits = image.bits();
    m_format = image.format();
  }
  /// Takes the frames of a video, each of which is a light field or a view of one.
  void takeFramesOf(const ImageFile& image) {
    if (!image.isVideo()) return;
    m_frames = listedFrames(m_params, {0, int(image.frames()) - 1, 1});
    m_framesInFiles = image.frames();
    m_rate = image.rate();
    m_frame = m_frames.first;
  }
  [[nodiscard]] std::size_t frame() const { return std::size_t(m_frame); }
  /// Adds warnings from sentences whose subject is missing.
  void warnOf(const std::string& subject, const std::vector<std::string>& notes) {
    for (const std::string& note : notes)
      m_warnings.push_back(std::string(subject).append(" ").append(note));
  }
  [[nodiscard]] LightField blank(int rows) const {
    return blankLightField({m_size.nx, rows, m_size.du, m_size.dv}, m_type, m_params.file, packIt);
  }

  LightFieldParams m_params;
  LightFieldSize m_size;
  std::vector<std::string> m_warnings;

 private:
  StoredType m_type{};
  int m_bits = 8;
  std::string m_format;
  FrameNumbers m_frames;
  std::size_t m_framesInFiles = 1;
  int m_frame = 0;
  double m_rate = 0;
};

/// Images each of which has a part of every row of hogels: if memory is too small for all, they are
/// read once for each band of rows.
class ScatteredFile : public PictureFiles {
 public:
  using PictureFiles::PictureFiles;

  [[nodiscard]] LightField read(const Progress& progress) override {
    return readBand(0, m_size.ny, progress);
  }

  void stream(const HogelRow& row, const Progress& progress) override {
    const int ny = m_size.ny;
    const int rows = rowsAtATime();
    for (int begin = 0; begin < ny; begin += rows) {
      const int end = std::min(ny, begin + rows);
      const Progress ofBand = part(progress, double(begin) / ny, double(end) / ny);
      handOut(readBand(begin, end, part(ofBand, 0, 0.5)), begin, row, part(ofBand, 0.5, 1));
    }
  }

 private:
  /// Fills a band of rows of hogels; its row j = 0 is row `begin` of the light field.
  virtual void fill(LightField& band, int begin, const Progress& progress) = 0;

  [[nodiscard]] LightField readBand(int begin, int end, const Progress& progress) {
    LightField band = blank(end - begin);
    fill(band, begin, progress);
    return band;
  }

  [[nodiscard]] int rowsAtATime() const {
    constexpr double mostTexels = std::numeric_limits<std::uint32_t>::max() - 1.0;
    const double texels =
        std::min(mostTexels, double(allowedMemory()) / 2 / double(memoryBytes(type())));
    const double fitting = texels / (double(m_size.width()) * m_size.dv);
    return std::max(1, int(std::min(fitting, double(m_size.ny))));
  }

  static void handOut(const LightField& band, int begin, const HogelRow& row,
                      const Progress& progress) {
    for (int j = 0; j < band.size().ny; ++j) {
      reportProgress(progress, double(j) / band.size().ny);
      for (int v = 0; v < band.size().dv; ++v) handOutRow(band, j, v, row, begin + j);
    }
  }
};

/// Calls `put(y, rgb)` for the rows of an image, as values of this type.
template <class Put>
void readRows(ImageFile& image, StoredType type, const Put& put, const Progress& progress) {
  image.read(
      type,
      [&](std::size_t first, std::size_t rows, const StoredRows& values) {
        std::visit(
            [&](const auto* rgb) {
              for (std::size_t row = 0; row < rows; ++row)
                put(int(first + row), rgb + 3 * row * image.width());
            },
            values);
      },
      progress);
}

/// Reads an image into the light field; `target(x, y)` returns the texel of pixel (x, y), or none.
/// `incoming` flips directions that were recorded looking into the scene.
template <class Target>
void readTexels(ImageFile& image, LightField& lightField, bool incoming, Target target,
                const Progress& progress) {
  const auto [nx, ny, du, dv] = lightField.size();
  const auto putRow = [&, du = du, dv = dv](int y, const auto* rgb) {
    for (int x = 0; x < int(image.width()); ++x, rgb += 3) {
      std::optional<TexelIndex> at = target(x, y);
      if (!at) continue;
      if (incoming) at = {at->i, at->j, du - 1 - at->u, dv - 1 - at->v};
      lightField.set(*at, rgb);
    }
  };
  readRows(image, lightField.type(), putRow, progress);
}

/// Returns the parameters with the views as they lie in the file: the default order, no shear.
inline LightFieldParams withoutOrder(LightFieldParams params) {
  params.rows = RowOrder::topDown;
  params.columns = ColumnOrder::leftRight;
  params.shear = {0, 0};
  return params;
}

/// Returns the texel of pixel (0, 0) of the view in this row and column of the grid, in a band of
/// hogels that begins in row `begin`; it may lie outside.
inline TexelIndex originOfView(const LightFieldParams& params, const LightFieldSize& size, int row,
                               int column, int begin) {
  const int u = params.columns == ColumnOrder::leftRight ? column : size.du - 1 - column;
  const int v = params.rows == RowOrder::topDown ? row : size.dv - 1 - row;
  const int right = int(std::floor(params.shear[0] * (u - (size.du - 1) / 2.0) + 0.5));
  const int down = int(std::floor(params.shear[1] * (v - (size.dv - 1) / 2.0) + 0.5));
  return {right, down - begin, u, v};
}

/// Returns a function from pixel (x, y) of that view to its texel within hogel rows [begin, begin +
/// rows), or none.
inline auto placeOfView(const LightFieldParams& params, const LightFieldSize& size, int row,
                        int column, int begin, int rows) {
  const TexelIndex origin = originOfView(params, size, row, column, begin);
  return [=, nx = size.nx](int x, int y) -> std::optional<TexelIndex> {
    const TexelIndex at{origin.i + x, origin.j + y, origin.u, origin.v};
    if (at.i < 0 || at.i >= nx || at.j < 0 || at.j >= rows) return std::nullopt;
    return at;
  };
}

/// Reads an image that is a view into a band of hogels; pixel (0, 0) is the texel `origin`.
inline void readView(ImageFile& image, LightField& band, bool incoming, TexelIndex origin,
                     const Progress& progress) {
  const auto [nx, rows, du, dv] = band.size();
  if (incoming) origin = {origin.i, origin.j, du - 1 - origin.u, dv - 1 - origin.v};
  const int first = std::max(0, -origin.i);
  const int last = std::min(int(image.width()), nx - origin.i);
  if (first >= last) return;
  readRows(
      image, band.type(),
      [&, rows = rows](int y, const auto* rgb) {
        const int j = origin.j + y;
        if (j >= 0 && j < rows)
          band.setHogels({origin.i + first, j, origin.u, origin.v}, last - first, rgb + 3 * first);
      },
      progress);
}

}  // namespace hogelscope
