// SPDX-License-Identifier: BSD-3-Clause
#include "io/opening/grey_views.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "io/files/system_limits.h"
#include "io/images/image_file.h"
#include "io/images/image_inputs.h"
#include "io/layouts/picture_files.h"
#include "io/scene/view_source.h"

namespace hogelscope {

namespace {

template <class T>
std::uint8_t greyOf(const T* rgb) {
  constexpr double full = std::is_floating_point_v<T> ? 1.0 : double(std::numeric_limits<T>::max());
  const double luma = 0.299 * double(rgb[0]) + 0.587 * double(rgb[1]) + 0.114 * double(rgb[2]);
  return std::uint8_t(std::lround(std::clamp(luma / full, 0.0, 1.0) * 255));
}

GreyPicture readGrey(const std::filesystem::path& file, const YuvParams& yuv,
                     const Progress& progress = {}) {
  ImageFile image(file, yuv);
  GreyPicture picture{int(image.width()), int(image.height()), {}};
  checkFits(double(image.width() * image.height()), file);
  picture.values.reserve(image.width() * image.height());
  const auto take = [&](std::size_t, std::size_t rows, const StoredRows& values) {
    const auto addAll = [&](const auto* rgb) {
      for (std::size_t k = 0; k < rows * image.width(); ++k, rgb += 3)
        picture.values.push_back(greyOf(rgb));
    };
    std::visit(addAll, values);
  };
  image.read(image.type(), take, progress);
  return picture;
}

FloatImage readColours(const std::filesystem::path& file, const YuvParams& yuv,
                       const Progress& progress) {
  ImageFile image(file, yuv);
  checkFits(double(3 * sizeof(float) * image.width() * image.height()), file);
  FloatImage picture(int(image.width()), int(image.height()));
  auto to = picture.rgb.begin();
  image.readRows(
      [&](std::size_t, const float* rgb) {
        to = std::transform(rgb, rgb + 3 * image.width(), to, [](float v) { return 255 * v; });
      },
      progress);
  return picture;
}

/// Returns the view, or `like` if the sizes differ: that is an error when all views are read.
GreyPicture fitted(GreyPicture picture, const GreyPicture& like) {
  if (picture.width != like.width || picture.height != like.height) return like;
  return picture;
}

GreyViews viewsOfFolder(const LightFieldParams& params, const DisplayParams& display) {
  const auto files = std::make_shared<const ViewFiles>(findViews(params, display.directions));
  GreyViews views;
  views.columnsFromTo = files->columnsFromTo;
  views.rowsFromTo = files->rowsFromTo;
  views.isCounted = files->isCounted;
  views.isLoose = files->isLoose;
  for (const std::string& line : {files->missing, files->surplus})
    if (!line.empty()) views.warnings.push_back(line);
  const auto first =
      std::make_shared<const GreyPicture>(readGrey(files->found().front(), params.yuv));
  views.pattern = files->pattern;
  views.grid = {files->rows, files->columns, [files, first, yuv = params.yuv](int row, int column) {
                  const auto at =
                      std::size_t(row) * std::size_t(files->columns) + std::size_t(column);
                  return fitted(readGrey(files->files[at], yuv), *first);
                }};
  views.colours = [files, yuv = params.yuv](int row, int column, const Progress& progress) {
    const auto at = std::size_t(row) * std::size_t(files->columns) + std::size_t(column);
    return readColours(files->files[at], yuv, progress);
  };
  if (!files->missing.empty())
    for (const auto& file : files->files) views.grid.isMissing.push_back(file.empty());
  return views;
}

/// Returns a tile of those that begin `top` rows of pixels below the image's top.
GreyPicture tileOf(const GreyPicture& image, int top, int width, int height, int column, int row) {
  GreyPicture tile{width, height, {}};
  tile.values.reserve(std::size_t(width) * std::size_t(height));
  for (int y = 0; y < height; ++y) {
    const auto from = image.values.begin() +
                      (top + std::ptrdiff_t(row) * height + y) * image.width +
                      std::ptrdiff_t(column) * width;
    tile.values.insert(tile.values.end(), from, from + width);
  }
  return tile;
}

/// Whether nothing is in a tile: it is black but for a codec's noise.
bool isEmpty(const GreyPicture& tile) {
  constexpr std::uint8_t black = 4;
  return std::ranges::max(tile.values) <= black;
}

/// Marks the tiles that are empty, which have no motion, and tells of them.
void markEmpty(GreyViews& views) {
  const auto count = std::size_t(views.grid.rows) * std::size_t(views.grid.columns);
  std::vector<bool> empty;
  std::string names;
  std::size_t found = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const auto row = int(k / std::size_t(views.grid.columns));
    empty.push_back(isEmpty(views.grid.view(row, int(k % std::size_t(views.grid.columns)))));
    if (!empty.back()) continue;
    constexpr std::size_t mostNamed = 8;
    if (found++ < mostNamed) names += (names.empty() ? "" : ", ") + std::to_string(k);
    if (found == mostNamed + 1) names += ", …";
  }
  if (found == 0 || found == count) return;
  views.grid.isMissing = std::move(empty);
  views.warnings.push_back("lightField: " + std::to_string(found) + " of " + std::to_string(count) +
                           " tiles are empty and shown black: view" + (found > 1 ? "s " : " ") +
                           names + ", counted from 0");
}

/// Returns a mosaic's grid, or a quilt's one row of views.
GreyViews viewsOfTiles(const LightFieldParams& params, const LightFieldSize& size,
                       const Progress& progress) {
  const auto image =
      std::make_shared<const GreyPicture>(readGrey(params.file, params.yuv, progress));
  const auto [columns, rows] =
      params.layout == Layout::mosaic ? std::array{size.du, size.dv} : quiltTilesOf(params);
  const bool isUpwards = params.quiltStart == QuiltStart::bottomLeft;
  const int top = isUpwards ? image->height - rows * size.ny : 0;
  GreyViews views;
  views.grid = {rows, columns, [=](int row, int column) {
                  return tileOf(*image, top, size.nx, size.ny, column, row);
                }};
  if (params.layout == Layout::quilt) {
    views.tiles = views.grid;
    views.grid = {
        1, size.du,
        [isUpwards, rows = rows, columns = columns, tile = views.grid.view](int, int view) {
          const int line = view / columns;
          return tile(isUpwards ? rows - 1 - line : line, view % columns);
        }};
  }
  markEmpty(views);
  return views;
}

FloatImage coloursOf(const LightField& lightField, int v, int u) {
  const LightFieldSize size = lightField.size();
  FloatImage picture(size.nx, size.ny);
  auto to = picture.rgb.begin();
  for (int j = 0; j < size.ny; ++j)
    for (int i = 0; i < size.nx; ++i) {
      const Rgb colour = lightField.texel({i, j, u, v});
      for (const double value : {colour.r, colour.g, colour.b}) *to++ = float(value);
    }
  return picture;
}

/// Returns the views of a light field that is read whole.
GreyViews viewsInMemory(LightFieldFile& file, const Progress& progress) {
  const auto lightField = std::make_shared<const LightField>(file.read(progress));
  const LightFieldSize size = lightField->size();
  GreyViews views;
  views.grid = {size.dv, size.du, [lightField, size](int v, int u) {
                  GreyPicture picture{size.nx, size.ny, {}};
                  const FloatImage colours = coloursOf(*lightField, v, u);
                  for (auto at = colours.rgb.begin(); at != colours.rgb.end(); at += 3) {
                    const std::array rgb{at[0] / 255, at[1] / 255, at[2] / 255};
                    picture.values.push_back(greyOf(rgb.data()));
                  }
                  return picture;
                }};
  views.colours = [lightField](int v, int u, const Progress&) {
    return coloursOf(*lightField, v, u);
  };
  return views;
}

/// Adds the colours of an image of tiles, which is read whole for the first of them.
void addColours(GreyViews& views, std::shared_ptr<LightFieldFile> file) {
  views.colours = [file = std::move(file), lightField = std::shared_ptr<const LightField>()](
                      int v, int u, const Progress& progress) mutable {
    if (!lightField) lightField = std::make_shared<const LightField>(file->read(progress));
    return coloursOf(*lightField, v, u);
  };
}

}  // namespace

