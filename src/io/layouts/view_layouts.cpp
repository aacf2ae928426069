// SPDX-License-Identifier: BSD-3-Clause
// Layouts "views" and "quilt": images of the same direction of all hogels.
#include "io/layouts/view_layouts.h"

#include <algorithm>
#include <cmath>
#include <regex>

#include "core/base/error.h"
#include "io/layouts/scattered_file.h"
#include "io/layouts/texel_placement.h"
#include "io/layouts/view_files.h"
#include "io/layouts/view_sequences.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

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
    readTexels(image, m_type, lightField, m_params.incoming,
               placeOfView(m_params, m_size, row, column, begin, lightField.size().ny), progress);
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
  if (isViewSequence(params.file)) return openViewSequence(params, display);
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
