// SPDX-License-Identifier: BSD-3-Clause
// Wrappers of plugins' objects that the program calls instead.
#include "io/plugins/plugin_guard.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/text.h"
#include "io/files/system_limits.h"

namespace hogelscope {

namespace {

/// Remembers that the plugin was cancelled, after which its exceptions are not errors.
class HeardProgress final : public plugin::Progress {
 public:
  explicit HeardProgress(const plugin::Progress& progress) : m_progress(progress) {}
  [[nodiscard]] bool go(double done) const override {
    const bool isOn = m_progress.go(done);
    if (!isOn) m_wasStopped = true;
    return isOn;
  }
  [[nodiscard]] bool wasStopped() const { return m_wasStopped; }

 private:
  const plugin::Progress& m_progress;
  mutable std::atomic<bool> m_wasStopped = false;
};

/// Checks the indices, because the 3-D scene uses them without checks.
void checkTriangles(const std::string& name, const plugin::Triangles& triangles) {
  const auto& [points, corners, colours] = triangles;
  const std::size_t count = points.size() / 3;
  if (points.size() % 3 != 0 || corners.size() % 3 != 0 || colours.size() != points.size() ||
      std::ranges::any_of(corners, [count](std::uint32_t corner) { return corner >= count; }))
    throw pluginError(name,
                      "its triangles are not three numbers and colours for each point and "
                      "three points for each triangle");
}

/// Sets the memory limit, which core, where lenses are opened, does not know.
plugin::Place allowed(plugin::Place place) {
  place.memory = allowedMemory();
  return place;
}

/// Returns the text on one line of at most some hundred characters.
std::string oneLine(std::string text) {
  constexpr std::size_t longest = 400;
  if (text.size() > longest) text = text.substr(0, longest) + "…";
  std::ranges::replace(text, '\n', ' ');
  while (text.ends_with(' ')) text.pop_back();
  return text;
}

class GuardedContent final : public plugin::ContentSource {
 public:
  GuardedContent(std::string name, std::unique_ptr<plugin::ContentSource> content)
      : m_name(std::move(name)), m_content(std::move(content)) {}

  void describe(ParameterVisitor& v) override {
    guarded(m_name, [&] { m_content->describe(v); });
  }
  void open(const plugin::Panel& panel, const plugin::Place& place,
            const plugin::Progress& progress) override {
    const HeardProgress heard(progress);
    try {
      guarded(m_name, [&] { m_content->open(panel, allowed(place), heard); });
    } catch (const InputError&) {
      if (heard.wasStopped()) throw Cancelled();
      throw;
    }
  }
  [[nodiscard]] std::vector<std::string> files() const override {
    return guarded(m_name, [&] { return m_content->files(); });
  }
  void depths(double& back, double& front) const override {
    guarded(m_name, [&] { m_content->depths(back, front); });
    if (!(back <= front)) throw pluginError(m_name, "its depths are not back ≤ front");
  }
  [[nodiscard]] std::vector<std::string> notes() const override {
    std::vector<std::string> notes = guarded(m_name, [&] { return m_content->notes(); });
    constexpr std::size_t most = 50;
    notes.resize(std::min(notes.size(), most));
    for (std::string& note : notes) note = printable(oneLine(std::move(note)));
    return notes;
  }
  void trace(std::span<const plugin::Ray> rays, std::span<plugin::Colour> colours) const override {
    guarded(m_name, [&] { m_content->trace(rays, colours); });
  }
  [[nodiscard]] bool traceDepths(std::span<const plugin::Ray> rays,
                                 std::span<double> depths) const override {
    return guarded(m_name, [&] { return m_content->traceDepths(rays, depths); });
  }
  [[nodiscard]] plugin::Triangles triangles() const override {
    plugin::Triangles triangles = guarded(m_name, [&] { return m_content->triangles(); });
    checkTriangles(m_name, triangles);
    return triangles;
  }
  [[nodiscard]] double duration() const override {
    const double seconds = guarded(m_name, [&] { return m_content->duration(); });
    if (!(seconds >= 0 && std::isfinite(seconds)))
      throw pluginError(m_name, "its duration is no number of seconds");
    return seconds;
  }
  void setTime(double seconds) override {
    guarded(m_name, [&] { m_content->setTime(seconds); });
  }

