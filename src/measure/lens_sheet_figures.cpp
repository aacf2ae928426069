// SPDX-License-Identifier: BSD-3-Clause
// What a lens sheet shows of its views, counted over rays: views per metre, flips, cone, crosstalk
// of views and of two eyes. The names of figures that displays of hogels have too mean the same.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>

#include "core/base/bisect.h"
#include "core/base/text.h"
#include "core/panel/sheet_numbers.h"
#include "measure/contrast.h"
#include "measure/measurement.h"

namespace hogelscope {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinite = std::numeric_limits<double>::infinity();

std::string metres(double value) {
  return numberText(fourDigits(value)) + " m";
}

/// A part of the panel: points that are even over its height and, across the lenses, its width.
struct Spot {
  Vec2 middle;
  double width;
  double height;
  double lean;  ///< x for each y: −1/slope along the lenses
  int rays = 4096;
};

/// Figures and letters of a bench's sheet.
struct Sheet {
  explicit Sheet(const Bench& bench)
      : display(*bench.display().sheet),
        views(bench.display().directions[0]),
        perSlope(1 / display.calibration.params.slope),
        size(bench.display().size) {}
  [[nodiscard]] SheetNumbers numbers(const Vec3& eye) const {
    return sheetNumbers(display, views, eye);
  }
  /// A few lenses in the panel's middle, along most of its height: many phases of pixels to lenses,
  /// and hardly more than one view to the eye.
  [[nodiscard]] Spot middle(const Bench& bench) const {
    const double turning = std::abs(numbers(bench.eye()).viewsPerPanelMetre);
    return {
        {}, std::min({24 * bench.pitch(0), size[0] / 2, 0.3 / turning}), 0.8 * size[1], -perSlope};
  }
  const SheetDisplay& display;
  int views;
  double perSlope;
  std::array<double, 2> size;
};

/// Calls `use` with the view 0 … N that an eye sees at each point of a spot in green, and with that
/// of the place at which its ray crosses the viewing distance, which goes on beyond the cone.
template <class Use>
void forViews(const Bench& bench, const Vec3& eye, const Spot& spot, const Use& use) {
  constexpr std::size_t green = 1;
  constexpr int parts = 1 << 24;
  const Sheet of(bench);
  const LensSheet& sheet = *bench.sheet();
  const double distance = of.display.viewingDistance;
  const double perCrossing = of.views * sheet.gap() / (sheet.period() * distance);
  const auto [columns, rows] = of.display.calibration.params.panel;
  const std::vector<double>& weights = sheet.spot();
  for (int ray = 1; ray <= spot.rays; ++ray) {
    // The R2 sequence: M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018.
    const double u = std::fmod(0.7548776662466927 * ray, 1) - 0.5;
    const double up = spot.height * (std::fmod(0.5698402909980532 * ray, 1) - 0.5);
    const Vec3 point{spot.middle.x + spot.width * u + spot.lean * up, spot.middle.y + up, 0};
    const auto hit = sheet.meet(eye, point - eye, green);
    if (!hit) continue;
    // Of the spot, each ray has one of its pixels, as often as the pixel's weight says.
    double column = hit->column - double(weights.size() / 2);
    double rest = std::fmod(0.6180339887498949 * ray, 1);
    for (auto weight = weights.begin(); weight != weights.end() && rest >= *weight; ++weight) {
      rest -= *weight;
      ++column;
    }
    if (column < 0 || column >= columns || hit->row < 0 || hit->row >= rows) continue;
    const int part = sheet.viewOf(int(column), int(hit->row), green, parts);
    const double turned = (eye.x - point.x + (eye.y - point.y) * of.perSlope) / eye.z;
    const double crossing = point.x + point.y * of.perSlope + distance * turned;
    use(of.views * (part + 0.5) / parts, of.views / 2.0 + perCrossing * crossing);
  }
}

/// Returns the mean of the views, on their circle; 0 … N.
double meanView(const Bench& bench, const Vec3& eye, const Spot& spot) {
  const int views = Sheet(bench).views;
  std::complex<double> sum;
  forViews(bench, eye, spot,
           [&](double view, double /*own*/) { sum += std::polar(1.0, 2 * pi * view / views); });
  return std::fmod(std::arg(sum) / (2 * pi) + 1, 1) * views;
}

/// Returns the share of a spot that shows what is at the eye's own place, not N views aside.
double shareOwn(const Bench& bench, const Vec3& eye, const Spot& spot) {
  const double half = Sheet(bench).views / 2.0;
  double inside = 0;
  double count = 0;
  forViews(bench, eye, spot, [&](double view, double own) {
    inside += std::abs(view - own) < half ? 1 : 0;
    ++count;
  });
  return inside / count;
}

/// Returns the share of a spot's light that is of views from `first` to before `last`.
double shareOfViews(const Bench& bench, const Vec3& eye, double first, double last) {
  double inside = 0;
  double count = 0;
  forViews(bench, eye, Sheet(bench).middle(bench), [&](double view, double /*own*/) {
    inside += view >= first && view < last ? 1 : 0;
    ++count;
  });
  return inside / count;
}

/// Returns the eye's place to a side, −1 or 1, where half of a spot shows other views than its own.
double flipOf(const Bench& bench, const Vec3& eye, const Spot& spot, double side) {
  const Sheet of(bench);
  const SheetNumbers numbers = of.numbers(eye);
  const double across = spot.middle.x + spot.middle.y * of.perSlope;
  const double middle =
      (numbers.flips[0] + numbers.flips[1]) / 2 + across * (1 - eye.z / of.display.viewingDistance);
  const auto isOwn = [&](double x) { return shareOwn(bench, {x, eye.y, eye.z}, spot) >= 0.5; };
  const Bracket ends{middle + 0.3 * side * numbers.width(), middle + 0.7 * side * numbers.width()};
  if (!isOwn(ends.inside) || isOwn(ends.outside)) return noValue;
  return bisect(ends, 30, isOwn).middle();
}

void addViews(const Bench& bench, std::vector<Measurement>& all) {
  const Sheet of(bench);
  const Vec3 eye = bench.eye();
  const SheetNumbers numbers = of.numbers(eye);
  const std::string at = " z=" + metres(eye.z);
  const double middle = (numbers.flips[0] + numbers.flips[1]) / 2;
  all.push_back({"viewsPerMetre", "1/m", "to the eye's right" + at,
                 [=](Bench& b) {
                   const double move = 0.3 * numbers.width();
                   const auto viewAt = [&](double x) {
                     return meanView(b, {x, eye.y, eye.z}, Sheet(b).middle(b));
                   };
                   return (viewAt(middle + move) - viewAt(middle - move)) / (2 * move);
                 },
                 numbers.viewsPerMetre});
  all.push_back(
      {"viewsPerMetre", "1/m", "to the right along the panel" + at,
       [=](Bench& b) {
         Spot spot = Sheet(b).middle(b);
         const double turn = 0.3 * numbers.views / std::abs(numbers.viewsPerPanelMetre);
         const double move = std::min(
             0.45 * (b.display().size[0] - spot.width - std::abs(spot.lean) * spot.height), turn);
         const auto viewAt = [&](double x) {
           spot.middle.x = x;
           return meanView(b, {middle, eye.y, eye.z}, spot);
         };
         return (viewAt(move) - viewAt(-move)) / (2 * move);
       },
       numbers.viewsPerPanelMetre});
  all.push_back({"lobe", "views", "rms" + at,
                 [=](Bench& b) {
                   const Spot spot = Sheet(b).middle(b);
                   const double mean = meanView(b, eye, spot);
                   double squares = 0;
                   double count = 0;
                   forViews(b, eye, spot, [&](double view, double /*own*/) {
                     const double off = std::remainder(view - mean, numbers.views);
                     squares += off * off;
                     ++count;
                   });
                   return std::sqrt(squares / count);
                 },
                 numbers.lobe});
}

void addFlips(const Bench& bench, double ipd, std::vector<Measurement>& all) {
  const Vec3 eye = bench.eye();
  const SheetNumbers numbers = Sheet(bench).numbers(eye);
  const std::string at = " z=" + metres(eye.z);
  const auto flipAt = [eye](const Bench& b, double side) {
    return flipOf(b, eye, Sheet(b).middle(b), side);
  };
  const auto widthAt = [=](const Bench& b) { return flipAt(b, 1) - flipAt(b, -1); };
  all.push_back({"viewingCone", "°", "panel's middle",
                 [=](Bench& b) { return 360 / pi * std::atan(widthAt(b) / (2 * eye.z)); },
                 numbers.cone});
  all.push_back({"viewingCone", "m", "panel's middle" + at, widthAt, numbers.width()});
  all.push_back(
      {"flip", "m", "left x" + at, [=](Bench& b) { return flipAt(b, -1); }, numbers.flips[0]});
  all.push_back(
      {"flip", "m", "right x" + at, [=](Bench& b) { return flipAt(b, 1); }, numbers.flips[1]});
  all.push_back({"pseudoscopic", "", "share of heads" + at,
                 [=](Bench& b) {
                   constexpr int heads = 500;
                   Spot spot = Sheet(b).middle(b);
                   spot.rays = 1024;
                   int exchanged = 0;
                   for (int head = 0; head < heads; ++head) {
                     const double x = numbers.flips[0] + numbers.width() * (head + 0.5) / heads;
                     const double left = meanView(b, {x - ipd / 2, eye.y, eye.z}, spot);
                     const double right = meanView(b, {x + ipd / 2, eye.y, eye.z}, spot);
                     exchanged += left > right ? 1 : 0;
                   }
                   return double(exchanged) / heads;
                 },
                 ipd < numbers.width() ? numbers.pseudoscopic(ipd) : noValue});
}

/// The places from which no flip lies on the panel, and the share of it that none has passed.
void addWhole(const Bench& bench, std::vector<Measurement>& all) {
  const Sheet of(bench);
  const Vec3 eye = bench.eye();
  const double turned = std::abs(1 - eye.z / of.display.viewingDistance);
  const double panel = of.size[0] + std::abs(of.perSlope) * of.size[1];
  all.push_back(
      {"viewingZone", "m", "whole panel across z=" + metres(eye.z),
       [=](Bench& b) {
         const Sheet sheet(b);
         const double side = 8 * b.pitch(0);
         double low = -infinite;
         double high = infinite;
         for (const double right : {-0.5, 0.5})
           for (const double up : {-0.5, 0.5}) {
             const Spot corner{
                 {right * (sheet.size[0] - side), up * (sheet.size[1] - side)}, side, side, 0};
             low = std::max(low, flipOf(b, eye, corner, -1));
             high = std::min(high, flipOf(b, eye, corner, 1));
           }
         return std::max(high - low, 0.0);
       },
       std::max(of.numbers(eye).width() - panel * turned, 0.0)});
  constexpr int columns = 41;
  constexpr int rows = 25;
  const double reach = 1.2 * std::max(eye.z, of.size[0]);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double z = 2 * eye.z * (row + 0.5) / rows;
      const double x = reach * (2 * (column + 0.5) / columns - 1);
      all.push_back({"viewingZone", "", "share x=" + metres(x) + " z=" + metres(z),
                     [x, z](Bench& b) {
                       const auto& [width, height] = b.display().size;
                       return shareOwn(b, {x, 0, z}, {{}, width, height, 0, 2000});
                     },
                     shareInCone(of.display, {x, 0, z}), x, z});
    }
}

