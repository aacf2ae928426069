// SPDX-License-Identifier: BSD-3-Clause
// Finds a folder's views and reads their row and column from the file names.
#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <tuple>

#include "capture/names/name_pattern.h"
#include "capture/names/name_series.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "io/files/folders.h"
#include "io/images/image_file.h"
#include "io/layouts/layouts.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

std::vector<NamedView> matches(const fs::path& folder, const std::vector<fs::path>& files,
                               const NamePattern& pattern) {
  const bool isOfCoordinates = pattern.meaning().find_first_of("RCN") == std::string::npos;
  std::vector<NamedView> views;
  for (const fs::path& file : files) {
    const auto numbers = numbersIn(nameBelow(folder, file), pattern);
    if (!numbers) continue;
    const NamedView view = viewNamed(file, *numbers);
    if (!isOfCoordinates || view.x || view.y) views.push_back(view);
  }
  return views;
}

bool isExcluded(const std::string& name, const std::string& exclude) {
  for (std::size_t begin = 0; begin <= exclude.size();) {
    const std::size_t end = std::min(exclude.find(';', begin), exclude.size());
    if (::fnmatch(exclude.substr(begin, end - begin).c_str(), name.c_str(), 0) == 0) return true;
    begin = end + 1;
  }
  return false;
}

/// Returns the files that may be views, in the folder or, if `depth` is more than 0, in its
/// folders: neither folders nor hidden files.
std::vector<fs::path> candidatesIn(const fs::path& folder, const LightFieldParams& params,
                                   std::size_t depth = 0) {
  std::vector<fs::path> folders{folder};
  for (; depth > 0; --depth) {
    std::vector<fs::path> inside;
    for (const fs::path& outer : folders)
      for (fs::path& entry : entriesOf(outer))
        if (entry.filename().string().front() != '.' && isFolder(entry))
          inside.push_back(std::move(entry));
    folders = std::move(inside);
  }
  std::vector<fs::path> files;
  for (const fs::path& inner : folders)
    for (fs::path& file : filesIn(inner)) {
      const std::string name = file.filename().string();
      if (name.front() != '.' && !isExcluded(name, params.exclude))
        files.push_back(std::move(file));
    }
  return files;
}

void checkFolder(const fs::path& folder) {
  std::error_code error;
  const fs::file_type type = fs::status(folder, error).type();
  if (type == fs::file_type::none)
    throw InputError(folder.string(), "cannot be read", error.message());
  if (type != fs::file_type::directory)
    throw InputError(folder.string(), "",
                     type == fs::file_type::not_found
                         ? "there is no such folder"
                         : "is a file; layout \"views\" reads a folder");
}

/// Returns a text such as "a.png and 3 more files are there".
std::string thereText(const std::vector<fs::path>& files) {
  if (files.empty()) return "the folder has no files that could be views";
  const std::size_t others = files.size() - 1;
  return files.front().filename().string() +
         (others == 0   ? " is"
          : others == 1 ? " and 1 more file are"
                        : " and " + std::to_string(others) + " more files are") +
         " there";
}

struct KnownNames {
  const char* pattern;
  bool isExact;  ///< no other names have this form
};

/// Names of Stanford without and with the last underscore, HCI, JPEG Pleno, light-field-renderer.
constexpr std::array<KnownNames, 5> knownNames{{{"out_RR_CC_y_x", true},
                                                {"out_RR_CC_y_x_", true},
                                                {"input_CamNNN", true},
                                                {"RRR_CCC", true},
                                                {"*_RR_CC_y_x_*", false}}};

/// The evidence that a series is the views.
struct Claim {
  NameSeries series;
  const KnownNames* known = nullptr;
  bool isOfOtherData = false;  ///< such as depth maps

  bool operator<(const Claim& other) const {
    const auto rank = [](const Claim& claim) {
      return std::tuple(claim.known == nullptr || !claim.known->isExact,
                        -std::ptrdiff_t(claim.series.files.size()), claim.isOfOtherData);
    };
    return rank(*this) < rank(other);
  }
};

