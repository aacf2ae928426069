// SPDX-License-Identifier: BSD-3-Clause
// --info: prints what a file is.
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <sstream>

#include "cli/camera_words.h"
#include "cli/inputs.h"
#include "cli/jobs.h"
#include "cli/terminal.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/panel/depth_budget.h"
#include "core/panel/sheet_numbers.h"
#include "io/cameras/camera_file.h"
#include "io/documents/session_file.h"
#include "io/documents/sheet_file.h"
#include "io/files/folders.h"
#include "io/images/image_file.h"
#include "io/images/image_writer.h"
#include "io/opening/light_field_order.h"
#include "io/opening/opening.h"
#include "io/scene/live_file.h"
#include "io/scene/numbered_frames.h"
#include "io/store/light_field_store.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

std::string typeName(StoredType type, int bits) {
  return type == StoredType::real ? "floating point" : std::to_string(bits) + " bit";
}

void printSize(std::ostream& out, const Session& session) {
  const LightFieldSize size = sizeOf(session);
  out << "hogels      " << size.nx << "×" << size.ny << "\n"
      << "directions  " << size.du << "×" << size.dv << "\n"
      << "hogel image " << size.width() << "×" << size.height() << " px\n";
}

std::string sizeText(const DisplayParams& display) {
  return numberText(display.size[0]) + "×" + numberText(display.size[1]) + " m, fov " +
         numberText(display.fov[0]) + "×" + numberText(display.fov[1]) + "°";
}

void printImage(std::ostream& out, const Session& around) {
  const LightFieldParams& params = around.lightField;
  const ImageFile image{fs::path(params.file), params.yuv};
  out << "picture     " << image.format() << ", " << image.width() << "×" << image.height()
      << " px, " << image.channels() << " channel(s), " << typeName(image.type(), image.bits())
      << "\n";
  if (!isWhole(around)) {
    out << "layout      not said by the file, in which no hogels, tiles or lenslets were found; "
           "for "
           "hogels: --set display.hogels=[nx,ny] --set display.directions=[du,dv]; for a quilt: "
           "--set lightField.layout=quilt --set lightField.columns=N --set lightField.rows=N; for "
           "a "
           "mosaic: --set lightField.layout=mosaic --set display.directions=[du,dv]; for lenslets: "
           "--set lightField.layout=lenslets\n";
    return;
  }
  out << "layout      " << typeOf(params.layout).words(params, around.display) << "\n";
  printSize(out, around);
  for (const std::string& warning : openLightField(params, around.display)->warnings())
    out << "warning     " << printable(warning) << "\n";
}

void printOthers(std::ostream& out, const ViewFiles& views) {
  const std::vector<std::string>& others = views.others;
  if (others.empty()) return;
  constexpr std::size_t mostNamed = 4;
  out << "others      " << others.size() << ": ";
  for (std::size_t k = 0; k < std::min(mostNamed, others.size()); ++k)
    out << (k == 0 ? "" : ", ") << printable(others[k]);
  out << (others.size() > mostNamed ? ", …" : "") << "; no views"
      << (views.otherSizes.empty() ? "" : ": " + views.otherSizes) << "\n";
}

void printSequence(std::ostream& out, const Session& around) {
  const auto file = openLightField(around.lightField, around.display);
  out << "layout      views in one file, " << file->size().dv << " rows of " << file->size().du
      << "\n"
      << "pictures    " << file->format() << ", " << typeName(file->type(), file->bits()) << "\n";
  printSize(out, around);
}

void printViews(std::ostream& out, const Session& around) {
  if (isViewSequence(around.lightField.file)) return printSequence(out, around);
  const ViewFiles views = findViews(around.lightField, around.display.directions);
  const std::vector<fs::path> files = views.found();
  const ImageFile first{files.front(), around.lightField.yuv};
  out << "layout      views, " << views.rows << " rows of " << views.columns << "\n";
  if (!views.pattern.empty()) out << "names       " << printable(views.pattern) << "\n";
  if (views.isCounted && views.rows > 1)
    out << "scan        " << nameOf(around.lightField.scan) << "\n";
  out << "first       " << printable(files.front().filename().string()) << "\n"
      << "last        " << printable(files.back().filename().string()) << "\n";
  printOthers(out, views);
  out << "pictures    " << first.format() << ", " << first.channels() << " channel(s), "
      << typeName(first.type(), first.bits()) << "\n";
  printSize(out, around);
}

