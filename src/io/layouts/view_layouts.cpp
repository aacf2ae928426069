// SPDX-License-Identifier: BSD-3-Clause
// Layouts "views", "quilt" and "mosaic": images of the same direction of all hogels.
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

/// One image of views as tiles.
class TiledImage : public ScatteredFile {
 public:
  /// As many tiles across and down.
  TiledImage(const LightFieldParams& params, const std::array<int, 2>& tiles)
      : m_params(params), m_image(params.file, params.yuv), m_columns(tiles[0]), m_rows(tiles[1]) {
    const bool isQuilt = params.layout == Layout::quilt;
    const auto across = std::size_t(m_columns);
    const auto down = std::size_t(m_rows);
    if (m_image.width() % across != 0 || m_image.height() % down != 0)
      throw InputError(params.file, "size",
                       "is " + pixels(m_image.width(), m_image.height()) +
                           " px, which does not divide into " + pixels(across, down) +
                           " views; mend " +
                           (isQuilt ? "lightField.columns and rows" : "display.directions"));
    m_size = {int(m_image.width() / across), int(m_image.height() / down),
              isQuilt ? m_columns * m_rows : m_columns, isQuilt ? 1 : m_rows};
  }

  [[nodiscard]] StoredType type() const override { return m_image.type(); }
  [[nodiscard]] int bits() const override { return m_image.bits(); }
  [[nodiscard]] LightFieldSize size() const override { return m_size; }
  [[nodiscard]] std::vector<fs::path> files() const override { return {m_image.file()}; }

  [[nodiscard]] LightField readBand(int begin, int end, const Progress& progress) override {
    LightField lightField = blankLightField({m_size.nx, end - begin, m_size.du, m_size.dv},
                                            m_image.type(), m_params.file, packIt);
    const auto placeOf = [&](const std::array<int, 2>& view) {
      return placeOfView(m_params, m_size, view[0], view[1], begin, end - begin);
    };
    std::array<int, 2> tile{0, 0};
    std::optional place(placeOf(viewOn(0, 0)));
    const auto target = [&](int x, int y) {
      const std::array own{y / m_size.ny, x / m_size.nx};
      if (own != tile) place.emplace(placeOf(viewOn(own[0], own[1])));
      tile = own;
      return (*place)(x % m_size.nx, y % m_size.ny);
    };
    readTexels(m_image, m_image.type(), lightField, m_params.incoming, target, progress);
    return lightField;
  }

 private:
  /// The row and column of the view on a tile: a quilt has one row, from its bottom left tile on.
  [[nodiscard]] std::array<int, 2> viewOn(int row, int column) const {
    if (m_params.layout == Layout::mosaic) return {row, column};
    return {0, (m_rows - 1 - row) * m_columns + column};
  }

  LightFieldParams m_params;
  ImageFile m_image;
  int m_columns;
  int m_rows;
  LightFieldSize m_size;
};

}  // namespace

std::unique_ptr<LightFieldFile> openViews(const LightFieldParams& params,
                                          const DisplayParams& display) {
  if (isViewSequence(params.file)) return openViewSequence(params, display);
  return std::make_unique<ViewsFolder>(params, display);
}

std::unique_ptr<LightFieldFile> openQuilt(const LightFieldParams& params) {
  auto [columns, rows] = quiltTilesFromName(params.file);
  if (params.quiltColumns > 0) columns = params.quiltColumns;
  if (params.quiltRows > 0) rows = params.quiltRows;
  if (columns < 1 || rows < 1)
    throw InputError(
        params.file, "lightField.columns",
        "and rows are not given, and the file's name has no _qs{columns}x{rows}a{aspect}");
  return std::make_unique<TiledImage>(withoutOrder(params), std::array{columns, rows});
}

std::unique_ptr<LightFieldFile> openMosaic(const LightFieldParams& params,
                                           const DisplayParams& display) {
  const auto [across, down] = display.directions;
  if (across < 1 || down < 1)
    throw InputError(params.file, "display.directions",
                     "is not given: how many views the picture has across and down, such as "
                     "[15,15]");
  return std::make_unique<TiledImage>(params, display.directions);
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
