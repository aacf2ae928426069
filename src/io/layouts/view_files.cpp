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
#include "io/files/folders.h"
#include "io/images/image_file.h"
#include "io/layouts/layouts.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

std::vector<NamedView> matches(const std::vector<fs::path>& files, const NamePattern& pattern) {
  const bool isOfCoordinates = pattern.meaning().find_first_of("RCN") == std::string::npos;
  std::vector<NamedView> views;
  for (const fs::path& file : files) {
    const auto numbers = numbersIn(file.filename().string(), pattern);
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

/// Returns the files that may be views: neither folders nor hidden files.
std::vector<fs::path> candidatesIn(const fs::path& folder, const LightFieldParams& params) {
  std::vector<fs::path> files = filesIn(folder);
  std::erase_if(files, [&](const fs::path& file) {
    const std::string name = file.filename().string();
    return name.front() == '.' || isExcluded(name, params.exclude);
  });
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

std::vector<Claim> claimsOf(const std::vector<fs::path>& files) {
  std::vector<Claim> claims;
  for (NameSeries& series : seriesOf(files)) {
    const bool isOther = isOfOtherData(series.parts.front());
    Claim claim{std::move(series), nullptr, isOther};
    for (const KnownNames& known : knownNames) {
      const NamePattern pattern = namePattern(known.pattern);
      const auto fits = [&](const fs::path& file) {
        return numbersIn(file.filename().string(), pattern).has_value();
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

/// Splits a series of images of several sizes, such as view_512_07 and view_128_07; the one with
/// the most images comes first, or that with the larger ones. If a size occurs only once, the
/// series stays whole, because that file is an error.
std::vector<NameSeries> seriesOfOneSize(NameSeries series, const YuvParams& yuv) {
  const std::vector<fs::path>& files = series.files;
  const std::size_t count = files.size();
  const PictureSize first = sizeOf(files.front(), yuv);
  constexpr std::size_t most = 5000;  // whose sizes are read in a moment
  if (count < 4 || count > most ||
      (first == sizeOf(files[count / 2], yuv) && first == sizeOf(files.back(), yuv)))
    return {std::move(series)};
  std::map<PictureSize, NameSeries> ofSize;
  for (std::size_t k = 0; k < count; ++k) {
    NameSeries& own = ofSize[sizeOf(files[k], yuv)];
    own.files.push_back(files[k]);
    own.parts.push_back(series.parts[k]);
  }
  std::vector<NameSeries> result;
  for (auto& [size, own] : ofSize) {
    if (size == PictureSize{0, 0} || own.files.size() < 2) return {std::move(series)};
    result.insert(result.begin(), std::move(own));
  }
  std::stable_sort(result.begin(), result.end(), [](const NameSeries& a, const NameSeries& b) {
    return a.files.size() > b.files.size();
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
    for (Claim& claim : claimsOf(m_files))
      for (const NameSeries& series : seriesOfOneSize(std::move(claim.series), m_yuv)) {
        if (claim.known != nullptr)
          if (auto grid = asKnown(series, namePattern(claim.known->pattern))) return grid;
        for (const std::vector<SeriesReading>& kind : readingsOf(series))
          if (auto grid = bestOf(series, kind)) return grid;
      }
    return std::nullopt;
  }

  [[nodiscard]] const std::optional<InputError>& error() const { return m_error; }

 private:
  /// Tries a known pattern; the one that is reported has an extension if other files fit it too.
  std::optional<ViewFiles> asKnown(const NameSeries& series, const NamePattern& pattern) {
    const std::vector<NamedView> views = matches(series.files, pattern);
    const std::string extension = series.files.front().extension().string();
    return tried(pattern.text + (isExactly(pattern.text, views) ? "" : extension), views);
  }

  /// Whether a pattern fits these views' files and no others of the folder.
  [[nodiscard]] bool isExactly(const std::string& pattern,
                               const std::vector<NamedView>& views) const {
    return std::ranges::equal(matches(m_files, namePattern(pattern)), views, {}, &NamedView::file,
                              &NamedView::file);
  }

  std::optional<ViewFiles> bestOf(const NameSeries& series,
                                  const std::vector<SeriesReading>& readings) {
    std::optional<ViewFiles> best;
    for (const SeriesReading& reading : readings) {
      auto grid = tried(patternOf(series, reading), viewsOf(series, reading));
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

void nameOthers(ViewFiles& grid, const std::vector<fs::path>& files) {
  std::vector<fs::path> views = grid.found();
  std::sort(views.begin(), views.end());
  for (const fs::path& file : files)
    if (!std::binary_search(views.begin(), views.end(), file))
      grid.others.push_back(file.filename().string());
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
  std::vector<fs::path> files = candidatesIn(source.folder, params);
  std::vector<NamedView> views = matches(files, pattern);
  if (const fs::path red = firstComponentsOf(source.folder); views.empty() && isFolder(red)) {
    files = candidatesIn(red, params);
    views = matches(files, pattern);
  }
  if (views.empty())
    throw InputError(source.folder.string(), "views",
                     "\"" + pattern.text + "\" matches no file: " + thereText(files) + "; " +
                         adviceFor(pattern.text, files));
  source.pattern = pattern.text;
  ViewFiles grid = gridOf(views, source);
  nameOthers(grid, files);
  return grid;
}

/// Finds the views without a pattern.
ViewFiles findSeries(const LightFieldParams& params, const fs::path& folder,
                     std::array<int, 2> directions, bool mayHaveComponents = true) {
  const std::vector<fs::path> files = candidatesIn(folder, params);
  SeriesSearch search(files, params, {folder, {}, directions, params.scan == ViewScan::serpentine});
  if (auto grid = search.find()) {
    nameOthers(*grid, files);
    return *grid;
  }
  if (const fs::path red = firstComponentsOf(folder); mayHaveComponents && isFolder(red))
    return findSeries(params, red, directions, false);
  if (search.error()) throw *search.error();
  throw InputError(folder.string(), "views",
                   "no names agree in all but their numbers: " + thereText(files) +
                       "; give lightField.pattern, such as RRR_CCC");
}

}  // namespace

ViewFiles findViews(const LightFieldParams& params, std::array<int, 2> directions) {
  fs::path folder = params.file;
  std::error_code error;
  std::optional<NamePattern> pattern;
  const std::string last = folder.filename().string();
  if (last.find('%') != std::string::npos && !fs::exists(folder, error)) {
    pattern = percentPattern(last);
    folder = folder.parent_path().empty() ? "." : folder.parent_path();
  } else if (!params.pattern.empty()) {
    pattern = namePattern(params.pattern);
  }
  checkFolder(folder);
  return pattern
             ? findByPattern(params, *pattern,
                             {folder, {}, directions, params.scan == ViewScan::serpentine, true})
             : findSeries(params, folder, directions);
}

}  // namespace hogelscope