std::optional<GreyViews> greyViewsOf(const LightFieldParams& params, const DisplayParams& display,
                                     const Progress& progress) {
  if (params.isLive()) return std::nullopt;
  if (params.layout == Layout::views && !isViewSequence(params.file))
    return viewsOfFolder(params, display);
  LightFieldParams asStored = withoutOrder(params);
  asStored.incoming = false;
  // Tiles are views of the file itself, also where a lens sheet weaves them into one picture.
  const bool isWoven = display.sheet && typeOf(params.layout).isOfTiles;
  auto file = openLightField(asStored, isWoven ? DisplayParams() : display);
  const LightFieldSize size = file->size();
  constexpr double mostPixels = 3e8;  // a few seconds
  if (double(size.width()) * double(size.height()) > mostPixels) return std::nullopt;
  const bool isSmall = fitsInMemory(*file, allowedMemory());
  if (typeOf(params.layout).isOfTiles) {
    GreyViews views = viewsOfTiles(params, size, progress);
    if (isSmall) addColours(views, std::move(file));
    return views;
  }
  if (!isSmall) return std::nullopt;
  GreyViews views = viewsInMemory(*file, progress);
  views.isCounted = params.layout == Layout::views && !isHdf5(params.file);
  return views;
}

}  // namespace hogelscope