/// The left eye's crosstalk: views to the right of the border are the right eye's.
void addTwoEyes(const Bench& bench, double ipd, std::vector<Measurement>& all) {
  constexpr int steps = 9;
  const Vec3 head = bench.eye();
  const Sheet of(bench);
  const SheetNumbers numbers = of.numbers(head);
  const auto viewAt = [=](double x) {
    return numbers.views / 2.0 +
           (x - (numbers.flips[0] + numbers.flips[1]) / 2) * numbers.viewsPerMetre;
  };
  // The first view whose middle is to the right.
  const double border = std::clamp(std::ceil(viewAt(head.x) - 0.5), 0.0, double(numbers.views));
  const auto add = [&](int step) {
    const double x = 0.45 * ipd * step / steps;
    const double place = head.x + x - ipd / 2;
    Measurement one{"crosstalk", "", "x=" + metres(x), {}, noValue, x};
    one.simulate = [=](Bench& b) {
      const Vec3 left{place, head.y, head.z};
      return shareOfViews(b, left, border, numbers.views) / shareOfViews(b, left, 0, border);
    };
    const double at = viewAt(place);
    const double end = 2 * numbers.views;
    one.closedForm = lobeShare(of.display, numbers.views, border - at, end) /
                     lobeShare(of.display, numbers.views, -end, border - at);
    // Near a flip views of the cone's other end come in.
    if (at < 0.1 * numbers.views || at > 0.9 * numbers.views) one.closedForm = noValue;
    all.push_back(std::move(one));
  };
  add(0);  // the designated eye position comes first
  for (int step = -steps; step <= steps; ++step)
    if (step != 0) add(step);
}

