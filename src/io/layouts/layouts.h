// SPDX-License-Identifier: BSD-3-Clause
// The layouts of light fields in pictures and videos. A file for each of them has its reader and
// its row of the table; io/scene/view_source.h has the table, with the rows of stores and live
// scenes.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "capture/lenslets/lenslet_search.h"
#include "capture/names/view_grid.h"
#include "core/panel/display.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// What a light field is in: one picture, a folder or a file of views, a store, a 3-D scene.
enum class Holder { picture, views, store, scene };

/// What tells a layout and its size where nobody has said them, in words.
struct FoundBy {
  const char* layout = "the file says it";
  const char* size = "the file says it";
  const char* field = "";  ///< what says the size, such as "display.directions"
};

/// What those who open light fields know of a layout.
struct LayoutType {
  /// Opens one. Throws InputError that names the file or folder: missing, damaged, or not the
  /// display's size; Cancelled.
  std::unique_ptr<LightFieldFile> (*open)(const LightFieldParams& params,
                                          const DisplayParams& display, const Progress& progress);
  Holder holder = Holder::picture;
  bool isOfTiles = false;  ///< of views
  /// Whether file, parameters and display say how many hogels and directions there are.
  bool (*isWhole)(const LightFieldParams& params, const DisplayParams& display) =
      [](const LightFieldParams&, const DisplayParams&) { return true; };
  /// Returns "quilt of 8×6 views" and the like, of one that is whole; null unless it is a picture.
  std::string (*words)(const LightFieldParams& params, const DisplayParams& display) = nullptr;
  FoundBy (*foundBy)(const LightFieldParams& params) = [](const LightFieldParams&) {
    return FoundBy{};
  };
};

/// One image of hogel tiles, (i·du + u, j·dv + v).
extern const LayoutType hogelsLayout;
/// A folder or %-pattern of images; frames of a video, which count row by row
/// (LightFieldParams::scan); the data set of HDF5 (openHdf5).
extern const LayoutType viewsLayout;
/// One image of a row of views, as tiles row by row from the bottom left.
extern const LayoutType quiltLayout;
/// One image of a grid of views, as many tiles as the display has directions, in the order of the
/// parameters.
extern const LayoutType mosaicLayout;
/// A picture taken through an array of lenslets, by a plenoptic camera or a light field microscope.
/// Lenslets are hogels, pixels under a lenslet are directions.
extern const LayoutType lensletsLayout;

/// Finds a folder's views, and reads their row and column from the file names. `directions`
/// (columns, rows; 0 = not known) say how one running number counts. Without a pattern the known
/// ones are tried, then the largest series of pictures whose names agree in all but their numbers.
/// Where no name fits but there is a folder 0, that of a JPEG Pleno light field's first components,
/// it is looked at. Throws InputError: no folder, no match, half of the views or more are missing.
ViewFiles findViews(const LightFieldParams& params, std::array<int, 2> directions);

/// Whether a file has views as its frames: a video by its name, or HDF5 by its first bytes.
bool isViewSequence(const std::string& file);

/// The columns and rows in a quilt's name (…_qs8x6a0.75.png), and the display's width in heights; 0
/// where there are none.
struct QuiltName {
  std::array<int, 2> tiles{0, 0};
  double aspect = 0;
};
QuiltName quiltNameOf(const std::string& file);

/// Returns the columns and rows of a quilt that parameters or name say; 0 where they do not.
std::array<int, 2> quiltTilesOf(const LightFieldParams& params);

/// Finds the lenslets of a picture of that layout; their lattice begins at hogel (0, 0). Throws
/// what opening it throws.
FoundLenslets lensletsOf(const LightFieldParams& params, const DisplayParams& display,
                         const Progress& progress = {});

/// Returns a line for the user if the lenslets do not lie on the lattice that was found, or its
/// rows hardly run along the picture's; else "".
std::string warningOf(const LightFieldParams& params, const FoundLenslets& found);

}  // namespace hogelscope
