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
#include "core/panel/sheet_numbers.h"
#include "measure/contrast.h"
#include "measure/measurement.h"

namespace hogelscope {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A part of the panel: points that are even over its height and, across the lenses, its width.
struct Spot {
  Vec2 middle;
  double width;
  double height;
  double lean;  ///< x for each y: −1/slope along the lenses
  int rays = 4096;
};

/// Returns 1/slope of the lenses.
double perSlope(const Bench& bench) {
  return 1 / bench.display().sheet->calibration.params.slope;
}

/// Returns a few lenses in the panel's middle, along most of its height: many phases of pixels to
/// lenses, and hardly more than one view to the eye.
Spot middleOf(const Bench& bench) {
  const auto& [width, height] = bench.display().size;
  const double turning = std::abs(bench.numbersOfSheet().viewsPerPanelMetre);
  return {{},
          std::min({24 * bench.pitch(0), width / 2, 0.3 / turning}),
          0.8 * height,
          -perSlope(bench)};
}

/// Calls `use` with the view 0 … N that an eye sees at each point of a spot in green, and with the
/// view at the place where its ray crosses the viewing distance, counted on beyond the cone.
template <class Use>
void forViews(const Bench& bench, const Vec3& eye, const Spot& spot, const Use& use) {
  constexpr std::size_t green = 1;
  constexpr int parts = 1 << 24;
  const SheetDisplay& display = *bench.display().sheet;
  const LensSheet& sheet = *bench.sheet();
  const int views = bench.display().directions[0];
  const double distance = display.viewingDistance;
  const double perCrossing = views * sheet.gap() / (sheet.period() * distance);
  const double lean = perSlope(bench);
  const auto [columns, rows] = display.calibration.params.panel;
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
    const double turned = (eye.x - point.x + (eye.y - point.y) * lean) / eye.z;
    const double crossing = point.x + point.y * lean + distance * turned;
    use(views * (part + 0.5) / parts, views / 2.0 + perCrossing * crossing);
  }
}

/// Returns the mean of the views, on their circle; 0 … N.
double meanView(const Bench& bench, const Vec3& eye, const Spot& spot) {
  const int views = bench.display().directions[0];
  std::complex<double> sum;
  forViews(bench, eye, spot,
           [&](double view, double /*own*/) { sum += std::polar(1.0, 2 * pi * view / views); });
  return std::fmod(std::arg(sum) / (2 * pi) + 1, 1) * views;
}

/// Returns the share of a spot of whose view, and that of the eye's own place, `is` is true.
template <class Is>
double shareOf(const Bench& bench, const Vec3& eye, const Spot& spot, const Is& is) {
  double inside = 0;
  double count = 0;
  forViews(bench, eye, spot, [&](double view, double own) {
    inside += is(view, own) ? 1 : 0;
    ++count;
  });
  return inside / count;
}

/// Returns the share of a spot that shows what is at the eye's own place, not N views aside.
double shareOwn(const Bench& bench, const Vec3& eye, const Spot& spot) {
  const double half = bench.display().directions[0] / 2.0;
  return shareOf(bench, eye, spot,
                 [half](double view, double own) { return std::abs(view - own) < half; });
}

/// Returns the share of the middle's light that is of views from `first` to before `last`.
double shareOfViews(const Bench& bench, const Vec3& eye, double first, double last) {
  return shareOf(bench, eye, middleOf(bench),
                 [=](double view, double /*own*/) { return view >= first && view < last; });
}

/// Returns x of the eye's place to a side, −1 or 1, where half of a spot shows other views than its
/// own.
double flipOf(const Bench& bench, const Spot& spot, double side) {
  const Vec3& eye = bench.eye();
  const SheetNumbers numbers = bench.numbersOfSheet();
  const double across = spot.middle.x + spot.middle.y * perSlope(bench);
  const double middle =
      numbers.middle() + across * (1 - eye.z / bench.display().sheet->viewingDistance);
  const auto isOwn = [&](double x) { return shareOwn(bench, {x, eye.y, eye.z}, spot) >= 0.5; };
  const Bracket ends{middle + 0.3 * side * numbers.width(), middle + 0.7 * side * numbers.width()};
  if (!isOwn(ends.inside) || isOwn(ends.outside)) return noValue;
  return bisect(ends, 30, isOwn).middle();
}