/// The light of the middle view over the eye's angle, as a part of that in its middle.
void addProfile(const Bench& bench, std::vector<Measurement>& all) {
  constexpr int perView = 8;
  const Sheet of(bench);
  const Vec3 eye = bench.eye();
  const SheetNumbers numbers = of.numbers(eye);
  const int lit = numbers.views / 2;
  const int reach = std::min(int(std::ceil(2 * numbers.lobe)) + 1, numbers.views / 2 - 1);
  const double middle = (numbers.flips[0] + numbers.flips[1]) / 2;
  const auto placeOf = [=](double view) {
    return middle + (view - numbers.views / 2.0) / numbers.viewsPerMetre;
  };
  const auto angleOf = [=](double view) { return 180 / pi * std::atan2(placeOf(view), eye.z); };
  const auto seen = [=](const Bench& b, double view) {
    const auto light = [&](double place) {
      return shareOfViews(b, {placeOf(place), eye.y, eye.z}, lit, lit + 1);
    };
    return light(view) / light(lit + 0.5);
  };
  const auto form = [=](const Bench& b, double view) {
    const SheetDisplay& display = *b.display().sheet;
    return lobeShare(display, numbers.views, lit - view, lit + 1 - view) /
           lobeShare(display, numbers.views, -0.5, 0.5);
  };
  for (int k = -reach * perView; k < (reach + 1) * perView; ++k) {
    const double view = lit + (k + 0.5) / perView;
    const double angle = angleOf(view);
    all.push_back({"angularProfile", "", "angle=" + numberText(fourDigits(angle)) + "°",
                   [=](Bench& b) { return seen(b, view); }, form(bench, view), angle});
  }
  const auto widthOf = [=](const Bench& b, const auto& lightAt) {
    const auto edge = [&](double sign) {
      const double inside = lit + 0.5;
      const Bracket ends{inside, inside + sign * (reach + 1)};
      return angleOf(bisect(ends, 30, [&](double at) { return lightAt(b, at) >= 0.5; }).inside);
    };
    return edge(1) - edge(-1);
  };
  all.push_back({"angularProfile", "°", "full width at half maximum",
                 [=](Bench& b) { return widthOf(b, seen); }, widthOf(bench, form)});
}

/// The depths at which the picture shifts by a lens from one view to the next.
void addDepthsOfViews(const Bench& bench, std::vector<Measurement>& all) {
  const double distance = bench.distance();
  const double period = bench.pitch(0);
  const SheetNumbers numbers = Sheet(bench).numbers(bench.eye());
  for (const bool isFront : {true, false}) {
    const double form = isFront ? numbers.viewsFront : numbers.viewsBehind;
    all.push_back(
        {isFront ? "viewsFront" : "viewsBehind", "m", "z=" + metres(distance),
         [=](Bench& b) {
           if (std::isinf(form)) return noValue;
           const auto isLess = [&](double z) { return std::abs(shiftOfViews(b, z)) < period; };
           const double far = std::min(isFront ? 1.5 * form : -1.5 * form, 0.9 * distance);
           return std::abs(bisect({0, far}, 20, isLess).inside);
         },
         form});
  }
}

}  // namespace

void addLensSheet(const Bench& bench, double ipd, std::vector<Measurement>& all) {
  addViews(bench, all);
  addFlips(bench, ipd, all);
  addWhole(bench, all);
  addTwoEyes(bench, ipd, all);
  addProfile(bench, all);
  addDepthsOfViews(bench, all);
}

}  // namespace hogelscope