bool isOfOtherData(const NameParts& parts) {
  for (std::size_t k = 0; k < parts.size(); k += 2)
    for (const char* word : {"depth", "disp", "mask", "normal", "thumb", ".pfm"})
      if (parts[k].find(word) != std::string::npos) return true;
  return false;
}

std::vector<Claim> claimsOf(const fs::path& folder, const std::vector<fs::path>& files) {
  std::vector<Claim> claims;
  for (NameSeries& series : seriesOf(folder, files)) {
    const bool isOther = isOfOtherData(series.parts.front());
    Claim claim{std::move(series), nullptr, isOther};
    for (const KnownNames& known : knownNames) {
      const NamePattern pattern = namePattern(known.pattern);
      const auto fits = [&](const fs::path& file) {
        return numbersIn(nameBelow(folder, file), pattern).has_value();
      };
      if (claim.known == nullptr &&
          std::all_of(claim.series.files.begin(), claim.series.files.end(), fits))
        claim.known = &known;
    }
    if (claim.known != nullptr || claim.series.files.size() > 1) claims.push_back(std::move(claim));
  }
  std::stable_sort(claims.begin(), claims.end());
  return claims;
}

/// Throws InputError unless a series' files are images; one of them may be damaged.
void checkArePictures(const std::vector<fs::path>& files, const YuvParams& yuv) {
  try {
    const ImageFile first(files.front(), yuv);
  } catch (const InputError&) {
    if (files.size() == 1) throw;
    const ImageFile middle(files[files.size() / 2], yuv);
  }
}

using PictureSize = std::array<std::size_t, 2>;

/// Returns the size of an image, {0, 0} if the file cannot be read.
PictureSize sizeOf(const fs::path& file, const YuvParams& yuv) {
  try {
    const ImageFile image(file, yuv);
    return {image.width(), image.height()};
  } catch (const InputError&) {
    return {0, 0};
  }
}

struct SizedSeries {
  PictureSize size{0, 0};  ///< {0, 0} if its pictures have several sizes, one of them once
  NameSeries series;
};

/// Splits a series of images of several sizes, such as view_512_07 and view_128_07. The wider ones
/// come first if there are a third as many of them as of any other: of each there may be several
/// thumbnails. If a size occurs only once, the series stays whole,
/// because that file is an error.
std::vector<SizedSeries> seriesOfOneSize(NameSeries series, const YuvParams& yuv) {
  const std::vector<fs::path>& files = series.files;
  const std::size_t count = files.size();
  const PictureSize first = sizeOf(files.front(), yuv);
  constexpr std::size_t mostRead = 5000;  // whose sizes are read in a moment
  if (count < 4 || count > mostRead ||
      (first == sizeOf(files[count / 2], yuv) && first == sizeOf(files.back(), yuv)))
    return {{first, std::move(series)}};
  std::map<PictureSize, NameSeries> ofSize;
  for (std::size_t k = 0; k < count; ++k) {
    NameSeries& own = ofSize[sizeOf(files[k], yuv)];
    own.files.push_back(files[k]);
    own.parts.push_back(series.parts[k]);
  }
  std::vector<SizedSeries> result;
  std::size_t most = 0;
  for (auto& [size, own] : ofSize) {
    if (size == PictureSize{0, 0} || own.files.size() < 2) return {{first, std::move(series)}};
    most = std::max(most, own.files.size());
    result.insert(result.begin(), {size, std::move(own)});  // so the widest come first
  }
  std::stable_partition(result.begin(), result.end(), [most](const SizedSeries& one) {
    return 3 * one.series.files.size() >= most;
  });
  return result;
}

/// Finds the first series that forms a grid of images; otherwise keeps the first error.
class SeriesSearch {
 public:
  SeriesSearch(const std::vector<fs::path>& files, const LightFieldParams& params,
               GridSource source)
      : m_files(files), m_yuv(params.yuv), m_source(std::move(source)) {}

