// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes the names of views: the input's first line is the pattern, the others are names of files,
// which are pictures of one pixel.
#include <sstream>
#include <utility>

#include "capture/names/name_pattern.h"
#include "io/layouts/layouts.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

namespace {

bool isFileName(const std::string& name) {
  return !name.empty() && name.size() < 256 && name != "." && name != ".." &&
         name.find_first_of(std::string("/\0", 2)) == std::string::npos;
}

void checkGrid(const LightFieldParams& params, std::array<int, 2> directions = {0, 0}) {
  mayRefuse([&] {
    const ViewFiles views = findViews(params, directions);
    require(views.rows > 0 &&
            std::size_t(views.rows) * std::size_t(views.columns) == views.files.size());
    require(directions[0] > 0 || 2 * views.found().size() > views.files.size());
    require(views.missing.empty() == (views.found().size() == views.files.size()));
    if (views.pattern.empty()) return;
    LightFieldParams again = params;
    again.pattern = views.pattern;
    (void)transposedPattern(views.pattern);
    require(!params.pattern.empty() || findViews(again, directions).files == views.files);
  });
}

}  // namespace

void fuzz(std::string_view input) {
  const std::filesystem::path views = folder() / "views";
  std::filesystem::create_directory(views);
  std::istringstream in{std::string(input)};
  std::string pattern;
  std::getline(in, pattern);
  int files = 0;
  for (std::string name; files < 12 && std::getline(in, name);)
    if (isFileName(name) && std::ofstream(views / name) << "P5 1 1 255\na") ++files;
  LightFieldParams params;
  params.layout = Layout::views;
  params.pattern = pattern;
  params.file = views.string();
  checkGrid(params);
  checkGrid(params, {3, 3});
  params.exclude = std::exchange(params.pattern, "");
  checkGrid(params);
  params.file = (views / pattern).string();  // as printf's
  checkGrid(params);
  std::filesystem::remove_all(views);
}
