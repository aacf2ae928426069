// SPDX-License-Identifier: BSD-3-Clause
// Layouts "views" and "quilt": images of the same direction of all hogels.
#include "io/layouts/view_layouts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>

#include "core/base/error.h"
#include "io/files/system_limits.h"
#include "io/layouts/texel_placement.h"
#include "io/layouts/view_files.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// A file whose rows of hogels are spread over all of it: if memory is too small for the whole, it
/// is read once for each band of rows.
class ScatteredFile : public LightFieldFile {
 public:
  [[nodiscard]] LightField read(const Progress& progress) override {
    return readBand(0, size().ny, progress);
  }

  void stream(const HogelRow& row, const Progress& progress) override {
    const int ny = size().ny;
    const int rows = rowsAtATime();
    for (int begin = 0; begin < ny; begin += rows) {
      const int end = std::min(ny, begin + rows);
      const Progress ofBand = part(progress, double(begin) / ny, double(end) / ny);
      handOut(readBand(begin, end, part(ofBand, 0, 0.5)), begin, row, part(ofBand, 0.5, 1));
    }
  }

 protected:
  /// Hogel rows [begin, end), of which the first one has j = 0 here.
  [[nodiscard]] virtual LightField readBand(int begin, int end, const Progress& progress) = 0;

 private:
  [[nodiscard]] int rowsAtATime() const {
    constexpr double mostTexels = std::numeric_limits<std::uint32_t>::max() - 1.0;
    const double texels =
        std::min(mostTexels, double(allowedMemory()) / 2 / double(memoryBytes(type())));
    const double fitting = texels / (double(size().width()) * size().dv);
    return std::max(1, int(std::min(fitting, double(size().ny))));
  }

  static void handOut(const LightField& band, int begin, const HogelRow& row,
                      const Progress& progress) {
    for (int j = 0; j < band.size().ny; ++j) {
      reportProgress(progress, double(j) / band.size().ny);
      for (int v = 0; v < band.size().dv; ++v) handOutRow(band, j, v, row, begin + j);
    }
  }
};

class ViewsFolder : public ScatteredFile {
 public:
  ViewsFolder(const LightFieldParams& params, const DisplayParams& display)
      : m_params(params), m_views(findViews(params, display.directions)) {
    const ImageFile first(m_views.found().front(), params.yuv);
    m_type = first.type();
    m_bits = first.bits();
    m_size = {int(first.width()), int(first.height()), m_views.columns, m_views.rows};
  }

  [[nodiscard]] StoredType type() const override { return m_type; }
  [[nodiscard]] int bits() const override { return m_bits; }
  [[nodiscard]] LightFieldSize size() const override { return m_size; }
  [[nodiscard]] std::vector<fs::path> files() const override { return m_views.found(); }
  [[nodiscard]] std::vector<std::string> warnings() const override {
    if (m_views.missing.empty()) return {};
    return {m_views.missing};
  }

  [[nodiscard]] LightField readBand(int begin, int end, const Progress& progress) override {
    LightField lightField = blankLightField({m_size.nx, end - begin, m_size.du, m_size.dv}, m_type,
                                            m_params.file, packIt);
    const std::size_t count = m_views.files.size();
    for (std::size_t k = 0; k < count; ++k) {
      readView(int(k) / m_views.columns, int(k) % m_views.columns, begin, lightField,
               part(progress, double(k) / double(count), double(k + 1) / double(count)));
    }
    return lightField;
  }

 private:
  void readView(int row, int column, int begin, LightField& lightField,
                const Progress& progress) const {
    const fs::path& file =
        m_views.files[std::size_t(row) * std::size_t(m_views.columns) + std::size_t(column)];
    if (file.empty()) return;  // missing: it stays black
    ImageFile image(file, m_params.yuv);
    if (image.width() != std::size_t(m_size.nx) || image.height() != std::size_t(m_size.ny))
      throw InputError(file.string(), "size",
                       "is " + pixels(image.width(), image.height()) +
                           " px, but the first view is " +
                           pixels(std::size_t(m_size.nx), std::size_t(m_size.ny)) +
                           "; lightField.exclude leaves out what is no view");
    const int u = m_params.columns == ColumnOrder::leftRight ? column : m_size.du - 1 - column;
    const int v = m_params.rows == RowOrder::topDown ? row : m_size.dv - 1 - row;
    const int right = int(std::floor(m_params.shear[0] * (u - (m_size.du - 1) / 2.0) + 0.5));
    const int down = int(std::floor(m_params.shear[1] * (v - (m_size.dv - 1) / 2.0) + 0.5));
    const auto target = [&](int x, int y) -> std::optional<TexelIndex> {
      const TexelIndex at{x + right, y + down - begin, u, v};
      if (at.i < 0 || at.i >= m_size.nx || at.j < 0 || at.j >= lightField.size().ny)
        return std::nullopt;
      return at;
    };
    readTexels(image, m_type, lightField, m_params.incoming, target, progress);
  }