  std::optional<ViewFiles> find() {
    for (Claim& claim : claimsOf(m_source.folder, m_files)) {
      const std::vector<SizedSeries> ofSizes = seriesOfOneSize(std::move(claim.series), m_yuv);
      for (const auto& [size, series] : ofSizes)
        if (auto grid = gridIn(series, claim.known)) {
          for (const SizedSeries& other : ofSizes)
            if (other.size != size)
              grid->otherSizes += (grid->otherSizes.empty() ? "" : ", ") +
                                  std::to_string(other.series.files.size()) + " pictures of " +
                                  pairText(other.size[0], other.size[1]) + " px";
          return grid;
        }
    }
    return std::nullopt;
  }

  [[nodiscard]] const std::optional<InputError>& error() const { return m_error; }

 private:
  std::optional<ViewFiles> gridIn(const NameSeries& series, const KnownNames* known) {
    if (known != nullptr)
      if (auto grid = asKnown(series, namePattern(known->pattern))) return grid;
    for (const std::vector<SeriesReading>& kind : readingsOf(series))
      if (auto grid = bestOf(series, kind)) return grid;
    return std::nullopt;
  }

  /// Tries a known pattern; the one that is reported has an extension if other files fit it too.
  std::optional<ViewFiles> asKnown(const NameSeries& series, const NamePattern& pattern) {
    const std::vector<NamedView> views = matches(m_source.folder, series.files, pattern);
    const std::string extension = series.files.front().extension().string();
    return tried(pattern.text + (isExactly(pattern.text, views) ? "" : extension), views);
  }

  /// Whether a pattern fits these views' files and no others of the folder.
  [[nodiscard]] bool isExactly(const std::string& pattern,
                               const std::vector<NamedView>& views) const {
    return std::ranges::equal(matches(m_source.folder, m_files, namePattern(pattern)), views, {},
                              &NamedView::file, &NamedView::file);
  }

  std::optional<ViewFiles> bestOf(const NameSeries& series,
                                  const std::vector<SeriesReading>& readings) {
    std::optional<ViewFiles> best;
    for (const SeriesReading& reading : readings) {
      auto grid = tried(patternOf(m_source.folder, series, reading), viewsOf(series, reading));
      if (grid && (!best || grid->files.size() < best->files.size())) best = std::move(grid);
    }
    return best;
  }

  std::optional<ViewFiles> tried(const std::string& pattern, const std::vector<NamedView>& views) {
    try {
      m_source.pattern = pattern;
      ViewFiles grid = gridOf(views, m_source);
      checkArePictures(grid.found(), m_yuv);
      if (!pattern.empty() && !isExactly(pattern, views)) grid.pattern.clear();
      return grid;
    } catch (const InputError& error) {
      if (!m_error) m_error = error;
      return std::nullopt;
    }
  }

  const std::vector<fs::path>& m_files;
  const YuvParams& m_yuv;
  GridSource m_source;
  std::optional<InputError> m_error;
};

void nameOthers(ViewFiles& grid, const fs::path& folder, const std::vector<fs::path>& files) {
  std::vector<fs::path> views = grid.found();
  std::sort(views.begin(), views.end());
  for (const fs::path& file : files)
    if (!std::binary_search(views.begin(), views.end(), file))
      grid.others.push_back(nameBelow(folder, file));
}

/// Returns the folder of the first component. JPEG Pleno's reference software has the views of a
/// component in a folder; openPgx() finds those of the others. It is searched only once, because it
/// may be a link to its own folder.
fs::path firstComponentsOf(const fs::path& folder) {
  return folder / "0";
}

/// Returns what to change in a pattern that matches no file. "render.R.C" looks as if it had an
/// extension.
std::string adviceFor(const std::string& pattern, const std::vector<fs::path>& files) {
  const std::string extension = fs::path(pattern).extension().string();
  if (files.empty() || extension.empty() ||
      extension.find_first_not_of("RCN*", 1) != std::string::npos)
    return "correct lightField.pattern";
  return "what follows the last dot is the extension: write " + pattern +
         files.front().extension().string();
}

