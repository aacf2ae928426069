// SPDX-License-Identifier: BSD-3-Clause
// Layouts "quilt" and "mosaic": one image of views as tiles.
#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/layouts/layouts.h"
#include "io/layouts/picture_files.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

class TiledImage : public ScatteredFile {
 public:
  /// Opens an image of `tiles` across and down; a quilt has one row of views, from its bottom left
  /// tile on.
  TiledImage(const LightFieldParams& params, const std::array<int, 2>& tiles, bool isQuilt)
      : ScatteredFile(params),
        m_image(params.file, params.yuv),
        m_columns(tiles[0]),
        m_rows(tiles[1]),
        m_isQuilt(isQuilt) {
    takeTypeOf(m_image);
    warnOf("the picture", m_image.notesOfOne());
    const auto [across, down] = tiles;
    const auto width = int(m_image.width()), height = int(m_image.height());
    if (width % across != 0 || height % down != 0)
      throw InputError(params.file, "size",
                       "is " + pairText(width, height) + " px, which does not divide into " +
                           pairText(across, down) + " views; mend " +
                           (isQuilt ? "lightField.columns and rows" : "display.directions"));
    m_size = {width / across, height / down, isQuilt ? across * down : across, isQuilt ? 1 : down};
  }

 private:
  void fill(LightField& band, int begin, const Progress& progress) override {
    const auto placeOf = [&](int row, int column) {
      return m_isQuilt ? placeOfView(m_params, m_size, 0, (m_rows - 1 - row) * m_columns + column,
                                     begin, band.size().ny)
                       : placeOfView(m_params, m_size, row, column, begin, band.size().ny);
    };
    std::array<int, 2> tile{0, 0};
    std::optional place(placeOf(0, 0));
    const auto target = [&](int x, int y) {
      const std::array own{y / m_size.ny, x / m_size.nx};
      if (own != tile) place.emplace(placeOf(own[0], own[1]));
      tile = own;
      return (*place)(x % m_size.nx, y % m_size.ny);
    };
    readTexels(m_image, band, m_params.incoming, target, progress);
  }

  ImageFile m_image;
  int m_columns;
  int m_rows;
  bool m_isQuilt;
};

std::unique_ptr<LightFieldFile> openQuilt(const LightFieldParams& params, const DisplayParams&,
                                          const Progress&) {
  const std::array<int, 2> tiles = quiltTilesOf(params);
  if (tiles[0] < 1 || tiles[1] < 1)
    throw InputError(
        params.file, "lightField.columns",
        "and rows are not given, and the file's name has no _qs{columns}x{rows}a{aspect}");
  return std::make_unique<TiledImage>(withoutOrder(params), tiles, true);
}

std::unique_ptr<LightFieldFile> openMosaic(const LightFieldParams& params,
                                           const DisplayParams& display, const Progress&) {
  if (display.directions[0] < 1 || display.directions[1] < 1)
    throw InputError(params.file, "display.directions",
                     "is not given: how many views the picture has across and down, such as "
                     "[15,15]");
  return std::make_unique<TiledImage>(params, display.directions, false);
}

/// Returns the length of a text's first digits, at most `most`.
std::size_t digitsOf(std::string_view text, std::size_t most) {
  std::size_t count = 0;
  while (count < std::min(text.size(), most) && text[count] >= '0' && text[count] <= '9') ++count;
  return count;
}

/// Takes 1 to 4 digits and a letter from the front of a text; 0 if it does not begin so.
int takeNumber(std::string_view& text, char letter) {
  const std::size_t digits = digitsOf(text, 4);
  if (digits == 0 || !text.substr(digits).starts_with(letter)) return 0;
  const int number = std::atoi(std::string(text.substr(0, digits)).c_str());
  text.remove_prefix(digits + 1);
  return number;
}

/// Whether a text is a number of at most 3 digits, and 9 behind its point; both may be missing.
bool isAspect(std::string_view text) {
  const std::string_view rest = text.substr(digitsOf(text, 3));
  return rest.empty() || (rest[0] == '.' && digitsOf(rest.substr(1), 9) == rest.size() - 1);
}

}  // namespace

/// By hand, because std::regex needs some stack for each letter, and names may be long.
QuiltName quiltNameOf(const std::string& file) {
  const std::string stem = fs::path(file).stem().string();
  const std::size_t suffix = stem.rfind("_qs");
  if (suffix == std::string::npos) return {};
  std::string_view rest = std::string_view(stem).substr(suffix + 3);
  const int columns = takeNumber(rest, 'x');
  const int rows = takeNumber(rest, 'a');
  if (columns == 0 || rows == 0 || !isAspect(rest)) return {};
  return {{columns, rows}, std::atof(std::string(rest).c_str())};
}

std::array<int, 2> quiltTilesOf(const LightFieldParams& params) {
  const auto [columns, rows] = quiltNameOf(params.file).tiles;
  return {params.quiltColumns > 0 ? params.quiltColumns : columns,
          params.quiltRows > 0 ? params.quiltRows : rows};
}

const LayoutType quiltLayout{
    .open = openQuilt,
    .isOfTiles = true,
    .isWhole = [](const LightFieldParams& params,
                  const DisplayParams&) { return quiltTilesOf(params)[0] > 0; },
    .words =
        [](const LightFieldParams& params, const DisplayParams&) {
          const auto [columns, rows] = quiltTilesOf(params);
          return "quilt of " + pairText(columns, rows) + " views";
        },
    .foundBy = [](const LightFieldParams& params) -> FoundBy {
      if (quiltNameOf(params.file).tiles[0] > 0)
        return {"the file's name", "the file's name", "lightField.columns"};
      return {"a few large tiles", "tiles in the picture", "lightField.columns"};
    }};

const LayoutType mosaicLayout{
    .open = openMosaic,
    .isOfTiles = true,
    .isWhole = [](const LightFieldParams&,
                  const DisplayParams& display) { return display.directions[0] > 0; },
    .words =
        [](const LightFieldParams&, const DisplayParams& display) {
          return "mosaic, " + std::to_string(display.directions[1]) + " rows of " +
                 std::to_string(display.directions[0]) + " views";
        },
    .foundBy = [](const LightFieldParams&) -> FoundBy {
      return {"a few large tiles with parallax along both axes", "tiles in the picture",
              "display.directions"};
    }};

}  // namespace hogelscope
