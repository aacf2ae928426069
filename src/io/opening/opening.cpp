// SPDX-License-Identifier: BSD-3-Clause
// A light field that is opened without a session.
#include "io/opening/opening.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/documents/light_field_params.h"
#include "io/files/folders.h"
#include "io/images/image_file.h"
#include "io/layouts/view_layouts.h"
#include "io/layouts/view_sequences.h"
#include "io/opening/contact_sheet.h"
#include "io/plugins/display_json.h"
#include "io/scene/scene.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

constexpr const char* chosen = "chosen here";

std::string sourceOf(const std::string& file, const SaidFields& said) {
  const auto layout = said.find("lightField.layout");
  const bool isViews = layout != said.end() && layout->second == "\"views\"";
  if (!isViews || isFolder(file) || isViewSequence(file)) return file;
  return fs::absolute(file).parent_path().string();
}

std::vector<std::string> overridesOf(const SaidFields& said) {
  std::vector<std::string> overrides;
  for (const auto& [field, value] : said) overrides.emplace_back(field).append("=").append(value);
  return overrides;
}

bool isPicture(const fs::path& file) {
  try {
    if (file.extension() == ".yuv") return true;  // of which only a session knows the size
    return ImageFile(file).width() > 0;
  } catch (const InputError&) {
    return false;
  }
}

/// Whether it is a picture, or a folder with one among its first files.
bool hasPictures(const std::string& file) {
  if (!isFolder(file)) return isPicture(file);
  std::vector<fs::path> files = filesIn(file);
  constexpr std::size_t most = 50;
  files.resize(std::min(files.size(), most));
  return std::ranges::any_of(files, isPicture);
}

bool isOfTiles(Layout layout) {
  return layout == Layout::quilt || layout == Layout::mosaic;
}

/// Whether the light field is one picture that ImageFile reads.
bool isOnePicture(const LightFieldParams& params) {
  return params.layout == Layout::hogels || isOfTiles(params.layout) ||
         params.layout == Layout::lenslets;
}

std::array<int, 2> pictureSize(const LightFieldParams& params) {
  if (!isOnePicture(params)) return {0, 0};
  try {
    const ImageFile picture(params.file, params.yuv);
    return {int(picture.width()), int(picture.height())};
  } catch (const InputError&) {
    return {0, 0};
  }
}

/// Makes the list, in the order of the session's fields.
class Assumptions {
 public:
  Assumptions(const Opening& opening, const SaidFields& said)
      : m_opening(opening), m_used(opening.around.session.lightField), m_said(said) {
    add("Layout", nameOfLayout(), layoutReason(), layoutSureness(), "lightField.layout");
    addSize();
    if (opening.size.nx > 0 && opening.size.du * opening.size.dv > 1) addOrder();
    if (m_used.viewingDistance > 0 && !isSaid("lightField.viewingDistance"))
      add("Cameras", numberText(m_used.viewingDistance) + " m before the panel",
          "the capture's own file, which gives the panel its size and field too", Sureness::sure);
  }

  std::vector<Assumption> list() && { return std::move(m_list); }

 private:
  [[nodiscard]] bool isSaid(const std::string& field) const { return m_said.contains(field); }

  void add(const std::string& what, const std::string& value, const std::string& reason,
           Sureness sureness, const std::string& field = {}) {
    if (isSaid(field))
      m_list.push_back({what, value, chosen, Sureness::sure});
    else
      m_list.push_back({what, value, reason, sureness});
  }

  [[nodiscard]] std::string nameOfLayout() const { return std::string(nameOf(m_used.layout)); }

  [[nodiscard]] std::string layoutReason() const {
    switch (m_used.layout) {
      case Layout::views:
        return isFolder(m_used.file) ? "a folder of pictures" : "frames of one file";
      case Layout::quilt:
        return isNamedQuilt() ? "the file's name" : "a few large tiles";
      case Layout::mosaic:
        return "a few large tiles with parallax along both axes";
      case Layout::hogels:
        return m_opening.around.hogels == Sureness::unknown
                   ? "no borders of hogels stand out in the picture"
                   : "borders of hogels in the picture";
      default:
        return "the file says it";
    }
  }

  [[nodiscard]] Sureness layoutSureness() const {
    return isOnePicture(m_used) ? m_opening.around.hogels : Sureness::sure;
  }
  [[nodiscard]] bool isNamedQuilt() const { return quiltTilesFromName(m_used.file)[0] > 0; }