  LightFieldParams m_params;
  ViewFiles m_views;
  StoredType m_type{};
  int m_bits = 8;
  LightFieldSize m_size;
};

/// One row of views from the left; the image has them row by row from the bottom left.
class QuiltImage : public ScatteredFile {
 public:
  explicit QuiltImage(const LightFieldParams& params)
      : m_params(params), m_image(params.file, params.yuv) {
    const auto [columns, rows] = quiltTilesFromName(params.file);
    m_columns = params.quiltColumns > 0 ? params.quiltColumns : columns;
    m_rows = params.quiltRows > 0 ? params.quiltRows : rows;
    if (m_columns < 1 || m_rows < 1)
      throw InputError(
          params.file, "lightField.columns",
          "and rows are not given, and the file's name has no _qs{columns}x{rows}a{aspect}");
    const auto tilesX = std::size_t(m_columns);
    const auto tilesY = std::size_t(m_rows);
    if (m_image.width() % tilesX != 0 || m_image.height() % tilesY != 0)
      throw InputError(params.file, "size",
                       "is " + pixels(m_image.width(), m_image.height()) +
                           " px, which does not divide into " + pixels(tilesX, tilesY) + " views");
    m_size = {int(m_image.width() / tilesX), int(m_image.height() / tilesY), m_columns * m_rows, 1};
  }

  [[nodiscard]] StoredType type() const override { return m_image.type(); }
  [[nodiscard]] int bits() const override { return m_image.bits(); }
  [[nodiscard]] LightFieldSize size() const override { return m_size; }
  [[nodiscard]] std::vector<fs::path> files() const override { return {m_image.file()}; }

  [[nodiscard]] LightField readBand(int begin, int end, const Progress& progress) override {
    LightField lightField = blankLightField({m_size.nx, end - begin, m_size.du, m_size.dv},
                                            m_image.type(), m_params.file, packIt);
    const auto target = [&](int x, int y) -> std::optional<TexelIndex> {
      const int j = y % m_size.ny;
      if (j < begin || j >= end) return std::nullopt;
      const int rowFromBottom = m_rows - 1 - y / m_size.ny;
      return TexelIndex{x % m_size.nx, j - begin, rowFromBottom * m_columns + x / m_size.nx, 0};
    };
    readTexels(m_image, m_image.type(), lightField, m_params.incoming, target, progress);
    return lightField;
  }

 private:
  LightFieldParams m_params;
  ImageFile m_image;
  int m_columns = 0;
  int m_rows = 0;
  LightFieldSize m_size;
};

}  // namespace

std::unique_ptr<LightFieldFile> openViews(const LightFieldParams& params,
                                          const DisplayParams& display) {
  return std::make_unique<ViewsFolder>(params, display);
}

std::unique_ptr<LightFieldFile> openQuilt(const LightFieldParams& params) {
  return std::make_unique<QuiltImage>(params);
}

namespace {

/// Returns columns, rows and aspect of a quilt's name; none if it has no such ending.
std::optional<std::smatch> quiltSuffix(const std::string& stem) {
  static const std::regex suffix(R"(.*_qs(\d{1,4})x(\d{1,4})a(\d{0,3}(?:\.\d{0,9})?))");
  std::smatch groups;
  if (!std::regex_match(stem, groups, suffix)) return std::nullopt;
  return groups;
}

}  // namespace

std::array<int, 2> quiltTilesFromName(const std::string& file) {
  const std::string stem = fs::path(file).stem().string();
  const auto groups = quiltSuffix(stem);
  if (!groups) return {0, 0};
  return {std::stoi((*groups)[1]), std::stoi((*groups)[2])};
}

double quiltAspectFromName(const std::string& file) {
  const std::string stem = fs::path(file).stem().string();
  const auto groups = quiltSuffix(stem);
  return groups ? std::atof((*groups)[3].str().c_str()) : 0;
}

}  // namespace hogelscope
