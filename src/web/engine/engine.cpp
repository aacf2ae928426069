// SPDX-License-Identifier: BSD-3-Clause
// The core behind a C interface for a page (resources/web/engine.js): light fields, one state, one
// renderer. Parameters have the names, and are checked by the ranges, that `describe` says.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/engine/focus_search.h"
#include "core/engine/renderer.h"
#include "core/metrics/error_map.h"
#include "core/metrics/squared_error.h"
#include "core/optics/eyes.h"
#include "core/optics/pixel_inspection.h"
#include "core/optics/scene_eyes.h"
#include "core/optics/session.h"
#include "core/optics/stereo_image.h"

using namespace hogelscope;

namespace {

std::vector<std::shared_ptr<LightField>> theFields;
Session theSession;
std::string theText;  ///< that the last function returned
std::vector<std::uint8_t> thePicture, theMask;
int theWidth = 0;

Renderer& renderer() {
  static Renderer only(serialRows);
  return only;
}

CameraState& state() {
  return theSession.cameras.front();
}

/// Calls `use` with the parameters of a section of a session's document.
template <class Use>
bool withSection(const std::string& name, Use use) {
  if (name == "display") return use(theSession.display), true;
  if (name == "sampling") return use(theSession.sampling), true;
  if (name == "camera") return use(state().camera), true;
  if (name == "intrinsics") return use(state().intrinsics), true;
  if (name == "distortion") return use(state().distortion), true;
  if (name == "psf") return use(state().psf), true;
  if (name == "pupil") return use(state().pupil), true;
  if (name == "stereo") return use(state().stereo), true;
  return false;
}

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

/// Sets one field. `why` is empty if it was found and may have the value.
class Setter : public ParameterVisitor {
 public:
  Setter(std::string field, std::span<const double> numbers, std::string words)
      : m_field(std::move(field)), m_numbers(numbers), m_words(std::move(words)) {}

  void group(std::string_view /*name*/, std::string_view /*help*/) override {}
  [[nodiscard]] const std::string& why() const { return m_why; }

 protected:
  void numbers(const Field& field, std::span<double> values, bool /*isList*/) override {
    take(field, values);
  }
  void integers(const Field& field, std::span<int> values, bool /*isList*/) override {
    take(field, values);
  }
  void flag(const Field& field, bool& value) override {
    if (field.name != m_field) return;
    m_why.clear();
    if (!m_numbers.empty()) value = m_numbers[0] != 0;
  }
  void text(const Field& field, std::string& value) override {
    if (field.name != m_field) return;
    m_why.clear();
    value = m_words;
  }
  void choice(const Field& field, int& index) override {
    if (field.name != m_field) return;
    m_why = quoted(m_words) + " is not one of its choices";
    for (std::size_t k = 0; k < field.choices.size(); ++k)
      if (field.choices[k] == m_words) {
        index = int(k);
        m_why.clear();
      }
  }

 private:
  template <class Number>
  void take(const Field& field, std::span<Number> values) {
    if (field.name != m_field) return;
    m_why = "is not " + std::to_string(values.size()) + " number(s)";
    if (values.size() != m_numbers.size()) return;
    const Range& range = field.range;
    for (const double number : m_numbers) {
      const bool isWhole = std::is_same_v<Number, double> || number == std::floor(number);
      const bool isStep =
          std::is_same_v<Number, double> || std::fmod(number - range.min, range.step) == 0;
      m_why = numberText(number) + " is not one of " + numberText(range.min) + " to " +
              numberText(range.max) + " " + std::string(field.unit);
      if (!(number >= range.min && number <= range.max) || !isWhole || !isStep) return;
    }
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = Number(m_numbers[k]);
    m_why.clear();
  }

  std::string m_field;
  std::span<const double> m_numbers;
  std::string m_words;
  std::string m_why = "is not known here";
};

/// Writes the fields of a section as JSON.
class Teller : public ParameterVisitor {
 public:
  void group(std::string_view /*name*/, std::string_view /*help*/) override {}
  [[nodiscard]] std::string json() const { return "[" + m_json + "]"; }

 protected:
  void numbers(const Field& field, std::span<double> values, bool /*isList*/) override {
    add(field, values, R"("real")");
  }
  void integers(const Field& field, std::span<int> values, bool /*isList*/) override {
    add(field, values, R"("integer")");
  }
  void flag(const Field& /*field*/, bool& /*value*/) override {}
  void text(const Field& /*field*/, std::string& /*value*/) override {}
  void choice(const Field& field, int& index) override {
    std::string names;
    for (const std::string_view name : field.choices)
      names += (names.empty() ? "" : ",") + quoted(name);
    begin(field);
    m_json += R"(,"choices":[)" + names + R"(],"value":)" +
              quoted(field.choices[std::size_t(index)]) + "}";
  }