  void addSize() {
    const LightFieldSize& size = m_opening.size;
    if (size.nx == 0) return;
    const auto pair = [](int a, int b) { return std::to_string(a) + "×" + std::to_string(b); };
    const std::string value =
        pair(size.nx, size.ny) + " hogels of " + pair(size.du, size.dv) + " directions";
    if (m_used.layout == Layout::hogels) {
      const bool hasHogels = isSaid("display.hogels");
      add("Size", value, "borders of hogels in the picture", m_opening.around.hogels,
          hasHogels ? "display.hogels" : "display.directions");
    } else {
      const bool isNamed = m_used.layout == Layout::quilt && isNamedQuilt();
      add("Size", value,
          m_used.layout == Layout::views      ? "size and number of the pictures"
          : m_used.layout == Layout::lenslets ? "a regular grid of lenslets in the picture"
          : isNamed                           ? "the file's name"
          : isOfTiles(m_used.layout)          ? "tiles in the picture"
                                              : "the file says it",
          m_opening.around.hogels,
          isGridOfViews(m_used.layout)     ? "display.directions"
          : m_used.layout == Layout::quilt ? "lightField.columns"
                                           : "");
    }
  }

  void addOrder() {
    const LightFieldOrder& order = m_opening.around.order;
    const AssumedOrder assumed = assumedOrder(m_used, m_opening.size, order);
    const std::string contradiction = contradictionOf(m_used, order);
    const bool isViews = isGridOfViews(m_used.layout);
    const bool isFound = order.sureness != Sureness::unknown;
    Assumption entry{
        "Order",
        std::string("rows ") + nameOf(assumed.rows) + ", columns " + nameOf(assumed.columns),
        order.reason, assumed.sureness};
    const bool isGiven = isViews && (isSaid("lightField.rows") || isSaid("lightField.columns"));
    if (isGiven || isSaid("lightField.incoming")) {
      entry.reason = chosen;
      entry.sureness = Sureness::sure;
      if (!contradiction.empty()) entry.reason += ", but " + contradiction;
    } else if (!isViews && !m_used.incoming) {
      if (!isFound) entry.reason = "as the layout has it; " + order.reason;
      entry.isUsual = true;
    }
    m_list.push_back(entry);
    if (!isViews) return;
    const bool isCaptured = m_used.viewingDistance > 0;
    add("Shear", numberText(m_used.shear[0]) + ", " + numberText(m_used.shear[1]) + " px/view",
        isCaptured ? "the capture's own file" : "puts the middle depth on the panel",
        isCaptured ? Sureness::sure : order.sureness, "lightField.shear");
  }

  const Opening& m_opening;
  const LightFieldParams& m_used;
  const SaidFields& m_said;
  std::vector<Assumption> m_list;
};

/// A whole picture, made so small that its longer side has `side` pixels.
Image smaller(const LightFieldParams& params, int side, const Progress& progress) {
  ImageFile file(params.file, params.yuv);
  const std::size_t longest = std::max(file.width(), file.height());
  const std::size_t step =
      std::max<std::size_t>(1, (longest + std::size_t(side) - 1) / std::size_t(side));
  Image image(int((file.width() + step - 1) / step), int((file.height() + step - 1) / step));
  const auto width = std::size_t(image.width);
  file.read(
      StoredType::uint8,
      [&](std::size_t first, std::size_t rows, const StoredRows& values) {
        const auto* rgb = std::get<const std::uint8_t*>(values);
        for (std::size_t y = first; y < first + rows; ++y) {
          if (y % step != 0) continue;
          const std::uint8_t* row = rgb + 3 * file.width() * (y - first);
          for (std::size_t x = 0; x < width; ++x)
            std::copy_n(row + 3 * step * x, 3, &image.rgb[3 * (y / step * width + x)]);
        }
      },
      progress);
  return image;
}

/// Of one section of the session.
void sayChanges(SaidFields& said, const std::string& section, const Json& shown,
                const Json& edited) {
  const auto field = [&section](const std::string& key) {
    return std::string(section).append(".").append(key);
  };
  for (const auto& [key, value] : edited.items())
    if (!shown.contains(key) || shown[key] != value) said[field(key)] = value.dump();
  for (const auto& [key, value] : shown.items())
    if (!edited.contains(key)) said.erase(field(key));  // to be found again
}

/// What is said of tiles that were guessed holds for their layout alone, and for all their numbers.
void sayTiles(SaidFields& said, const LightFieldParams& params) {
  const Json fields = written(params);
  said["lightField.layout"] = fields["layout"].dump();
  if (params.layout == Layout::quilt && params.quiltColumns > 0 && params.quiltRows > 0)
    for (const char* name : {"columns", "rows"})
      said[std::string("lightField.") + name] = fields[name].dump();
}

