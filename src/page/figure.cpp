// SPDX-License-Identifier: BSD-3-Clause
#include "page/figure.h"

#include "io/files/atomic_file.h"
#include "io/files/files_in_use.h"
#include "page/html.h"

namespace hogelscope {

std::string_view styleFor(double width) {
  return width > columnUnits ? "wide" : "map";
}

Figure figureOf(const Plot& plot, const std::string& name, const std::string& title,
                const std::string& csv) {
  const auto draw = [plot, title](double width) {
    const double height = width > columnUnits ? 380 : 296;
    return svgOf(plot, {width, height, 46, 12}, styleFor(width), title);
  };
  return {name, title, "", draw, csv};
}

std::string figureTag(const Figure& figure) {
  const std::string caption = figure.caption.empty()
                                  ? std::string()
                                  : "<figcaption>" + escaped(figure.caption) + "</figcaption>";
  return "<figure>" + figure.svg() + caption + "</figure>\n";
}

void writeFigures(const std::filesystem::path& folder, const std::vector<Figure>& figures) {
  if (figures.empty()) return;
  const std::filesystem::path plots = folder / "plots";
  makeFolder(plots);
  std::vector<std::filesystem::path> files;
  for (const Figure& figure : figures)
    for (const char* const ending : figureEndings) files.push_back(plots / (figure.name + ending));
  checkOutputs(files);
  for (const Figure& figure : figures) {
    const auto [column, page, points] = figureEndings;
    writeTextFile(plots / (figure.name + column), svgFile(figure.draw(columnUnits), columnWidth));
    writeTextFile(plots / (figure.name + page), svgFile(figure.draw(pageUnits), pageWidth));
    writeTextFile(plots / (figure.name + points), figure.csv);
  }
}

}  // namespace hogelscope