 private:
  void begin(const Field& field) {
    if (!m_json.empty()) m_json += ",\n";
    m_json += R"({"name":)" + quoted(field.name) + R"(,"label":)" + quoted(field.label) +
              R"(,"help":)" + quoted(field.help) + R"(,"counts":)" +
              (field.counts ? "true" : "false");
  }
  template <class Number>
  void add(const Field& field, std::span<Number> values, const char* type) {
    begin(field);
    const Range& range = field.range;
    const bool hasSlide = range.slideMax > range.slideMin;
    m_json += R"(,"type":)" + std::string(type) + R"(,"unit":)" + quoted(field.unit) +
              R"(,"min":)" + numberText(range.min) + R"(,"max":)" + numberText(range.max) +
              R"(,"slide":[)" + numberText(hasSlide ? range.slideMin : range.min) + "," +
              numberText(hasSlide ? range.slideMax : range.max) + R"(],"step":)" +
              numberText(range.step) + R"(,"value":[)";
    for (std::size_t k = 0; k < values.size(); ++k) {
      const bool isGiven = values[k] >= range.min && values[k] <= range.max;
      m_json += (k > 0 ? "," : "") + (isGiven ? numberText(double(values[k])) : "null");
    }
    m_json += "]}";
  }

  std::string m_json;
};

/// The view of the state with one of the light fields.
RenderJob jobOf(int field) {
  check(theSession);
  RenderJob job;
  job.lightField = theFields.at(std::size_t(field));
  job.display = resolved(displayOf(theSession), job.lightField->size());
  job.sampling = theSession.sampling;
  job.state = state();
  return job;
}

Image ofEye(RenderJob job, Eye eye) {
  job.state = eyeOf(job.state, job.display, eye);
  return renderer().render(job);
}

/// What a picture shows: the state itself, an eye of its head, or both eyes in a StereoMode.
enum Show { itself, leftEye, rightEye, bothEyes };

Image shown(RenderJob job, int what) {
  if (what == leftEye) return ofEye(job, Eye::left);
  if (what == rightEye) return ofEye(job, Eye::right);
  if (what >= bothEyes)
    return stereoImage(ofEye(job, Eye::left), ofEye(job, Eye::right),
                       static_cast<StereoMode>(what - bothEyes));
  job.state.stereo = {};
  return renderer().render(job);
}

void keep(const Image& image, int width) {
  const std::size_t count = image.seen.size();
  thePicture.resize(4 * count);
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t c = 0; c < 3; ++c) thePicture[4 * k + c] = image.rgb[3 * k + c];
    thePicture[4 * k + 3] = 255;
  }
  theMask = image.seen;
  theWidth = width;
}

std::string words(const RenderJob& job, int x, int y) {
  const PixelTrace trace = pixelTrace(job, x, y);
  std::string text;
  switch (fateOf(trace)) {
    case PixelFate::noRay:
    case PixelFate::outside:
      text = "black: " + std::string(words(trace.end));
      break;
    case PixelFate::dark:
      text = "black: the content is black here";
      break;
    case PixelFate::lit:
      text = "seen";
  }
  if (trace.place)
    text += "; hogel " + std::to_string(int(std::floor(trace.place->i))) + ", " +
            std::to_string(int(std::floor(trace.place->j))) + ", direction " +
            std::to_string(int(std::floor(trace.place->u))) + ", " +
            std::to_string(int(std::floor(trace.place->v)));
  return text;
}

}  // namespace