/// How often one goes into the other; one that does not go into it is refused when it is read.
std::array<int, 2> parts(const std::array<int, 2>& whole, const std::array<int, 2>& part) {
  const auto along = [&](std::size_t axis) {
    return std::max(1, int(std::lround(double(whole[axis]) / part[axis])));
  };
  return {along(0), along(1)};
}

/// The display with the numbers that follow from the one that was edited.
DisplayParams completed(DisplayParams display, const DisplayParams& shown,
                        const std::array<int, 2>& picture) {
  auto& [across, down] = display.hogels;
  if (display.hogels != shown.hogels) {
    if (across > 0 && down <= 0) down = std::max(1, across * picture[1] / picture[0]);
    if (down > 0 && across <= 0) across = std::max(1, down * picture[0] / picture[1]);
    if (across > 0) display.directions = parts(picture, display.hogels);
  } else if (display.directions != shown.directions) {
    auto& [u, v] = display.directions;
    if (u <= 0 || v <= 0) u = v = std::max(u, v);
    if (u > 0) display.hogels = parts(picture, display.directions);
  }
  return display;
}

}  // namespace

Opening lookAt(const std::string& file, const SaidFields& said, const Progress& progress) {
  Opening opening;
  Session& session = opening.around.session;
  const std::string source = sourceOf(file, said);
  try {
    opening.around = orderedSessionAround(source, overridesOf(said), progress);
    if (!session.lightField.isLive())
      opening.size = openLightField(session.lightField, session.display, progress)->size();
    check(session);
  } catch (const InputError& error) {
    if (!hasPictures(source)) throw;
    opening.problem = error.what();
    if (session.lightField.file.empty()) session.lightField = lightFieldOf(source);
    opening.around.hogels = Sureness::unknown;
    opening.size = {0, 0, 0, 0};
  }
  opening.picture = pictureSize(session.lightField);
  opening.assumptions = Assumptions(opening, said).list();
  return opening;
}

bool isInDoubt(const Opening& opening) {
  return !opening.problem.empty() ||
         std::ranges::any_of(opening.assumptions, [](const Assumption& each) {
           return each.sureness != Sureness::sure && !each.isUsual;
         });
}

Session shownOf(const Opening& opening) {
  Session session = opening.around.session;
  const LightFieldSize& size = opening.size;
  if (size.nx == 0) return session;
  session.display.hogels = {size.nx, size.ny};
  session.display.directions = {size.du, size.dv};
  LightFieldParams& lightField = session.lightField;
  if (lightField.layout == Layout::quilt && lightField.quiltColumns == 0) {
    const auto [columns, rows] = quiltTilesFromName(lightField.file);
    lightField.quiltColumns = columns;
    lightField.quiltRows = rows;
  }
  return session;
}

SaidFields saidAfter(SaidFields said, const Session& shown, Session edited,
                     const std::array<int, 2>& picture) {
  const Json layout = written(edited.lightField)["layout"];
  if (edited.lightField.layout != shown.lightField.layout)
    return {{"lightField.layout", layout.dump()}};
  if (edited.lightField.layout == Layout::mosaic) {
    auto& [u, v] = edited.display.directions;
    if (u <= 0 || v <= 0) u = v = std::max(u, v);
  }
  if (edited.lightField.layout == Layout::hogels && picture[0] > 0)
    edited.display = completed(edited.display, shown.display, picture);
  sayChanges(said, "lightField", written(shown.lightField), written(edited.lightField));
  sayChanges(said, "display", writtenDisplay(shown.display), writtenDisplay(edited.display));
  if (isOfTiles(edited.lightField.layout)) sayTiles(said, edited.lightField);
  return said;
}

Image previewOf(const Opening& opening, const Progress& progress) {
  const Session& session = opening.around.session;
  constexpr int side = 1200;  // px
  if (opening.size.nx == 0 && opening.picture[0] > 0)
    return smaller(session.lightField, side, progress);
  if (opening.size.nx == 0) throw InputError(session.lightField.file, "", "shows nothing yet");
  AssumedOrder assumed = assumedOrder(session.lightField, opening.size, opening.around.order);
  assumed.isChosen = std::ranges::any_of(opening.assumptions, [](const Assumption& each) {
    return each.what == "Order" && each.reason.starts_with(chosen);
  });
  return contactSheet(opening.around.order, assumed, session.display, progress);
}

}  // namespace hogelscope
