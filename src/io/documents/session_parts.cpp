// SPDX-License-Identifier: BSD-3-Clause
#include "io/documents/session_parts.h"

#include "core/base/error.h"
#include "io/documents/light_field_params.h"
#include "io/plugins/plugin_library.h"

namespace hogelscope {

namespace {

constexpr int documentVersion = 1;
constexpr int mostDead = 1 << 24;

int readIndex(const Json& value, const std::string& path) {
  if (!value.is_number_integer() || value < 0 || value >= mostDead)
    throw InputError(path, valueText(value) + " is not a number from 0 on");
  return value.get<int>();
}

std::array<int, 2> readHogel(const Json& pair, const std::string& path) {
  if (!pair.is_array() || pair.size() != 2)
    throw InputError(path, valueText(pair) + " is not a hogel: [column, row]");
  return {readIndex(pair[0], path), readIndex(pair[1], path)};
}

/// Visits a list that documents leave out where it is empty; `what` says its form.
template <class Element>
void visitList(SectionVisitor& v, const char* name, std::vector<Element>& elements,
               const char* what, Element (*readElement)(const Json&, const std::string&)) {
  v.value(
      name, !elements.empty(),
      [&](const Json& list, const std::string& path) {
        if (!list.is_array()) throw InputError(path, std::string("is not a list ") + what);
        for (const Json& element : list) elements.push_back(readElement(element, path));
      },
      [&] { return Json(elements); });
}

std::string wantedVersion() {
  return "\"hogelscope\": " + std::to_string(documentVersion);
}

/// Reads [first, last] or [first, last, step].
FrameNumbers readFrames(const Json& list, const std::string& path) {
  const bool isList = list.is_array() && (list.size() == 2 || list.size() == 3);
  if (!isList)
    throw InputError(path, valueText(list) + " is not [first, last] or [first, last, step]");
  const int first = readIndex(list[0], path + "[0]");
  const int last = readIndex(list[1], path + "[1]");
  const int step = list.size() > 2 ? readIndex(list[2], path + "[2]") : 1;
  if (last < first || step < 1)
    throw InputError(path,
                     valueText(list) + " has no frame: give first ≤ last and a step of 1 or more");
  return framesBetween(first, last, step);
}

Json written(const FrameNumbers& frames) {
  const auto [first, last, step] = frames;
  return step == 1 ? Json{first, last} : Json{first, last, step};
}

std::vector<std::string> readNames(const Json& list, const std::string& path) {
  const char* const wanted = "is not a list of plugins' names: [\"ms-ssim\"]";
  if (!list.is_array()) throw InputError(path, wanted);
  std::vector<std::string> names;
  for (const Json& name : list) {
    if (!name.is_string()) throw InputError(path, wanted);
    names.push_back(name.get<std::string>());
  }
  return names;
}

/// Visits the light field of a display, whose calibration, if it is a lens sheet, completes the
/// light field's own.
void describeParts(SectionVisitor& v, LightFieldParams& params, const DisplayParams& display) {
  v.fields(params);
  v.value(
      "frames", params.frames.has_value(),
      [&](const Json& list, const std::string& path) { params.frames = readFrames(list, path); },
      [&] { return written(*params.frames); });
  for (std::string* const file : {&params.file, &params.lenslets.white, &params.lenslets.dark})
    v.file(*file);
  if (!display.sheet && !params.calibration) {
    v.refuse("calibration", "is for a lens sheet: a display of kind \"sheet\"");
  } else {
    SheetCalibration calibration =
        params.calibration ? *params.calibration : display.sheet->calibration;
    if (v.document("calibration", params.calibrationFile, params.calibration.has_value(),
                   [&] { v.parts(calibration); }))
      params.calibration = calibration;
  }
  if (!params.isLive() || params.source.empty()) return;
  if (!params.content.isGiven()) params.content = contentParamsOf(params.source);
  v.section(params.source, true, [&] {
    v.fields(params.content);
    v.files(params.content);
    v.fields(params.live);
  });
}

}  // namespace

void describeParts(SectionVisitor& v, DeadParts& dead) {
  visitList(v, "rows", dead.rows, "of numbers: [3, 17]", readIndex);
  visitList(v, "columns", dead.columns, "of numbers: [3, 17]", readIndex);
  visitList(v, "hogels", dead.hogels, "of hogels: [[3, 17]]", readHogel);
}

void describeParts(SectionVisitor& v, Session& session) {
  const auto readVersion = [](const Json& version, const std::string& path) {
    if (version != documentVersion)
      throw InputError(
          path, version.dump() + " is not a version that this program reads: " + wantedVersion());
  };
  if (!v.value("hogelscope", true, readVersion, [] { return Json(documentVersion); }))
    throw InputError("hogelscope", "is missing: a session says " + wantedVersion());
  v.section("display", session.display);
  v.document("twin", session.twinFile, session.twin != TwinParams{},
             [&] { v.parts(session.twin); });
  v.section("lightField", true, [&] { describeParts(v, session.lightField, session.display); });
  v.section("sampling", session.sampling);
  v.optional("depth", session.depth);
  v.optional("optimise", session.optimise);
  v.value(
      "metrics", !session.metrics.empty(),
      [&](const Json& names, const std::string& path) { session.metrics = readNames(names, path); },
      [&] { return Json(session.metrics); });
  v.list("cameras", session.cameras, "camera states");
}

}  // namespace hogelscope