// All functions throw errors of JavaScript for what the core throws.
extern "C" {

const char* hs_version() {
  theText = programVersion();
  return theText.c_str();
}

void* hs_alloc(std::size_t bytes) {
  return std::malloc(bytes);
}

void hs_free(void* memory) {
  std::free(memory);
}

/// Makes light field `index` a black one of this size.
void hs_field(int index, int nx, int ny, int du, int dv) {
  if (index >= int(theFields.size())) theFields.resize(std::size_t(index) + 1);
  theFields[std::size_t(index)].reset();
  theFields[std::size_t(index)] =
      std::make_shared<LightField>(LightFieldSize{nx, ny, du, dv}, StoredType::uint8);
}

/// Copies a row j of a view: nx RGBA pixels.
void hs_view_row(int index, int u, int v, int j, const std::uint8_t* rgba) {
  LightField& field = *theFields.at(std::size_t(index));
  for (int i = 0; i < field.size().nx; ++i) field.set(TexelIndex{i, j, u, v}, rgba + 4 * i);
}

/// FNV-1a, 32 bits, over R, G, B of the image of hogels, row by row.
std::uint32_t hs_hash(int index) {
  std::uint32_t hash = 2166136261U;
  const LightField& field = *theFields.at(std::size_t(index));
  const auto [nx, ny, du, dv] = field.size();
  for (int y = 0; y < ny * dv; ++y)
    for (int x = 0; x < nx * du; ++x) {
      const Rgb c = field.texel({x / du, y / dv, x % du, y % dv});
      for (const double value : {c.r, c.g, c.b}) hash = (hash ^ std::uint32_t(value)) * 16777619U;
    }
  return hash;
}

/// Gives the state, and the display with `isDisplay`, their defaults.
void hs_reset(int isDisplay) {
  theSession.cameras = {CameraState()};
  if (isDisplay == 0) return;
  theSession.display = {};
  theSession.sampling = {};
  theSession.lightField = {};
  theSession.lightField.file = "page";  // rules of sessions want a name
}

/// Sets a field of a section of a session's document to numbers, or to words if there are none.
/// Returns what is wrong, "" if nothing.
const char* hs_set(const char* section, const char* field, const double* values, int count,
                   const char* words) {
  const std::string at(section), name(field);
  if (at == "lightField" && name == "viewingDistance" && count == 1) {
    theSession.lightField.viewingDistance = values[0];
    return "";
  }
  theText = at + " is not known here";
  withSection(at, [&](auto& params) {
    Setter setter(name, std::span(values, std::size_t(count)), words);
    describe(setter, params);
    theText = setter.why().empty() ? "" : at + "." + name + ": " + setter.why();
  });
  return theText.c_str();
}

/// Returns a section's fields as JSON: a list of name, label, help, unit, range and value.
const char* hs_fields(const char* section) {
  Teller teller;
  withSection(section, [&](auto& params) { describe(teller, params); });
  theText = teller.json();
  return theText.c_str();
}

/// Renders what `show` says with a light field; hs_picture() and the like then have it.
void hs_render(int index, int show) {
  const RenderJob job = jobOf(index);
  const Image image = shown(job, show);
  keep(image, int(image.seen.size()) / job.state.camera.res[1]);
}

/// Renders what `show` says with light field 0 and another one, and keeps the map of their error,
/// the mean of the channels times 4 in false colours. Returns the PSNR over the pixels seen in
/// both, in dB; NaN if there is none.
double hs_compare(int test, int show) {
  const RenderJob job = jobOf(0);
  const Image reference = shown(job, show);
  Image image = shown(jobOf(test), show);
  const double result = psnr(squaredError(reference, image).mseSeen);
  std::vector<std::uint8_t> map(image.rgb.size());
  ErrorMap({.kind = ErrorKind::absolute, .tone = {.gain = 4}, .hasFalseColour = true})
      .write(reference.rgb, image.rgb, map);
  for (std::size_t k = 0; k < image.seen.size(); ++k) {
    const bool isSeen = reference.seen[k] != 0 && image.seen[k] != 0;
    for (std::size_t c = 3 * k; c < 3 * k + 3; ++c) image.rgb[c] = isSeen ? map[c] : 0;
    image.seen[k] = isSeen ? 255 : 0;
  }
  keep(image, int(image.seen.size()) / job.state.camera.res[1]);
  return result;
}

/// Renders the panel as the state's eye sees it, which is given in the panel's frame, width ×
/// height over all of it, as the texture of a rectangle. Returns 0 if the eye is not before it.
int hs_panel(int index, int width, int height) {
  RenderJob job = jobOf(index);
  const Vec3 eye =
      transformFromPose(job.display.position, job.display.orientation).point(job.state.camera.eye);
  std::optional<CameraState> panel = panelState(job.display, eye, {width, height});
  if (!panel) return 0;
  panel->psf = job.state.psf;
  job.state = *panel;
  keep(renderer().render(job), width);
  return 1;
}

const std::uint8_t* hs_picture() {
  return thePicture.data();
}
const std::uint8_t* hs_mask() {
  return theMask.data();
}
int hs_width() {
  return theWidth;
}

/// Returns what pixel (x, y) of the state shows, and why it is black.
const char* hs_why(int index, int x, int y) {
  theText = words(jobOf(index), x, y);
  return theText.c_str();
}

/// Returns the focus of a state with a pupil at which pixel (x, y) is sharp, in metres; NaN if
/// there is no contrast.
double hs_focus(int index, int x, int y) {
  return sharpestFocus(jobOf(index), x, y, renderer().tables(), serialRows)
      .value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // extern "C"