void printStore(std::ostream& out, const Session& around) {
  const LightFieldStore store{fs::path(around.lightField.file)};
  const auto& [size, type, block, overview, source, display] = store.header();
  out << "layout      pack: a store, " << typeName(type, type == StoredType::uint8 ? 8 : 16)
      << ", blocks of " << block.i << "×" << block.j << " hogels × " << block.u << "×" << block.v
      << " directions\n"
      << "overview    " << overview.nx << "×" << overview.ny << " hogels of " << overview.du << "×"
      << overview.dv << " directions\n"
      << "made of     " << printable(source.substr(0, source.rfind(' '))) << "\n";
  if (display) out << "display     " << sizeText(*display) << "\n";
  printSize(out, around);
}

/// Prints the parameters of a live scene, one per line.
class ParameterLines : public ParameterVisitor {
 public:
  explicit ParameterLines(std::ostream& out) : m_out(out) {}
  void group(std::string_view, std::string_view) override {}

 protected:
  void numbers(const Field& field, std::span<double> values, bool isList) override {
    begin(field) << (isList ? "(" : "");
    for (std::size_t k = 0; k < values.size(); ++k)
      m_out << (k == 0 ? "" : ", ") << numberText(values[k]);
    end(field, isList);
  }
  void integers(const Field& field, std::span<int> values, bool isList) override {
    begin(field) << (isList ? "(" : "");
    for (std::size_t k = 0; k < values.size(); ++k) m_out << (k == 0 ? "" : ", ") << values[k];
    end(field, isList);
  }
  void flag(const Field& field, bool& value) override {
    begin(field) << (value ? "true" : "false") << "\n";
  }
  void text(const Field& field, std::string& value) override {
    begin(field) << printable(value) << "\n";
  }
  void choice(const Field& field, int& index) override {
    begin(field) << field.choices[std::size_t(index)] << "\n";
  }

 private:
  std::ostream& begin(const Field& field) {
    return m_out << "  " << field.name
                 << std::string(12 - std::min<std::size_t>(11, field.name.size()), ' ');
  }
  void end(const Field& field, bool isList) {
    m_out << (isList ? ")" : "") << (field.unit.empty() ? "" : " ") << field.unit << "\n";
  }

  std::ostream& m_out;
};

/// Prints the frames of a light field in time, their rate and how long they last.
void printFrames(std::ostream& out, const LightFieldParams& params, const LightFieldFile& file) {
  const auto [first, last, step] = file.frames();
  const std::size_t count = file.frames().count();
  if (count == 1) return;
  out << "frames      " << count << ": " << first << " … " << last
      << (step > 1 ? ", every " + std::to_string(step) : "");
  if (const double rate = frameRateOf(params, file); rate > 0)
    out << "; " << numberText(std::round(rate * 1000) / 1000) << " a second, "
        << rounded(double(last - first + step) / rate, 2) << " s";
  else
    out << "; lightField.fps says how many a second";
  out << "\n";
}

void printLive(std::ostream& out, const Session& session) {
  LightFieldParams params = session.lightField;
  out << "layout      live: rays of a scene are traced as views need them\n"
      << "source      " << printable(params.source) << "\n";
  ParameterLines lines(out);
  describe(lines, params.content);
  describe(lines, params.live);
  const LiveFile file(params, session.display);
  const auto& [points, corners, colours] = file.content().triangles();
  double back = 0;
  double front = 0;
  file.content().depths(back, front);
  if (!corners.empty()) out << "triangles   " << corners.size() / 3 << "\n";
  out << "depths      " << numberText(fourDigits(back)) << " … " << numberText(fourDigits(front))
      << " m\n";
  printFrames(out, params, file);
  for (const fs::path& name : file.files())
    out << "file        " << printable(name.string()) << "\n";
  for (const std::string& note : file.content().notes())
    out << "note        " << printable(note) << "\n";
  const std::string cuts = file.cutWarning(session.cameras.front());
  if (!cuts.empty()) out << "warning     " << printable(cuts) << "\n";
}

