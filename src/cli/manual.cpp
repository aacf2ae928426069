// SPDX-License-Identifier: BSD-3-Clause
#include "cli/help.h"

#include <optional>

#include "core/base/text.h"
#include "core/cameras/camera_set.h"
#include "core/content/pattern.h"
#include "core/optics/session.h"
#include "io/documents/light_field_params.h"
#include "io/documents/session_parts.h"

namespace hogelscope {

namespace {

std::string listText(std::span<const std::string> items) {
  if (items.size() == 1) return items[0];
  std::string text = "[";
  for (const std::string& item : items) text += (text.size() > 1 ? ", " : "") + item;
  return text + "]";
}

/// Writes a row for each field: name, default, range, unit, help.
class ManualTable : public ParameterVisitor {
 public:
  explicit ManualTable(std::string heading) : m_heading(std::move(heading)) {}

  void group(std::string_view name, std::string_view help) override {
    m_text += "## " + (m_heading.empty() ? std::string(name) : m_heading) + "\n\n" +
              std::string(help) +
              "\n\n| field | default | allowed | unit | meaning |\n|---|---|---|---|---|\n";
  }

  [[nodiscard]] std::string text() const { return m_text + "\n"; }

 protected:
  void numbers(const Field& field, std::span<double> values, bool) override { row(field, values); }
  void integers(const Field& field, std::span<int> values, bool) override { row(field, values); }
  void flag(const Field& field, bool& value) override {
    add(field, value ? "true" : "false", "true, false");
  }
  void text(const Field& field, std::string&) override { add(field, "", "text"); }
  void choice(const Field& field, int& index) override {
    std::string allowed;
    for (const std::string_view name : field.choices)
      allowed += (allowed.empty() ? "" : ", ") + std::string(name);
    add(field, std::string(field.choices[std::size_t(index)]), allowed);
  }

 private:
  template <class Number>
  void row(const Field& field, std::span<Number> values) {
    const Range& range = field.range;
    std::vector<std::string> defaults;
    bool isGiven = true;
    for (const Number value : values) {
      defaults.push_back(numberText(value));
      isGiven = isGiven && value >= range.min && value <= range.max;
    }
    std::string allowed = numberText(range.min) + " … " + numberText(range.max);
    if (std::is_same_v<Number, int> && range.step > 1)
      allowed += " in steps of " + numberText(range.step);
    add(field, isGiven ? listText(defaults) : "not given", allowed);
  }

  void add(const Field& field, const std::string& value, const std::string& allowed) {
    m_text += "| `" + std::string(field.name) + "` | " + value + " | " + allowed + " | " +
              std::string(field.unit) + " | " + std::string(field.help) + " |\n";
  }

  std::string m_heading;
  std::string m_text;
};

template <class Params>
std::string table(Params params = {}, std::string heading = {}) {
  ManualTable visitor(std::move(heading));
  describe(visitor, params);
  return visitor.text();
}

std::string lightFieldTables() {
  const auto tableOf = [](Layout layout, const std::string& heading, const char* file = "") {
    LightFieldParams params;
    params.file = file;
    params.layout = layout;
    return table(params, heading);
  };
  std::string text;
  for (const Layout layout : {Layout::views, Layout::quilt, Layout::mosaic, Layout::lenslets})
    text += tableOf(layout, "lightField, layout " + std::string(nameOf(layout)));
  return text +
         tableOf(Layout::hogels, "lightField, a file of raw YUV, in any of these layouts",
                 "NAME.yuv") +
         tableOf(Layout::live, "lightField, layout live") +
         table<LiveParams>({}, "lightField, layout live: the object of the source's name");
}

std::string sheetTables() {
  DisplayParams display;
  display.sheet.emplace();
  return table(display, "display, kind sheet") +
         table<SheetParams>({}, "display.calibration and lightField.calibration, of a lens sheet");
}

/// The tables of a session with one state, in the order of documents.
class SessionTables : public SectionVisitor {
 public:
  SessionTables() {
    Session session;
    session.cameras.resize(1);
    parts(session);
  }
  [[nodiscard]] std::string text() {
    close();
    return m_text;
  }

 private:
  ParameterVisitor* fieldVisitor() override {
    close();
    return &m_table.emplace("");
  }
  bool begin(std::string_view name, bool /*isWritten*/) override {
    if (name == "calibration") return false;  // stands with the lens sheet's
    m_names.emplace_back(name);
    return true;
  }
  void end() override {
    close();
    // Forms of a section that its kind or layout decides follow it.
    if (m_names.back() == "display") m_text += sheetTables();
    if (m_names.back() == "lightField") m_text += lightFieldTables();
    m_names.pop_back();
  }
  void close() {
    if (m_table) m_text += m_table->text();
    m_table.reset();
  }

  std::string m_text;
  std::optional<ManualTable> m_table;
  std::vector<std::string> m_names;
};

}  // namespace

std::string parameterManual() {
  return "# Parameters of a session\n\n"
         "Made by `hogelscope --help parameters`. Any of them can be given on the command line as\n"
         "`--set section.field=value`; `camera`, `intrinsics`, `pupil`, `stereo`, `distortion` "
         "and `psf`\nthen go to every state. "
         "In a session document `camera`'s fields stand in the state itself, beside its\n"
         "`intrinsics`, `pupil`, `stereo`, `distortion` and `psf`.\n\n" +
         SessionTables().text() +
         "# Parameters of a camera set\n\n"
         "For `--make-cameras`, likewise with `--set`; none of them stands in a session.\n\n" +
         table<CameraSetParams>() + table<CameraRegionParams>() + table<TraceParams>() +
         "# Parameters of a pattern\n\n"
         "For `--generate`, likewise with `--set`; none of them stands in a session.\n\n" +
         table<PatternParams>();
}

}  // namespace hogelscope
