// SPDX-License-Identifier: BSD-3-Clause
#include "page/figure.h"

#include "io/files/atomic_file.h"
#include "io/files/files_in_use.h"
#include "page/html.h"

namespace hogelscope {

Figure figureOf(const Plot& plot, const std::string& name, const std::string& title,
                const std::string& csv) {
  return {name, title, "", svgOf(plot, {columnUnits, 296, 46, 12}, "map", title), csv};
}

std::string figureTag(const Figure& figure) {
  const std::string caption = figure.caption.empty()
                                  ? std::string()
                                  : "<figcaption>" + escaped(figure.caption) + "</figcaption>";
  return "<figure>" + figure.svg + caption + "</figure>\n";
}

void writeFigures(const std::filesystem::path& folder, const std::vector<Figure>& figures) {
  if (figures.empty()) return;
  const std::filesystem::path plots = folder / "plots";
  makeFolder(plots);
  std::vector<std::filesystem::path> files;
  for (const Figure& figure : figures)
    for (const char* const ending : {".svg", ".csv"})
      files.push_back(plots / (figure.name + ending));
  checkOutputs(files);
  for (const Figure& figure : figures) {
    writeTextFile(plots / (figure.name + ".svg"), svgFile(figure.svg, figure.width));
    writeTextFile(plots / (figure.name + ".csv"), figure.csv);
  }
}

}  // namespace hogelscope