ViewFiles findByPattern(const LightFieldParams& params, const NamePattern& pattern,
                        GridSource source) {
  const auto depth = std::size_t(std::ranges::count(pattern.text, '/'));
  std::vector<fs::path> files = candidatesIn(source.folder, params, depth);
  std::vector<NamedView> views = matches(source.folder, files, pattern);
  if (const fs::path red = firstComponentsOf(source.folder); views.empty() && isFolder(red)) {
    source.folder = red;
    files = candidatesIn(red, params);
    views = matches(red, files, pattern);
  }
  if (views.empty())
    throw InputError(source.folder.string(), "views",
                     "\"" + pattern.text + "\" matches no file: " + thereText(files) + "; " +
                         adviceFor(pattern.text, files));
  source.pattern = pattern.text;
  ViewFiles grid = gridOf(views, source);
  nameOthers(grid, source.folder, files);
  return grid;
}

/// Whether a folder has a component of JPEG Pleno's views, whose names have row and column; one row
/// of views, 0/000.png, may be in a folder of that name too.
bool areComponents(const fs::path& folder) {
  const NamePattern names = namePattern("RRR_CCC");
  return isFolder(folder) && std::ranges::any_of(filesIn(folder), [&](const fs::path& file) {
           return numbersIn(file.filename().string(), names).has_value();
         });
}

/// Finds the views without a pattern.
class FolderSearch {
 public:
  FolderSearch(const LightFieldParams& params, std::array<int, 2> directions)
      : m_params(params), m_directions(directions) {}

  ViewFiles find(const fs::path& folder) {
    if (auto grid = tried(folder, 0)) return *grid;
    if (const fs::path red = firstComponentsOf(folder); areComponents(red))
      if (auto grid = tried(red, 0)) return *grid;
    // The folders of rows, or of columns, are a part of the views' names.
    if (auto grid = tried(folder, 1)) return *grid;
    if (m_error) throw *m_error;
    throw InputError(
        folder.string(), "views",
        "no names agree in all but their numbers: " + thereText(candidatesIn(folder, m_params)) +
            "; give lightField.pattern, such as RRR_CCC");
  }

 private:
  std::optional<ViewFiles> tried(const fs::path& folder, std::size_t depth) {
    const std::vector<fs::path> files = candidatesIn(folder, m_params, depth);
    SeriesSearch search(files, m_params, {folder, {}, m_directions, m_params.scan});
    auto grid = search.find();
    if (!grid) {
      if (!m_error) m_error = search.error();
      return std::nullopt;
    }
    // Several scenes, each in a folder of its own, are no light field.
    if (depth > 0 && grid->found().front().parent_path() == grid->found().back().parent_path())
      return std::nullopt;
    nameOthers(*grid, folder, files);
    return grid;
  }

  const LightFieldParams& m_params;
  std::array<int, 2> m_directions;
  std::optional<InputError> m_error;
};

/// Splits a path whose file name has %d into the folder before the first such part, and the pattern
/// of the rest.
std::optional<std::pair<fs::path, std::string>> withPercent(const fs::path& path) {
  std::error_code error;
  if (path.filename().string().find('%') == std::string::npos || fs::exists(path, error))
    return std::nullopt;
  fs::path folder, rest;
  for (const fs::path& part : path)
    if (rest.empty() && part.string().find('%') == std::string::npos)
      folder /= part;
    else
      rest /= part;
  return std::pair(folder.empty() ? fs::path(".") : folder, rest.generic_string());
}

}  // namespace

ViewFiles findViews(const LightFieldParams& params, std::array<int, 2> directions) {
  fs::path folder = params.file;
  std::optional<NamePattern> pattern;
  if (const auto split = withPercent(folder)) {
    folder = split->first;
    pattern = percentPattern(split->second);
  } else if (!params.pattern.empty()) {
    pattern = namePattern(params.pattern);
  }
  checkFolder(folder);
  return pattern ? findByPattern(params, *pattern, {folder, {}, directions, params.scan, true})
                 : FolderSearch(params, directions).find(folder);
}

}  // namespace hogelscope
