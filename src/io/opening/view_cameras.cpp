// SPDX-License-Identifier: BSD-3-Clause
#include "io/opening/view_cameras.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>

#include "capture/names/name_pattern.h"
#include "capture/names/view_grid.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "io/files/folders.h"
#include "io/layouts/layouts.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Returns the files, and folders of COLMAP's files, that may have the cameras of a folder's views.
std::vector<fs::path> cameraFilesBeside(const std::string& views) {
  fs::path folder = fs::absolute(views).lexically_normal();
  if (folder.filename().empty()) folder = folder.parent_path();  // of "views/"
  std::vector<fs::path> places{fs::path(views)};
  if (folder.filename().string().starts_with("images"))
    places.push_back((fs::path(views) / "..").lexically_normal());
  std::error_code none;
  std::vector<fs::path> files;
  for (const fs::path& place : places) {
    for (const char* name : {"transforms.json", "sparse/0"})
      if (fs::path file = (place / name).lexically_normal(); fs::exists(file, none))
        files.push_back(std::move(file));
    // Damaged ones of COLMAP are told by their names alone; reading them says that they are.
    const auto has = [&](const char* name) { return fs::exists(place / name, none); };
    const bool isNamedSo =
        (has("cameras.bin") && has("images.bin")) || (has("cameras.txt") && has("images.txt"));
    if (isNamedSo || isCameraFile(place)) files.push_back(place);
  }
  return files;
}

/// Returns the names by which a picture may be called, the most exact first: with and without its
/// folder and its ending, which some files of cameras leave out.
std::vector<std::string> namesOfPicture(std::string path) {
  std::ranges::replace(path, '\\', '/');
  const fs::path file = fs::path(path).lexically_normal();
  const std::string folder = file.parent_path().filename().string() + "/";
  const std::string name = file.filename().string(), stem = file.stem().string();
  return {folder + name, folder + stem, name, stem};
}

/// Finds cameras by the files of their pictures.
class CamerasByPicture {
 public:
  explicit CamerasByPicture(const std::vector<FileCamera>& cameras) {
    for (std::size_t k = 0; k < cameras.size(); ++k)
      for (const std::string& name : namesOfPicture(cameras[k].picture)) m_byName[name].insert(k);
  }

  /// Returns the one camera of a file; none if there is none, or there are several.
  [[nodiscard]] std::optional<std::size_t> of(const fs::path& file) const {
    for (const std::string& name : namesOfPicture(file.string()))
      if (const auto found = m_byName.find(name);
          found != m_byName.end() && found->second.size() == 1)
        return *found->second.begin();
    return std::nullopt;
  }

 private:
  std::map<std::string, std::set<std::size_t>> m_byName;
};

/// Reads the order of views from one file of cameras.
class OrderByCameras {
 public:
  OrderByCameras(const fs::path& file, const LightFieldParams& params, const DisplayParams& display,
                 bool isScanGiven)
      : m_file(file.string()), m_params(params), m_display(display), m_isScanGiven(isScanGiven) {}

  ViewCamerasSearch search() && {
    try {
      CameraFile read = readCameraFile(m_file, CameraUse::poses);
      std::erase_if(read.cameras, [](const FileCamera& camera) {
        return !camera.pose || camera.picture.empty();
      });
      m_found.hasScale = read.hasScale;
      m_found.cameras = std::move(read.cameras);
      find();
    } catch (const InputError& error) {
      m_result.lines.push_back(std::string(error.what()) + ": its cameras are not used");
    }
    return std::move(m_result);
  }

 private:
  void refuse(const std::string& why) {
    m_result.lines.push_back(m_file + ": " + why + ": not used for the order of views");
  }

  void find() {
    if (m_found.cameras.empty()) return refuse("has no poses of pictures");
    const std::optional<ViewFiles> named =
        viewsOf(m_params.pattern, m_params.scan, m_display.directions);
    if (named && !takeCamerasOf(*named)) return;
    std::vector<RigidTransform> poses;
    for (const FileCamera& camera : m_found.cameras) poses.push_back(*camera.pose);
    m_found.grid = cameraGridOf(poses);
    const CameraGrid& grid = m_found.grid;
    if (!grid.refusal.empty()) return refuse(grid.refusal);
    const auto [columns, rows] = m_display.directions;
    if (columns > 0 && (columns != grid.columns || rows != grid.rows))
      return refuse("its cameras stand in a grid of " + pairText(grid.columns, grid.rows) +
                    ", but display.directions is " + pairText(columns, rows));
    if (findReading(named)) {
      const auto isDistorted = [](const FileCamera& camera) {
        return std::ranges::any_of(camera.coefficients, [](double value) { return value != 0; });
      };
      if (std::ranges::any_of(m_found.cameras, isDistorted))
        m_result.lines.push_back(m_file +
                                 ": the views are taken for undistorted; the distortion "
                                 "of its lens is not used");
      m_result.found = std::move(m_found);
      return;
    }
    m_result.isContradicted = true;
    m_result.lines.push_back(renamingText());
  }

  /// Returns the views by these parameters; none if the names cannot be read so.
  [[nodiscard]] std::optional<ViewFiles> viewsOf(const std::string& pattern, ViewScan scan,
                                                 const std::array<int, 2>& directions) const {
    LightFieldParams params = m_params;
    params.pattern = pattern;
    params.scan = scan;
    try {
      return findViews(params, directions);
    } catch (const InputError&) {  // whoever opens the views says what is wrong
      return std::nullopt;
    }
  }

