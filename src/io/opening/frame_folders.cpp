// SPDX-License-Identifier: BSD-3-Clause
#include "io/opening/frame_folders.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/base/error.h"
#include "core/light_field/frames.h"
#include "core/metrics/statistics.h"
#include "io/files/folders.h"
#include "io/layouts/layouts.h"
#include "io/opening/matched_order.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// The last number in a name, and what is around it.
struct NumberedName {
  std::string before;
  std::string digits;
  std::string after;
};

std::optional<NumberedName> numberedName(const std::string& name) {
  constexpr const char* digits = "0123456789";
  const std::size_t last = name.find_last_of(digits);
  if (last == std::string::npos) return std::nullopt;
  const std::size_t before = name.find_last_not_of(digits, last);
  const std::size_t first = before == std::string::npos ? 0 : before + 1;
  return NumberedName{name.substr(0, first), name.substr(first, last + 1 - first),
                      name.substr(last + 1)};
}

/// Returns the folders in a folder if all have one name but for a number.
std::vector<fs::path> numberedFolders(const fs::path& folder) {
  std::vector<fs::path> folders;
  std::optional<NumberedName> first;
  for (const fs::path& entry : entriesOf(folder)) {
    const std::string name = entry.filename().string();
    if (name.front() == '.' || !isFolder(entry)) continue;
    const auto own = numberedName(name);
    if (!own) return {};
    if (!first) first = own;
    if (own->before != first->before || own->after != first->after) return {};
    folders.push_back(entry);
  }
  std::ranges::sort(folders, {}, [](const fs::path& path) {
    const std::string digits = numberedName(path.filename().string())->digits;
    return std::pair(digits.size(), digits);
  });
  return folders;
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

}  // namespace

std::optional<FoundFrames> framesInFolder(const std::string& folder, const Progress& progress) {
  constexpr double alike = 0.9, similar = 0.5;
  if (!isFolder(folder)) return std::nullopt;
  try {
    const std::vector<fs::path> folders = numberedFolders(folder);
    if (folders.size() < 2) return std::nullopt;
    const ViewFiles first = findViews(viewsIn(folders.front()), {0, 0});
    const ViewFiles last = findViews(viewsIn(folders.back()), {0, 0});
    const bool isGrid = first.rows > 1 && first.columns > 1 && !first.isCounted;
    if (!isGrid || first.rows != last.rows || first.columns != last.columns) return std::nullopt;
    const double likeness = likenessOf(folders[0], folders[1], progress);
    if (!(likeness > similar)) return std::nullopt;
    const auto name = numberedName(folders.front().filename().string());
    const std::string pattern = name->before + std::string(frameMark) + name->after;
    return FoundFrames{(fs::path(folder) / pattern).string(),
                       likeness > alike ? Sureness::sure : Sureness::likely};
  } catch (const InputError&) {
    return std::nullopt;  // said by whoever opens the folder
  }
}

}  // namespace hogelscope
