// SPDX-License-Identifier: BSD-3-Clause
// The plugin SDK: the only header that a plugin of Hogelscope includes. It is header-only, so a
// plugin links nothing of Hogelscope. Any change to this file, or to core/base/parameters.h and
// core/base/geometry.h, which it includes, needs a new `abi` (tests/plugins/sdk.sha256).
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "core/base/parameters.h"

namespace hogelscope::plugin {
inline namespace v3 {

constexpr std::uint32_t abi = 3;

/// Red, green, blue in sRGB-encoded code values: 0 … 255 is the range of an 8-bit image.
struct Colour {
  float r = 0;
  float g = 0;
  float b = 0;
};

/// A ray of light, followed from the viewer's side: the points (x − a t, y − b t, z − t) for 0 ≤ t
/// ≤ reach. Metres in the display frame (docs/formulas.md, Display): x to the right, y up, z from
/// the panel to the viewer. a = dx/dz and b = dy/dz are the light's slopes.
struct Ray {
  double x = 0;
  double y = 0;
  double z = 0;
  double a = 0;
  double b = 0;
  double reach = 0;
};

/// The display that shows the content: the panel's size in metres, hogel and direction counts.
struct Panel {
  double size[2];
  std::int32_t hogels[2];
  std::int32_t directions[2];
  double slopeStep[2];  ///< range of slopes / directions: the mean width of a directional pixel
};

/// The environment of a plugin: the base folder of relative paths in parameters, the number of
/// threads that it may use, and the bytes of memory that it may hold in all.
struct Place {
  std::string folder;
  std::int32_t threads = 1;
  std::uint64_t memory = 0;
};

/// The progress listener of long work.
class Progress {
 public:
  /// Takes the fraction done, 0 … 1. Returns false to cancel; the callee then throws.
  [[nodiscard]] virtual bool go(double done) const = 0;

 protected:
  ~Progress() = default;
};

/// Triangles for the 3-D scene: x, y, z of each point in the display frame in metres, three indices
/// for each triangle, 8-bit RGB of each point.
struct Triangles {
  std::vector<float> points;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint8_t> colours;
};

/// Content that is computed on request of a view: a 3-D scene. describe(), open() and setTime() are
/// called by one thread while no other function runs; all others may be called from several threads
/// at once.
/// A thrown exception (std::exception) is shown to the user as one line, so its what() names the
/// file or the parameter and the remedy.
class ContentSource {
 public:
  virtual ~ContentSource() = default;

  /// Visits the parameters for JSON, forms, help and the manual.
  virtual void describe(ParameterVisitor& v) = 0;
  /// Prepares the content for its parameters; called again after each edit.
  virtual void open(const Panel& panel, const Place& place, const Progress& progress) = 0;
  /// Returns the files that open() has read.
  [[nodiscard]] virtual std::vector<std::string> files() const { return {}; }
  /// Returns a sentence for each part of the files that is not shown, such as "Its 3 animations
  /// stay at rest."
  [[nodiscard]] virtual std::vector<std::string> notes() const { return {}; }
  /// Sets the range of depths z of the content, back ≤ front.
  virtual void depths(double& back, double& front) const = 0;
  /// Sets the light of the first surface that each ray meets, or of the background. A ray's result
  /// does not depend on other rays of the call. Neighbours in the list are near each other. Both
  /// spans have one size.
  virtual void trace(std::span<const Ray> rays, std::span<Colour> colours) const = 0;
  /// Sets the depth z of the first point that each ray meets, in the display frame; NaN if it meets
  /// nothing. Both spans have one size. Returns false, and sets nothing, if the content does not
  /// know its depths.
  [[nodiscard]] virtual bool traceDepths(std::span<const Ray> /*rays*/,
                                         std::span<double> /*depths*/) const {
    return false;
  }
  /// Returns the triangles that the 3-D scene draws.
  [[nodiscard]] virtual Triangles triangles() const { return {}; }
  /// Returns how many seconds its animation lasts, as open() has prepared it; 0 if it does not
  /// move.
  [[nodiscard]] virtual double duration() const { return 0; }
  /// Shows it at a time, 0 … duration(); open() shows the time 0. A time's content does not depend
  /// on the times before it.
  virtual void setTime(double /*seconds*/) {}
};

/// One axis of a hogel's lens: a continuous, strictly increasing function. All functions except
/// describe() and open() may be called from several threads.
class HogelLens {
 public:
  virtual ~HogelLens() = default;
  virtual void describe(ParameterVisitor& v) = 0;
  /// Prepares the lens across (axis 0) or down (axis 1); `fov` is the full angle of the field in
  /// degrees.
  virtual void open(std::int32_t axis, double fov, const Place& place) = 0;
  /// Returns the coordinate in the angular field, −1/2 … 1/2, of light with a slope (dx/dz to the
  /// right, dy/dz up).
  [[nodiscard]] virtual double directionOf(double slope) const = 0;
  /// Returns the inverse of directionOf().
  [[nodiscard]] virtual double slopeOf(double direction) const = 0;
};

/// A view for a metric: width·height pixels, starting at the top left. `values` are the same RGB
/// before rounding, in the code values of a Colour. `seen` is not 0 for pixels that see the
/// display.
struct View {
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::span<const std::uint8_t> rgb;
  std::span<const float> values;
  std::span<const std::uint8_t> seen;
};

/// The viewing geometry of the views; NaN if unknown.
struct Viewing {
  double pixelsPerDegree;  ///< of the field of view, in the middle of the image
  double distance;         ///< from the eye to the panel's centre, in metres
};

/// The figures of a metric: over the whole frame, and over the pixels that see the display in both
/// views. NaN: not defined.
struct Figures {
  double frame = std::numeric_limits<double>::quiet_NaN();
  double seen = std::numeric_limits<double>::quiet_NaN();
};

/// A metric of the difference between a test and a reference. compare() and compareBoth() may be
/// called from several threads.
class Metric {
 public:
  virtual ~Metric() = default;
  /// Returns the title in tables, such as "MS-SSIM"; then its unit and the digits after the point.
  [[nodiscard]] virtual const char* title() const = 0;
  [[nodiscard]] virtual const char* unit() const { return ""; }
  [[nodiscard]] virtual std::int32_t decimals() const { return 2; }
  /// Compares views of one size. Returns NaN if the metric is not defined.
  [[nodiscard]] virtual double compare(const View& reference, const View& test,
                                       const Viewing& viewing) const = 0;
  /// Returns whether compareBoth() has a figure of the pixels seen, which then has a column too.
  [[nodiscard]] virtual bool hasSeen() const { return false; }
  /// Compares as compare() does, which gives the figure over the frame.
  [[nodiscard]] virtual Figures compareBoth(const View& reference, const View& test,
                                            const Viewing& viewing) const {
    Figures figures;
    figures.frame = compare(reference, test, viewing);
    return figures;
  }
};

/// The type of the library's only symbol: numbers that are read before any code of the plugin runs,
/// its name (of the session's entries and the CSV's column), and a function for each object that it
/// offers, null for the others.
struct Entry {
  std::uint32_t abi;
  const char* build;  ///< HOGELSCOPE_PLUGIN_BUILD
  const char* name;
  const char* version;
  ContentSource* (*content)();
  HogelLens* (*lens)();
  Metric* (*metric)();
};

}  // namespace v3
}  // namespace hogelscope::plugin

#define HOGELSCOPE_TEXT_OF(x) #x
#define HOGELSCOPE_TEXT(x) HOGELSCOPE_TEXT_OF(x)
/// The C++ ABI of the compiler and of libstdc++, which host and plugin must share.
#define HOGELSCOPE_PLUGIN_BUILD \
  "gxx" HOGELSCOPE_TEXT(__GXX_ABI_VERSION) "-cxx11abi" HOGELSCOPE_TEXT(_GLIBCXX_USE_CXX11_ABI)
#define HOGELSCOPE_PLUGIN(...)                                    \
  extern "C" __attribute__((visibility("default")))               \
  const hogelscope::plugin::Entry hogelscope_plugin {             \
    hogelscope::plugin::abi, HOGELSCOPE_PLUGIN_BUILD, __VA_ARGS__ \
  }