  /// Keeps the cameras of the views; false if a view has none.
  bool takeCamerasOf(const ViewFiles& views) {
    const CamerasByPicture cameras(m_found.cameras);
    std::vector<FileCamera> kept;
    const std::vector<fs::path> files = views.found();
    std::string other;
    for (const fs::path& file : files)
      if (const auto camera = cameras.of(file))
        kept.push_back(m_found.cameras[*camera]);
      else if (other.empty())
        other = file.filename().string();
    if (kept.size() < files.size()) {
      refuse("has poses of " + (kept.empty() ? "none" : std::to_string(kept.size())) + " of the " +
             std::to_string(files.size()) + " views, not of " + printable(other));
      return false;
    }
    m_found.cameras = std::move(kept);
    return true;
  }

  /// Tries the ways to read the names until the views stand as the cameras do.
  bool findReading(const std::optional<ViewFiles>& named) {
    std::vector<std::string> patterns{m_params.pattern};
    if (m_params.pattern.empty() && named)
      if (std::string other = transposedPattern(named->pattern); !other.empty())
        patterns.push_back(std::move(other));
    std::vector<ViewScan> possible{m_params.scan};
    if (!m_isScanGiven && (!named || named->isCounted))
      possible = {ViewScan::raster, ViewScan::serpentine, ViewScan::columns,
                  ViewScan::columnsSerpentine};
    const CamerasByPicture cameras(m_found.cameras);
    for (const std::string& pattern : patterns)
      for (const ViewScan scan : possible) {
        const auto views = viewsOf(pattern, scan, {m_found.grid.columns, m_found.grid.rows});
        if (!views || !fits(*views, cameras)) continue;
        m_found.pattern = pattern;
        m_found.scan = scan;
        m_found.isCounted = views->isCounted;
        if (pattern != m_params.pattern)
          m_result.lines.push_back(m_file +
                                   ": by its cameras, which are used, the numbers of rows "
                                   "in the views' names are those of columns");
        return true;
      }
    return false;
  }

  /// Whether the views stand as the cameras do, once rows or columns are reversed; sets the order.
  bool fits(const ViewFiles& views, const CamerasByPicture& cameras) {
    const CameraGrid& grid = m_found.grid;
    if (views.columns != grid.columns || views.rows != grid.rows) return false;
    std::vector<std::size_t> ofCells;
    for (const fs::path& file : views.files) {
      const auto camera = file.empty() ? std::nullopt : cameras.of(file);
      if (!camera) return false;
      ofCells.push_back(*camera);
    }
    for (const RowOrder rows : {RowOrder::topDown, RowOrder::bottomUp})
      for (const ColumnOrder columns : {ColumnOrder::leftRight, ColumnOrder::rightLeft}) {
        m_found.order = {rows, columns, m_file};
        if (isOrder(ofCells)) return true;
      }
    return false;
  }

  [[nodiscard]] bool isOrder(const std::vector<std::size_t>& ofCells) const {
    const CameraGrid& grid = m_found.grid;
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) {
        const int r = m_found.order.rows == RowOrder::topDown ? row : grid.rows - 1 - row;
        const int c =
            m_found.order.columns == ColumnOrder::leftRight ? column : grid.columns - 1 - column;
        if (ofCells[std::size_t(row * grid.columns + column)] !=
            grid.cameras[std::size_t(r * grid.columns + c)])
          return false;
      }
    return true;
  }

  /// Says that the names do not run along the grid, and how they would.
  [[nodiscard]] std::string renamingText() const {
    const CameraGrid& grid = m_found.grid;
    std::string text = m_file + ": its cameras stand in a grid of " +
                       pairText(grid.columns, grid.rows) +
                       ", along which the views' names do not run; name the views by row and "
                       "column from the top left one on:";
    constexpr std::size_t mostNamed = 3;
    const auto digits = [](std::size_t number) {
      const std::string plain = std::to_string(number);
      return std::string(plain.size() < 3 ? 3 - plain.size() : 0, '0') + plain;
    };
    for (std::size_t k = 0; k < std::min(mostNamed, grid.cameras.size()); ++k) {
      const std::string picture =
          namesOfPicture(m_found.cameras[grid.cameras[k]].picture)[2];  // without its folder
      text += (k == 0 ? " " : ", ") + printable(picture) + " is " +
              digits(k / std::size_t(grid.columns)) + "_" + digits(k % std::size_t(grid.columns));
    }
    return text + (grid.cameras.size() > mostNamed ? ", …" : "");
  }

  std::string m_file;
  const LightFieldParams& m_params;
  const DisplayParams& m_display;
  bool m_isScanGiven;
  ViewCameras m_found;
  ViewCamerasSearch m_result;
};

}  // namespace

ViewCamerasSearch findViewCameras(const LightFieldParams& params, const DisplayParams& display,
                                  bool isScanGiven) {
  ViewCamerasSearch search;
  if (params.layout != Layout::views || !isFolder(params.file)) return search;
  for (const fs::path& file : cameraFilesBeside(params.file)) {
    ViewCamerasSearch one = OrderByCameras(file, params, display, isScanGiven).search();
    if (one.found) return one;
    if (search.lines.empty()) search = std::move(one);
  }
  return search;
}

}  // namespace hogelscope
