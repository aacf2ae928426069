// SPDX-License-Identifier: BSD-3-Clause
// The layouts of light fields in images and videos. Each has a file with its reader and its row of
// the table; io/scene/view_source.h has the table, with the rows of stores and live scenes.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "capture/lenslets/lenslet_search.h"
#include "capture/names/view_grid.h"
#include "core/panel/display.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// The kind of file that a light field is in: one image, a folder or a file of views, a store, a
/// 3-D scene.
enum class Holder { picture, views, store, scene };

/// The sources of a layout and its size if they are not given, in words.
struct FoundBy {
  const char* layout = "the file says it";
  const char* size = "the file says it";
  const char* field = "";  ///< the field that gives the size, such as "display.directions"
};

/// The properties of a layout that are needed to open light fields.
struct LayoutType {
  /// Opens a light field. Throws InputError that names the file or folder (missing, damaged, or not
  /// of the display's size); Cancelled.
  std::unique_ptr<LightFieldFile> (*open)(const LightFieldParams& params,
                                          const DisplayParams& display, const Progress& progress);
  Holder holder = Holder::picture;
  bool isOfTiles = false;  ///< tiles that are views
  /// Whether file, parameters and display determine the numbers of hogels and directions.
  bool (*isWhole)(const LightFieldParams& params, const DisplayParams& display) =
      [](const LightFieldParams&, const DisplayParams&) { return true; };
  /// Returns a text such as "quilt of 8×6 views" for one that is whole; null unless it is one
  /// image.
  std::string (*words)(const LightFieldParams& params, const DisplayParams& display) = nullptr;
  FoundBy (*foundBy)(const LightFieldParams& params) = [](const LightFieldParams&) {
    return FoundBy{};
  };
};

/// One image of hogel tiles, (i·du + u, j·dv + v); for a lens sheet, of its panel's pixels.
extern const LayoutType hogelsLayout;
/// A folder or %-pattern of images; frames of a video or pages of a TIFF, counted as
/// LightFieldParams::scan says; a data set of HDF5 (openHdf5).
extern const LayoutType viewsLayout;
/// One image of a row of views, as tiles row by row from the bottom left, or from the top left
/// (LightFieldParams::quiltStart).
extern const LayoutType quiltLayout;
/// One image of a grid of views, as many tiles as the display has directions, in the order of the
/// parameters.
extern const LayoutType mosaicLayout;
/// An image taken through an array of lenslets, by a plenoptic camera or a light field microscope.
/// Lenslets are hogels, pixels under a lenslet are directions.
extern const LayoutType lensletsLayout;

/// Finds a folder's views, and reads their row and column from the file names. `directions`
/// (columns, rows; 0 = not known) give the grid of a running number. Without a pattern the known
/// ones are tried, then the largest series of images whose names agree in all but their numbers. If
/// no name fits and there is a folder 0, that of a JPEG Pleno light field's first components, it is
/// searched. Throws InputError (no folder, no match, half of the views or more missing).
ViewFiles findViews(const LightFieldParams& params, std::array<int, 2> directions);

/// Whether a file of layout "views" has views as its frames: a video by its first bytes or its
/// name, raw YUV by its name, HDF5 by its first bytes, or a TIFF of several pages that are alike.
bool isViewSequence(const std::string& file);

/// The columns and rows in a quilt's name (…_qs8x6a0.75.png), and the display's width / height; 0
/// if there are none. In any case, with a comma for the point, without the aspect, and with what
/// people and file managers add behind it: "_v2", " (1)", a frame's number.
struct QuiltName {
  std::array<int, 2> tiles{0, 0};
  double aspect = 0;
};
QuiltName quiltNameOf(const std::string& file);

/// Returns the columns and rows of a quilt from its parameters or its name; 0 if neither has them.
std::array<int, 2> quiltTilesOf(const LightFieldParams& params);

/// Finds the lenslets of an image of this layout; the lattice's origin is hogel (0, 0). Throws what
/// LayoutType::open throws.
FoundLenslets lensletsOf(const LightFieldParams& params, const DisplayParams& display,
                         const Progress& progress = {});

/// Returns a warning if the lenslets lie more than 0.5 px (rms) off the lattice, or its rows are
/// turned by more than 10°; otherwise "".
std::string warningOf(const LightFieldParams& params, const FoundLenslets& found);

}  // namespace hogelscope
