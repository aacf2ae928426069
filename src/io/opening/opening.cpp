// SPDX-License-Identifier: BSD-3-Clause
#include "io/opening/opening.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/documents/light_field_params.h"
#include "io/files/folders.h"
#include "io/images/image_file.h"
#include "io/opening/contrast.h"
#include "io/plugins/display_json.h"
#include "io/scene/view_source.h"
#include "io/store/light_field_store.h"

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
    if (file.extension() == ".yuv") return true;  // only a session gives its size
    return ImageFile(file).width() > 0;
  } catch (const InputError&) {
    return false;
  }
}

/// Whether it is an image, or a folder with one among its first files.
bool hasPictures(const std::string& file) {
  if (!isFolder(file)) return isPicture(file);
  std::vector<fs::path> files = filesIn(file);
  constexpr std::size_t most = 50;
  files.resize(std::min(files.size(), most));
  return std::ranges::any_of(files, isPicture);
}

/// Whether the light field is one image that ImageFile reads.
bool isOnePicture(const LightFieldParams& params) {
  return typeOf(params.layout).holder == Holder::picture;
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

/// Lists the assumptions in the order of the session's fields.
class Assumptions {
 public:
  Assumptions(const Opening& opening, const SaidFields& said)
      : m_opening(opening),
        m_used(opening.around.session.lightField),
        m_found(typeOf(m_used.layout).foundBy(m_used)),
        m_said(said) {
    const bool isUnseen = m_used.layout == Layout::hogels && !isFound(opening.around.hogels);
    add("Layout", std::string(nameOf(m_used.layout)),
        isUnseen ? "no borders of hogels stand out in the picture" : m_found.layout,
        isOnePicture(m_used) ? opening.around.hogels : Sureness::sure, "lightField.layout");
    addSize();
    if (opening.size.nx > 0 && opening.size.du * opening.size.dv > 1) addOrder();
    const bool isCaptured = m_used.viewingDistance > 0 && !isSaid("lightField.viewingDistance");
    if (isCaptured) addCameras();
    if (opening.size.nx > 0 && !isCaptured && !hasDisplay()) addDisplay();
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

  /// Whether the light field is a store that has its display's parameters.
  [[nodiscard]] bool hasDisplay() const {
    return typeOf(m_used.layout).holder == Holder::store &&
           LightFieldStore(m_used.file).header().display;
  }

  /// Whether cameras in a file beside the views gave their places, but neither the plane in focus
  /// nor, mostly, a scale.
  [[nodiscard]] bool isByViews() const { return !m_opening.around.assumed.empty(); }

  void addCameras() {
    add("Cameras", numberText(m_used.viewingDistance) + " m before the panel",
        isByViews() ? "the shear of the views, and the lenses and places in the file of their "
                      "cameras, which give the panel its size and field too; its unit is taken for "
                      "the metre"
                    : "the capture's own file, which gives the panel its size and field too",
        isByViews() ? Sureness::likely : Sureness::sure);
    m_list.back().isUsual = isByViews();
  }

  /// Adds what no picture says.
  void addDisplay() {
    const DisplayParams& display = m_opening.around.session.display;
    const auto addPair = [this](const char* what, const std::array<double, 2>& pair,
                                const char* unit, const char* reason, const char* field) {
      add(what, numberText(fourDigits(pair[0])) + "×" + numberText(fourDigits(pair[1])) + unit,
          reason, Sureness::unknown, field);
      m_list.back().isUsual = !isSaid(field);
    };
    addPair("Panel", display.size, " m", "the views' shape, but no file says how large it is",
            "display.size");
    addPair("Field of view", display.fov, "°", "no file says it", "display.fov");
  }

  [[nodiscard]] static bool isFound(Sureness sureness) { return sureness != Sureness::unknown; }

  void addSize() {
    const LightFieldSize& size = m_opening.size;
    if (size.nx == 0) return;
    const bool areHogelsSaid = m_used.layout == Layout::hogels && isSaid("display.hogels");
    add("Size",
        pairText(size.nx, size.ny) + " hogels of " + pairText(size.du, size.dv) + " directions",
        m_found.size, m_opening.around.hogels, areHogelsSaid ? "display.hogels" : m_found.field);
  }

  void addOrder() {
    const LightFieldOrder& order = m_opening.around.order;
    const AssumedOrder assumed = assumedOrder(m_used, m_opening.size, order);
    const std::string contradiction = contradictionOf(m_used, order);
    const bool isViews = isGridOfViews(m_used.layout);
    Assumption entry{
        "Order",
        std::string("rows ") + nameOf(assumed.rows) + ", columns " + nameOf(assumed.columns),
        order.reason, assumed.sureness};
    const bool isGiven = isViews && (isSaid("lightField.rows") || isSaid("lightField.columns"));
    if (isGiven || isSaid("lightField.incoming")) {
      entry.reason = chosen;
      entry.sureness = contradiction.empty() ? Sureness::sure : Sureness::unknown;
      if (!contradiction.empty()) entry.reason += ", but " + contradiction;
    } else if (!isViews && !m_used.incoming) {
      if (!isFound(order.sureness)) entry.reason = "as the layout has it; " + order.reason;
      entry.isUsual = true;
    }
    m_list.push_back(entry);
    if (!isViews) return;
    const bool isCaptured = m_used.viewingDistance > 0;
    add("Shear", numberText(m_used.shear[0]) + ", " + numberText(m_used.shear[1]) + " px/view",
        isCaptured && isByViews() ? "puts the middle depth on the panel"
        : isCaptured              ? "the capture's own file"
        : isFound(order.sureness) ? "puts the middle depth on the panel"
                                  : "none, because the order is not known",
        isCaptured ? Sureness::sure : order.sureness, "lightField.shear");
  }

  const Opening& m_opening;
  const LightFieldParams& m_used;
  FoundBy m_found;
  const SaidFields& m_said;
  std::vector<Assumption> m_list;
};

/// Returns a whole image, reduced so that its longer side has at most `side` pixels.
Preview smaller(const LightFieldParams& params, int side, const Progress& progress) {
  ImageFile file(params.file, params.yuv);
  const std::size_t longest = std::max(file.width(), file.height());
  const std::size_t step =
      std::max<std::size_t>(1, (longest + std::size_t(side) - 1) / std::size_t(side));
  Image image(int((file.width() + step - 1) / step), int((file.height() + step - 1) / step));
  std::vector<float> values;
  values.reserve(image.rgb.size());
  file.readRows(
      [&](std::size_t y, const float* rgb) {
        for (std::size_t x = 0; y % step == 0 && x < file.width(); x += step)
          for (std::size_t k = 3 * x; k < 3 * x + 3; ++k) values.push_back(255 * rgb[k]);
      },
      progress);
  const Contrast contrast(values);
  std::ranges::transform(values, image.rgb.begin(), contrast);
  return {std::move(image), contrast.isStretched()};
}

/// Adds the changes in one section of the session.
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

/// Adds layout and numbers of guessed tiles, or the grid of guessed lenslets, because what the user
/// gave holds only for these.
void sayGuess(SaidFields& said, const LightFieldParams& params) {
  const Json fields = written(params);
  said["lightField.layout"] = fields["layout"].dump();
  if (params.layout == Layout::lenslets) said["lightField.grid"] = fields["grid"].dump();
  if (params.layout == Layout::quilt && params.quiltColumns > 0 && params.quiltRows > 0)
    for (const char* name : {"columns", "rows"})
      said[std::string("lightField.") + name] = fields[name].dump();
}

/// Returns how often `part` fits into `whole`, rounded; a number that does not divide it is refused
/// when the file is read.
std::array<int, 2> parts(const std::array<int, 2>& whole, const std::array<int, 2>& part) {
  const auto along = [&](std::size_t axis) {
    return std::max(1, int(std::lround(double(whole[axis]) / part[axis])));
  };
  return {along(0), along(1)};
}

/// Returns the display with the numbers that follow from the one that was edited.
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

Opening inspectFile(const std::string& file, const SaidFields& said, const Progress& progress) {
  Opening opening;
  Session& session = opening.around.session;
  const std::string source = sourceOf(file, said);
  try {
    opening.around = orderedSessionAround(source, overridesOf(said), progress);
    if (!session.lightField.isLive()) {
      const auto lightField = openLightField(session.lightField, session.display, progress);
      opening.size = lightField->size();
      addWarnings(opening.around.order.warnings, *lightField);
    }
    check(session);
    if (session.lightField.layout == Layout::lenslets) {
      const auto lines = examine(session.lightField, session.display, progress);
      auto& warnings = opening.around.order.warnings;
      for (const std::string& line : lines)
        if (std::ranges::find(warnings, line) == warnings.end()) warnings.push_back(line);
      if (session.lightField.lenslets.white.empty() || !lines.empty())
        opening.around.hogels = std::min(opening.around.hogels, Sureness::likely);
    }
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

std::vector<std::string> examine(const LightFieldParams& lightField, const DisplayParams& display,
                                 const Progress& progress) {
  std::vector<std::string> lines;
  if (isGridOfViews(lightField.layout))
    lines = warningsOf(lightField, findLightFieldOrder(lightField, display, progress));
  else if (lightField.layout == Layout::lenslets)
    lines = {warningOf(lightField, lensletsOf(lightField, display, progress))};
  std::erase(lines, "");
  addFileWarnings(lines, lightField, display);
  return lines;
}

bool mayHave(Layout layout, const std::string& file, Layout own) {
  if (layout == own) return true;
  const Holder holder = typeOf(layout).holder;
  return holderOf(file) == Holder::picture &&
         (holder == Holder::picture || holder == Holder::views);
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
    const auto [columns, rows] = quiltNameOf(lightField.file).tiles;
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
  sayChanges(said, "display", writtenParts(shown.display), writtenParts(edited.display));
  if (typeOf(edited.lightField.layout).isOfTiles || edited.lightField.layout == Layout::lenslets)
    sayGuess(said, edited.lightField);
  return said;
}

Preview previewOf(const Opening& opening, const Progress& progress) {
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
