// SPDX-License-Identifier: BSD-3-Clause
#include "io/opening/frame_folders.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <vector>

#include "core/base/error.h"
#include "core/light_field/frames.h"
#include "core/metrics/statistics.h"
#include "io/files/folders.h"
#include "io/images/image_file.h"
#include "io/layouts/layouts.h"
#include "io/opening/matched_order.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// One number in a name, and what is around it.
struct NumberedName {
  std::string before;
  std::string digits;
  std::string after;

  /// Whether a name is the same but for this number.
  [[nodiscard]] bool isLike(const std::string& name) const {
    const std::size_t around = before.size() + after.size();
    return name.size() > around && name.starts_with(before) && name.ends_with(after) &&
           name.find_first_not_of(decimals, before.size()) >= name.size() - after.size();
  }
  [[nodiscard]] std::string pattern() const { return before + std::string(frameMark) + after; }

  static constexpr const char* decimals = "0123456789";
};

/// Returns the numbers in a name, the last one first.
std::vector<NumberedName> numbersIn(const std::string& name) {
  std::vector<NumberedName> numbers;
  std::size_t end = name.find_last_of(NumberedName::decimals);
  while (end != std::string::npos) {
    const std::size_t before = name.find_last_not_of(NumberedName::decimals, end);
    const std::size_t first = before == std::string::npos ? 0 : before + 1;
    numbers.push_back(
        {name.substr(0, first), name.substr(first, end + 1 - first), name.substr(end + 1)});
    end = first == 0 ? std::string::npos : name.find_last_of(NumberedName::decimals, first - 1);
  }
  return numbers;
}

/// Entries of a folder with one name but for a number, in its order.
struct NumberedEntries {
  NumberedName name;
  std::vector<fs::path> entries;
};

/// Returns the entries that have a name but for one number, which other entries differ in, too;
/// none if there are no others, or if these differ in two numbers of the name.
std::optional<NumberedEntries> numberedAs(const std::string& name,
                                          const std::vector<fs::path>& entries) {
  std::optional<NumberedEntries> found;
  for (const NumberedName& own : numbersIn(name)) {
    NumberedEntries alike{own, {}};
    std::ranges::copy_if(entries, std::back_inserter(alike.entries), [&](const fs::path& entry) {
      return own.isLike(entry.filename().string());
    });
    if (alike.entries.size() < 2) continue;
    if (found) return std::nullopt;
    found = std::move(alike);
  }
  if (!found) return found;
  const std::size_t before = found->name.before.size(), around = before + found->name.after.size();
  std::ranges::sort(found->entries, {}, [&](const fs::path& path) {
    const std::string own = path.filename().string();
    return std::pair(own.size(), own.substr(before, own.size() - around));
  });
  return found;
}

/// Returns the folders in a folder, or the files that are not hidden, if all have one name but for
/// a number.
std::optional<NumberedEntries> allNumbered(const fs::path& folder, bool areFolders) {
  std::vector<fs::path> entries = entriesOf(folder);
  std::erase_if(entries, [areFolders](const fs::path& entry) {
    return entry.filename().string().front() == '.' || isFolder(entry) != areFolders;
  });
  if (entries.empty()) return std::nullopt;
  auto found = numberedAs(entries.front().filename().string(), entries);
  if (found && found->entries.size() != entries.size()) return std::nullopt;
  return found;
}

LightFieldParams viewsIn(const fs::path& folder) {
  LightFieldParams params;
  params.file = folder.string();
  params.layout = Layout::views;
  return params;
}

/// Returns the correlation of the middle view's pictures in two folders; NaN if one is even.
double likenessOf(const fs::path& a, const fs::path& b, const Progress& progress) {
  std::vector<std::vector<double>> pictures;
  for (const fs::path& folder : {a, b}) {
    SmallViews views(viewsIn(folder), DisplayParams());
    const auto middle = views.pictureOf(viewsIn(folder), views.columns() / 2, views.rows() / 2);
    if (!middle) return unknownFigure;
    views.read({*middle}, progress);
    const SmallPicture& picture = views.at(*middle);
    pictures.emplace_back(picture.values.begin(), picture.values.end());
  }
  if (pictures[0].size() != pictures[1].size()) return unknownFigure;
  return correlation(pictures[0], pictures[1]);
}