 private:
  std::string m_name;
  std::unique_ptr<plugin::ContentSource> m_content;
};

class GuardedLens final : public plugin::HogelLens {
 public:
  GuardedLens(std::string name, std::unique_ptr<plugin::HogelLens> lens)
      : m_name(std::move(name)), m_lens(std::move(lens)) {}

  void describe(ParameterVisitor& v) override {
    guarded(m_name, [&] { m_lens->describe(v); });
  }
  void open(std::int32_t axis, double fov, const plugin::Place& place) override {
    guarded(m_name, [&] { m_lens->open(axis, fov, allowed(place)); });
  }
  [[nodiscard]] double directionOf(double slope) const override {
    return guarded(m_name, [&] { return m_lens->directionOf(slope); });
  }
  [[nodiscard]] double slopeOf(double direction) const override {
    return guarded(m_name, [&] { return m_lens->slopeOf(direction); });
  }

 private:
  std::string m_name;
  std::unique_ptr<plugin::HogelLens> m_lens;
};

class GuardedMetric final : public plugin::Metric {
 public:
  GuardedMetric(std::string name, std::unique_ptr<plugin::Metric> metric)
      : m_name(std::move(name)), m_metric(std::move(metric)) {}

  [[nodiscard]] const char* title() const override {
    return present(guarded(m_name, [&] { return m_metric->title(); }), "title");
  }
  [[nodiscard]] const char* unit() const override {
    return present(guarded(m_name, [&] { return m_metric->unit(); }), "unit");
  }
  [[nodiscard]] std::int32_t decimals() const override {
    const std::int32_t digits = guarded(m_name, [&] { return m_metric->decimals(); });
    if (digits < 0 || digits > 9) throw pluginError(m_name, "its decimals are not 0 to 9");
    return digits;
  }
  [[nodiscard]] double compare(const plugin::View& reference, const plugin::View& test,
                               const plugin::Viewing& viewing) const override {
    return guarded(m_name, [&] { return m_metric->compare(reference, test, viewing); });
  }
  [[nodiscard]] bool hasSeen() const override {
    return guarded(m_name, [&] { return m_metric->hasSeen(); });
  }
  [[nodiscard]] plugin::Figures compareBoth(const plugin::View& reference, const plugin::View& test,
                                            const plugin::Viewing& viewing) const override {
    // Pictures that take too much memory are no fault of the plugin.
    const auto figures = guarded(m_name, [&]() -> std::optional<plugin::Figures> {
      try {
        return m_metric->compareBoth(reference, test, viewing);
      } catch (const std::bad_alloc&) {
        return std::nullopt;
      }
    });
    if (!figures) throw std::bad_alloc();
    return *figures;
  }

 private:
  /// Checks a text that tables show.
  [[nodiscard]] const char* present(const char* text, const char* what) const {
    const auto isControl = [](unsigned char c) { return c < 32 || c == 127; };
    const std::string_view view = text == nullptr ? "\n" : text;
    if (view.size() <= 40 && std::ranges::none_of(view, isControl)) return text;
    throw pluginError(m_name, std::string("its ") + what + " is not a line of 40 letters");
  }

  std::string m_name;
  std::unique_ptr<plugin::Metric> m_metric;
};

}  // namespace

InputError pluginError(const std::string& name, std::string why) {
  why = oneLine(std::move(why));
  return {"plugin " + name, why.empty() ? "throws without saying why" : why};
}

std::unique_ptr<plugin::ContentSource> guardedContent(
    std::string name, std::unique_ptr<plugin::ContentSource> content) {
  return std::make_unique<GuardedContent>(std::move(name), std::move(content));
}

std::unique_ptr<plugin::HogelLens> guardedLens(std::string name,
                                               std::unique_ptr<plugin::HogelLens> lens) {
  return std::make_unique<GuardedLens>(std::move(name), std::move(lens));
}

std::unique_ptr<plugin::Metric> guardedMetric(std::string name,
                                              std::unique_ptr<plugin::Metric> metric) {
  return std::make_unique<GuardedMetric>(std::move(name), std::move(metric));
}

}  // namespace hogelscope