void printMesh(std::ostream& out, const Session& around) {
  printLive(out, around);
  out << "display     " << sizeText(around.display) << "\n";
  printSize(out, around);
}

/// Returns the pupil and the distance of the eyes, as far as they are there.
std::string eyesText(const CameraState& state) {
  std::string text;
  if (state.pupil.diameter > 0) text += ", pupil " + numberText(state.pupil.diameter) + " m";
  if (state.stereo.ipd > 0) text += ", eyes " + numberText(state.stereo.ipd) + " m apart";
  return text;
}

void printSession(std::ostream& out, const Session& session) {
  out << "session     " << session.cameras.size() << " camera state(s)\n"
      << "display     " << sizeText(session.display) << "\n"
      << "light field " << printable(contentName(session.lightField)) << "\n";
  if (session.lightField.isLive()) printLive(out, session);
  printSize(out, session);
  for (const CameraState& state : session.cameras) {
    const auto& [name, eye, lookat, up, fov, res, weight, time] = state.camera;
    out << "state       " << name << ": eye (" << numberText(eye.x) << ", " << numberText(eye.y)
        << ", " << numberText(eye.z) << ") m, fov " << numberText(fov) << "°, " << res[0] << "×"
        << res[1] << " px, psf sigma " << numberText(state.psf.sigma) << " in "
        << state.psf.windowSize << " px" << eyesText(state)
        << (weight == 1 ? "" : ", weight " + numberText(weight)) << "\n";
  }
  for (const std::string& warning : sheetWarnings(session))
    out << "warning     " << printable(warning) << "\n";
}

/// The session is the document's own, or one around a light field.
OrderedSession subjectOf(const CommandLine& line) {
  if (!isSessionDocument(line.subject)) return sessionAroundSubject(line);
  OrderedSession subject;
  subject.session = loadSession(line.subject, line.texts("set"));
  ProgressBar bar("looking at the views", false);
  subject.order =
      findLightFieldOrder(subject.session.lightField, subject.session.display, bar.progress());
  bar.done();
  return subject;
}

void printLenslets(std::ostream& out, const FoundLenslets& lenslets) {
  const LensletLattice& lattice = lenslets.lattice;
  out << "lenslets    pitch " << rounded(lattice.pitch(), 4) << " px, rotation "
      << rounded(lattice.rotation(), 4) << "°, origin (" << rounded(lattice.origin.real(), 2)
      << ", " << rounded(lattice.origin.imag(), 2) << ") px\n";
  if (lenslets.count > 0)
    out << "residual    " << rounded(lenslets.residual, 3) << " px (rms) of " << lenslets.count
        << " lenslets\n";
}

void printOrder(std::ostream& out, const OrderedSession& subject, const AssumedOrder& assumed) {
  const LightFieldParams& params = assumed.used;
  if (params.isLive()) return;
  if (!isWhole(subject.session)) {  // the first warning says what the line of the layout says
    for (std::size_t k = 1; k < assumed.warnings.size(); ++k)
      out << "warning     " << printable(assumed.warnings[k]) << "\n";
    return;
  }
  out << "order       rows " << nameOf(assumed.rows) << ", columns " << nameOf(assumed.columns)
      << ": " << nameOf(assumed.sureness) << "\n"
      << "found by    " << subject.order.reason << "\n";
  const bool isFound = !(params.viewingDistance > 0) && assumed.sureness != Sureness::unknown &&
                       params.shear == subject.order.found.shear &&
                       subject.order.measured.middleMotion != std::array{0.0, 0.0};
  if (isGridOfViews(params.layout))
    out << "shear       " << numberText(params.shear[0]) << ", " << numberText(params.shear[1])
        << " px/view" << (isFound ? ", which puts the middle depth on the panel" : "") << "\n";
  if (params.viewingDistance > 0)
    out << "display     " << sizeText(subject.session.display) << ", its views' cameras "
        << numberText(params.viewingDistance) << " m before it\n";
  for (const std::string& warning : assumed.warnings)
    out << "warning     " << printable(warning) << "\n";
  const std::vector<std::string> mending = mendingOf(params, subject.order);
  if (mending.empty() || contradictionOf(params, subject.order).empty()) return;
  out << "mend it     ";
  for (const std::string& change : mending)
    out << (change == mending.front() ? "" : " ") << "--set " << printable(change);
  out << "\n";
}