/// Returns the correlation of two pictures' values on a grid of points; NaN if one is even, or too
/// large to be read for a guess.
double likenessOfPictures(const fs::path& a, const fs::path& b, const Progress& progress) {
  std::vector<std::vector<double>> pictures;
  std::vector<std::array<std::size_t, 2>> sizes;
  for (const fs::path& path : {a, b}) {
    ImageFile file(path);
    constexpr double mostPixels = 1e8;  // a few seconds
    if (double(file.width()) * double(file.height()) > mostPixels) return unknownFigure;
    sizes.push_back({file.width(), file.height()});
    constexpr std::size_t points = 512;  // along an axis
    const std::size_t step = std::max(file.width(), file.height()) / points + 1;
    std::vector<double>& values = pictures.emplace_back();
    file.readRows(
        [&](std::size_t y, const float* rgb) {
          for (std::size_t x = 0; y % step == 0 && x < file.width(); x += step)
            values.push_back(rgb[3 * x] + rgb[3 * x + 1] + rgb[3 * x + 2]);
        },
        progress);
  }
  return sizes[0] == sizes[1] ? correlation(pictures[0], pictures[1]) : unknownFigure;
}

/// Returns the likeness of the first two frames if all are grids of views, each in a folder.
double likenessOfGrids(const std::vector<fs::path>& folders, const Progress& progress) {
  const ViewFiles first = findViews(viewsIn(folders.front()), {0, 0});
  const ViewFiles last = findViews(viewsIn(folders.back()), {0, 0});
  const bool isGrid = first.rows > 1 && first.columns > 1 && !first.isCounted;
  const bool isSame = first.rows == last.rows && first.columns == last.columns;
  return isGrid && isSame ? likenessOf(folders[0], folders[1], progress) : unknownFigure;
}

constexpr double alike = 0.9, similar = 0.5;  // correlations of two frames

}  // namespace

std::optional<FoundFrames> framesInFolder(const std::string& folder, const Progress& progress) {
  if (!isFolder(folder)) return std::nullopt;
  try {
    if (const auto found = allNumbered(folder, true)) {
      const double likeness = likenessOfGrids(found->entries, progress);
      if (!(likeness > similar)) return std::nullopt;
      return FoundFrames{(fs::path(folder) / found->name.pattern()).string(),
                         likeness > alike ? Sureness::sure : Sureness::likely};
    }
    const auto found = allNumbered(folder, false);
    if (!found || quiltNameOf(found->entries.front().string()).tiles[0] == 0) return std::nullopt;
    if (!(likenessOfPictures(found->entries[0], found->entries[1], progress) > alike))
      return std::nullopt;
    return FoundFrames{(fs::path(folder) / found->name.pattern()).string(), Sureness::likely};
  } catch (const InputError&) {
    return std::nullopt;  // said by whoever opens the folder
  }
}

std::string framesBeside(const std::string& file, const Progress& progress) {
  try {
    const fs::path path(file);
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const auto found = numberedAs(path.filename().string(), entriesOf(folder));
    if (!found) return {};
    const auto at = std::ranges::find(found->entries, path.filename(), &fs::path::filename);
    const auto next = at + 1 < found->entries.end() ? at + 1 : at - 1;
    if (!(likenessOfPictures(path, *next, progress) > alike)) return {};
    const auto others = found->entries.size() - 1;
    return std::to_string(others) + (others == 1 ? " picture has" : " pictures have") +
           " this name but for its number, and the next one is like it: if they are frames, open " +
           (path.parent_path() / found->name.pattern()).string();
  } catch (const InputError&) {
    return {};  // said by whoever opens the file
  }
}

}  // namespace hogelscope
