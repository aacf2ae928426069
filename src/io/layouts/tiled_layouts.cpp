// SPDX-License-Identifier: BSD-3-Clause
// Layouts "quilt" and "mosaic": one image of views as tiles.
#include <algorithm>
#include <cctype>
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
  /// Opens an image of `tiles` across and down; a quilt has one row of views. What a quilt's tiles
  /// leave over is at its right and opposite to its first row, as the vendor's software has it for
  /// the sides of its own presets, such as 5×9 views in 4096×4096 px.
  TiledImage(const LightFieldParams& params, const std::array<int, 2>& tiles, bool isQuilt)
      : ScatteredFile(params),
        m_image(params.file, params.yuv),
        m_columns(tiles[0]),
        m_rows(tiles[1]),
        m_isQuilt(isQuilt) {
    takeTypeOf(m_image);
    takeFramesOf(m_image);
    warnOf("the picture", m_image.notesOfOne());
    const auto [across, down] = tiles;
    const auto width = int(m_image.width()), height = int(m_image.height());
    const bool isDivided = width % across == 0 && height % down == 0;
    if (width < across || height < down || (!isDivided && !isQuilt))
      throw InputError(params.file, "size",
                       "is " + pairText(width, height) + " px, which does not divide into " +
                           pairText(across, down) + " views; mend " +
                           (isQuilt ? "lightField.columns and rows" : "display.directions"));
    m_size = {width / across, height / down, isQuilt ? across * down : across, isQuilt ? 1 : down};
    const bool isUpwards = params.quiltStart == QuiltStart::bottomLeft;
    if (isUpwards) m_top = height % down;
    if (!isDivided)
      m_warnings.push_back("views are " + pairText(m_size.nx, m_size.ny) + " px from the " +
                           (isUpwards ? "bottom" : "top") + " left: " + pairText(width, height) +
                           " px are no multiple of " + pairText(across, down) + " views, " +
                           std::to_string(width % across) + " px at the right and " +
                           std::to_string(height % down) + " px at the " +
                           (isUpwards ? "top" : "bottom") + " are left out");
  }

 private:
  void fill(LightField& band, int begin, const Progress& progress) override {
    const auto placeOf = [&](int row, int column) {
      if (!m_isQuilt) return placeOfView(m_params, m_size, row, column, begin, band.size().ny);
      const int line = m_params.quiltStart == QuiltStart::bottomLeft ? m_rows - 1 - row : row;
      return placeOfView(m_params, m_size, 0, line * m_columns + column, begin, band.size().ny);
    };
    std::array<int, 2> tile{0, 0};
    std::optional place(placeOf(0, 0));
    const auto target = [&](int x, int y) -> std::optional<TexelIndex> {
      const std::array own{(y - m_top) / m_size.ny, x / m_size.nx};
      if (y < m_top || own[0] >= m_rows || own[1] >= m_columns) return std::nullopt;
      if (own != tile) place.emplace(placeOf(own[0], own[1]));
      tile = own;
      return (*place)(x % m_size.nx, (y - m_top) % m_size.ny);
    };
    m_image.select(frame());
    readTexels(m_image, band, m_params.incoming, target, progress);
  }

  ImageFile m_image;
  int m_columns;
  int m_rows;
  bool m_isQuilt;
  int m_top = 0;  ///< rows of pixels above the tiles
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

bool isWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/// Takes a number of 1 to 4 digits from the front of a text; 0 if it does not begin with one.
int takeNumber(std::string_view& text) {
  const std::size_t digits = digitsOf(text, 5);
  if (digits == 0 || digits > 4) return 0;
  const int number = std::atoi(std::string(text.substr(0, digits)).c_str());
  text.remove_prefix(digits);
  return number;
}

/// Takes an aspect from the front of a text: at most 3 digits, and 9 behind a point or comma; both
/// may be missing. A point without digits behind it is not of the aspect.
double takeAspect(std::string_view& text) {
  std::size_t end = digitsOf(text, 3);
  const bool hasPoint = end < text.size() && (text[end] == '.' || text[end] == ',');
  const std::size_t fraction = hasPoint ? digitsOf(text.substr(end + 1), 9) : 0;
  if (fraction > 0) end += 1 + fraction;
  std::string number(text.substr(0, end));
  std::ranges::replace(number, ',', '.');
  text.remove_prefix(end);
  return numberOf(number).value_or(0);
}

/// Reads what stands behind "qs": 8x6a0.75 or 8x6, and then nothing that continues the word, as
/// people and file managers add "_v2" or " (1)"; 0 tiles for anything else.
QuiltName tilesAt(std::string_view rest) {
  const int columns = takeNumber(rest);
  if (columns == 0 || !rest.starts_with('x')) return {};
  rest.remove_prefix(1);
  const int rows = takeNumber(rest);
  if (rows == 0) return {};
  double aspect = 0;
  if (rest.starts_with('a')) {
    rest.remove_prefix(1);
    aspect = takeAspect(rest);
  }
  if (!rest.empty() && isWord(rest[0])) return {};
  return {{columns, rows}, aspect};
}

}  // namespace

/// By hand, because std::regex needs some stack for each letter, and names may be long.
QuiltName quiltNameOf(const std::string& file) {
  const std::string stem = lowerCase(fs::path(file).stem().string());
  const std::string_view text = stem;
  for (std::size_t at = text.rfind("qs"); at != text.npos; at = text.rfind("qs", at - 1)) {
    const bool isOwn = at == 0 || !isWord(text[at - 1]);
    const QuiltName name = isOwn ? tilesAt(text.substr(at + 2)) : QuiltName();
    if (name.tiles[0] > 0 || at == 0) return name;
  }
  return {};
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
          return "quilt of " + pairText(columns, rows) + " views" +
                 (params.quiltStart == QuiltStart::topLeft ? ", from the top left" : "");
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