void printWords(std::ostream& out, bool isDocument, const OrderedSession& subject,
                const AssumedOrder& assumed) {
  if (isDocument) {
    printSession(out, subject.session);
  } else {
    constexpr std::array printers{printImage, printViews, printStore, printMesh};  // as Holder
    Session still = subject.session;
    still.lightField = firstStillOf(still.lightField);
    printers[std::size_t(typeOf(assumed.used.layout).holder)](out, still);
  }
  const LightFieldParams& params = subject.session.lightField;
  if (isWhole(subject.session) && !params.isLive())
    printFrames(out, params, *openLightField(params, subject.session.display));
  if (!subject.assumed.empty())
    out << "assumed     " << subject.assumed << ": " << nameOf(subject.hogels) << "\n";
  if (assumed.lenslets) printLenslets(out, *assumed.lenslets);
  printOrder(out, subject, assumed);
}

/// Prints what the sheet shows from its viewing distance, of an assumed number of views.
void printSheetNumbers(std::ostream& out, const SheetDisplay& display) {
  constexpr int views = 48;
  constexpr int many = 100000;
  const double distance = display.viewingDistance;
  const Vec3 eye{0, 0, distance};
  const SheetNumbers numbers = sheetNumbers(display, views, eye);
  const auto depths = [](const SheetNumbers& of) {
    return rounded(1000 * of.depthFront, 1) + " mm in front and " +
           rounded(1000 * of.depthBehind, 1) + " mm behind";
  };
  const double ipd = DepthParams().ipd;
  out << "seen        at " << numberText(distance) << " m: views repeat every "
      << rounded(numbers.width(), 3) << " m; " << rounded(100 * numbers.pseudoscopic(ipd), 1)
      << " % of head positions have the flip between their eyes (" << numberText(1000 * ipd)
      << " mm apart)\n"
      << "views       of " << views << ": " << rounded(numbers.viewsPerMetre, 1)
      << " pass in a metre, " << rounded(numbers.lobe, 2) << " (rms) mix in one place\n"
      << "sharp       with " << views << " views " << depths(numbers) << ", with any number "
      << depths(sheetNumbers(display, many, eye)) << "\n";
}

void printSheet(std::ostream& out, const SheetCalibration& calibration,
                const std::vector<std::string>& warnings) {
  const SheetParams& params = calibration.params;
  const SheetDisplay display{.calibration = calibration};
  const LensSheet sheet(display);
  const auto millimetres = [](double length) { return rounded(1000 * length, 4) + " mm"; };
  std::vector<SubPixels> upright = SheetCalibration{}.cells;
  const bool isUpright = calibration.cells == upright;
  std::swap(upright[0][0], upright[0][2]);
  out << "lens sheet  "
      << (calibration.serial.empty() ? "of a unit without serial number"
                                     : printable(calibration.serial))
      << "\n"
      << "panel       " << params.panel[0] << "×" << params.panel[1] << " px of "
      << millimetres(sheet.pixel()) << ", " << rounded(sheet.size()[0], 4) << "×"
      << rounded(sheet.size()[1], 4) << " m\n"
      << "sub-pixels  "
      << (isUpright ? "upright stripes of red, green, blue"
          : calibration.cells == upright
              ? "upright stripes of blue, green, red"
              : std::to_string(calibration.cells.size()) + " kind(s) of pixels, pattern " +
                    std::to_string(calibration.pattern))
      << "\n"
      << "lenses      " << rounded(sheet.lenses(), 2) << " across, " << millimetres(sheet.period())
      << " (" << rounded(sheet.period() / sheet.pixel(), 3) << " px) apart along a row, "
      << rounded(std::abs(sheet.slant()), 3) << "° from upright, the top to the "
      << (sheet.slant() > 0 ? "right" : "left") << "\n"
      << "cone        " << numberText(params.cone)
      << "°: " << rounded(2 * std::tan(radians(params.cone) / 2), 3)
      << " m wide at 1 m; taken for the lenses', whose pixels are then " << millimetres(sheet.gap())
      << " of air behind them\n";
  printSheetNumbers(out, display);
  for (const std::string& warning : warnings) out << "warning     " << printable(warning) << "\n";
}