void addViews(const Bench& bench, std::vector<Measurement>& all) {
  const Vec3 eye = bench.eye();
  const SheetNumbers numbers = bench.numbersOfSheet();
  const std::string at = " z=" + metres(eye.z);
  const double middle = numbers.middle();
  all.push_back({"viewsPerMetre", "1/m", "to the eye's right" + at,
                 [=](Bench& b) {
                   const double move = 0.3 * numbers.width();
                   const auto viewAt = [&](double x) {
                     return meanView(b, {x, eye.y, eye.z}, middleOf(b));
                   };
                   return (viewAt(middle + move) - viewAt(middle - move)) / (2 * move);
                 },
                 numbers.viewsPerMetre});
  all.push_back(
      {"viewsPerMetre", "1/m", "to the right along the panel" + at,
       [=](Bench& b) {
         Spot spot = middleOf(b);
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
                   const Spot spot = middleOf(b);
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
  const SheetNumbers numbers = bench.numbersOfSheet();
  const std::string at = " z=" + metres(eye.z);
  const auto flipAt = [](const Bench& b, double side) { return flipOf(b, middleOf(b), side); };
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
                   Spot spot = middleOf(b);
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
  const SheetDisplay& display = *bench.display().sheet;
  const Vec3 eye = bench.eye();
  const auto [width, height] = bench.display().size;
  const double turned = std::abs(1 - eye.z / display.viewingDistance);
  const double panel = width + std::abs(perSlope(bench)) * height;
  all.push_back(
      {"viewingZone", "m", "whole panel across z=" + metres(eye.z),
       [](Bench& b) {
         const auto& size = b.display().size;
         const double side = 8 * b.pitch(0);
         double low = -infinite;
         double high = infinite;
         for (const double right : {-0.5, 0.5})
           for (const double up : {-0.5, 0.5}) {
             const Spot corner{{right * (size[0] - side), up * (size[1] - side)}, side, side, 0};
             low = std::max(low, flipOf(b, corner, -1));
             high = std::min(high, flipOf(b, corner, 1));
           }
         return std::max(high - low, 0.0);
       },
       std::max(bench.numbersOfSheet().width() - panel * turned, 0.0)});
  addZoneMap(bench,
             {[](Bench& b, const Vec3& from) {
                const auto& size = b.display().size;
                return shareOwn(b, from, {{}, size[0], size[1], 0, 2000});
              },
              [&](const Vec3& from) { return shareInCone(display, from); }},
             all);
}

/// The left eye's crosstalk: views to the right of the border are the right eye's.
void addTwoEyes(const Bench& bench, double ipd, std::vector<Measurement>& all) {
  const SheetDisplay& display = *bench.display().sheet;
  const SheetNumbers numbers = bench.numbersOfSheet();
  const auto viewAt = [=](double x) {
    return numbers.views / 2.0 + (x - numbers.middle()) * numbers.viewsPerMetre;
  };
  // The first view whose middle is to the right.
  const double border =
      std::clamp(std::ceil(viewAt(bench.eye().x) - 0.5), 0.0, double(numbers.views));
  addCrosstalk(bench, ipd,
               {[=](Bench& b, const Vec3& at) {
                  const Vec3 left{at.x - ipd / 2, at.y, at.z};
                  return shareOfViews(b, left, border, numbers.views) /
                         shareOfViews(b, left, 0, border);
                },
                [&](const Vec3& at) {
                  const double view = viewAt(at.x - ipd / 2);
                  // Near a flip views of the cone's other end come in.
                  if (view < 0.1 * numbers.views || view > 0.9 * numbers.views) return noValue;
                  const double end = 2 * numbers.views;
                  return lobeShare(display, numbers.views, border - view, end) /
                         lobeShare(display, numbers.views, -end, border - view);
                }},
               all);
}

/// The light of the middle view over the eye's angle.
void addMiddleProfile(const Bench& bench, std::vector<Measurement>& all) {
  const Vec3 eye = bench.eye();
  const SheetNumbers numbers = bench.numbersOfSheet();
  const int lit = numbers.views / 2;
  const double middle = numbers.middle();
  const auto placeOf = [=](double view) {
    return middle + (view - numbers.views / 2.0) / numbers.viewsPerMetre;
  };
  addProfile(
      bench,
      {lit,
       std::min(int(std::ceil(2 * numbers.lobe)) + 1, numbers.views / 2 - 1),
       30,
       [=](const Bench&, double view) { return 180 / pi * std::atan2(placeOf(view), eye.z); },
       [=](Bench& b, double view) {
         return shareOfViews(b, {placeOf(view), eye.y, eye.z}, lit, lit + 1);
       },
       [=](const Bench& b, double view) {
         const SheetDisplay& display = *b.display().sheet;
         return lobeShare(display, numbers.views, lit - view, lit + 1 - view) /
                lobeShare(display, numbers.views, -0.5, 0.5);
       },
       {}},
      all);
}

/// The depths at which the picture shifts by a lens from one view to the next.
void addDepthsOfViews(const Bench& bench, std::vector<Measurement>& all) {
  const double distance = bench.distance();
  const double period = bench.pitch(0);
  const SheetNumbers numbers = bench.numbersOfSheet();
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
  addMiddleProfile(bench, all);
  addDepthsOfViews(bench, all);
}

}  // namespace hogelscope