void writeContactSheet(const CommandLine& line, const OrderedSession& subject,
                       const AssumedOrder& assumed) {
  const fs::path file = fs::path(line.text("output")) / "views.png";
  if (!isWhole(subject.session))
    throw InputError(line.subject, "display.hogels",
                     "and display.directions are needed for a contact sheet");
  const Input input(subject.session);
  checkResults(line, subject.session, {file});
  makeFolderOf(file);
  ProgressBar bar("drawing the views", false);
  const auto& [sheet, isStretched] =
      contactSheet(subject.order, assumed, subject.session.display, bar.progress());
  writeImage(file, sheet.width, sheet.height, sheet.rgb, bar.progress());
  bar.done();
  if (isStretched) printNote(file.string() + ": contrast stretched, because the views are dark");
}

/// Returns what prints a file of cameras or a trace; null for all else, and for meshes with
/// cameras.
std::function<void(std::ostream&, const std::string&)> printerOf(const std::string& file) {
  std::error_code none;
  if (!fs::is_regular_file(file, none) || isMeshFile(file)) return nullptr;
  const std::string ending = lowerCase(fs::path(file).extension().string());
  const bool isMeant = ending == ".yaml" || ending == ".yml" || ending == ".xml";
  if (isMeant || isCameraFile(file)) return printCameraFile;
  if (isTraceFile(file)) return printTraceFile;
  return nullptr;
}

}  // namespace

int runInfo(const CommandLine& line) {
  std::ostringstream out;
  if (isSheetCalibration(line.subject)) {
    for (const char* option : {"json", "output", "set"})
      if (line.has(option))
        throw InputError("command line", std::string("--") + option,
                         "is for a light field, not for a lens sheet's calibration");
    std::vector<std::string> warnings;
    const SheetCalibration calibration = loadSheetCalibration(line.subject, &warnings);
    printSheet(out, calibration, warnings);
    std::cout << out.str();
    return 0;
  }
  if (const auto print = printerOf(line.subject)) {
    for (const char* option : {"json", "output", "set"})
      if (line.has(option))
        throw InputError("command line", std::string("--") + option,
                         "is for a light field, not for a file of cameras or a trace");
    print(out, line.subject);
    std::cout << out.str();
    return 0;
  }
  try {
    const OrderedSession subject = subjectOf(line);
    const AssumedOrder assumed = orderOf(subject);
    if (line.has("json"))
      out << orderDocument(assumed);
    else
      printWords(out, isSessionDocument(line.subject), subject, assumed);
    if (line.has("output")) writeContactSheet(line, subject, assumed);
  } catch (const InputError& error) {
    throw error.in(line.subject);
  }
  std::cout << out.str();
  return 0;
}

Job infoJob() {
  return {.name = "info",
          .value = "FILE",
          .help =
              "Says what a session, a light field's image, a folder of views or a store is, in "
              "which order its views are, and how sure that is; or what a lens sheet's "
              "calibration (visual.json), a file of cameras or a viewer's trace is.",
          .details =
              "--output DIR writes DIR/views.png, a contact sheet: the views as their cameras "
              "stand, with arrows.",
          .examples =
              "  hogelscope --info data/table1.json\n"
              "  hogelscope --info views --json\n"
              "  hogelscope --info views --output sheet\n"
              "  hogelscope --info views --set lightField.pattern=view_RR_CC.png\n"
              "  hogelscope --info large.png --set display.hogels=[512,512] \\\n"
              "             --set display.directions=[600,600]\n",
          .takes = {"set", "plugins-path", "output"},
          .own = {{.name = "json",
                   .after = "for-twin",
                   .help = "Prints order, shear and size of a light field for programs."}},
          .run = runInfo};
}

}  // namespace hogelscope
