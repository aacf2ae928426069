// SPDX-License-Identifier: BSD-3-Clause
#include "picture/scene_text.h"

#include <array>
#include <cmath>

#include "core/panel/viewing_zone.h"

namespace hogelscope {

namespace {

QString number(double value, int decimals) {
  return QString::number(value, 'f', decimals);
}

int floorIndex(double index) {
  return static_cast<int>(std::floor(index));
}

/// An eye before a lens sheet, whose views are seen once between two flips and again beyond them.
QString sheetEye(const QString& name, const PanelParams& display, const Vec3& eye) {
  const Vec3 at = eyePlaceOf(display, eye).point;
  if (!(at.z > 0)) return SceneText::tr("%1: ⚠ behind the panel").arg(name);
  const SheetParams& params = display.sheet->calibration.params;
  const double cone = 2 * at.z * std::tan(radians(params.cone) / 2);  // its width there
  const double across = at.x + at.y / params.slope;
  const QString way = SceneText::length(cone / 2 - std::abs(std::remainder(across, cone)));
  return std::abs(across) <= cone / 2
             ? SceneText::tr("%1: between the flips, %2 from the next one").arg(name, way)
             : SceneText::tr(
                   "%1: ⚠ beyond a flip, where views are seen again, %2 from the next one")
                   .arg(name, way);
}

/// Which sub-pixels of a lens sheet's panel a ray meets, and which views these show.
QString subPixels(const PixelTrace& trace, const PanelParams& display, int views) {
  const hogelscope::Display sheet(display);
  const Vec3 eye = sheet.displayFromWorld().point(trace.eye);
  const Vec3 way = sheet.displayFromWorld().direction(trace.target - trace.eye);
  const std::array names{SceneText::tr("red"), SceneText::tr("green"), SceneText::tr("blue")};
  QString text;
  for (std::size_t channel = 0; channel < names.size(); ++channel) {
    const std::optional<Hit> at = sheet.hit(eye, way, channel);
    if (!at) {
      text += SceneText::tr("\n%1: beside the panel").arg(names[channel]);
      continue;
    }
    const int column = floorIndex(at->i);
    const int row = floorIndex(at->j);
    text += SceneText::tr("\n%1: column %2, row %3 · view %4 of 0 … %5")
                .arg(names[channel])
                .arg(column)
                .arg(row)
                .arg(sheet.sheet()->viewOf(column, row, channel, views))
                .arg(views - 1);
  }
  return text;
}

}  // namespace

QString SceneText::eye(const CameraState& state, const PanelParams& display) {
  const QString name = QString::fromStdString(state.camera.name);
  if (display.sheet) return sheetEye(name, display, state.camera.eye);
  const double share = shareSeenFrom(display, state.camera.eye);
  if (share == 0) return tr("%1: ⚠ outside the viewing zone, no hogel lights this eye").arg(name);
  return tr("%1: %2 % of the panel lights this eye").arg(name, number(100 * share, 1));
}

QString SceneText::pixel(int x, int y, const PixelTrace& trace) {
  const std::string_view end = words(trace.end);
  QString text = tr("Pixel (%1, %2): %3")
                     .arg(x)
                     .arg(y)
                     .arg(QString::fromUtf8(end.data(), qsizetype(end.size())));
  if (trace.colour)
    text += tr(" · colour %1 %2 %3 (of 255)")
                .arg(number(trace.colour->r, 1), number(trace.colour->g, 1),
                     number(trace.colour->b, 1));
  if (trace.taps > 0) text += tr(" · %n leakage taps", "", trace.taps);
  return text;
}

QString SceneText::ray(const PixelTrace& trace, const PanelParams& display, int views) {
  if (trace.end == RayEnd::noRay) return {};
  const auto point = [](const Vec3& p) {
    return tr("(%1, %2, %3) m").arg(number(p.x, 4), number(p.y, 4), number(p.z, 4));
  };
  QString text = tr("\nray from %1 to %2").arg(point(trace.eye), point(trace.target));
  if (!trace.place) return text;
  const Hit& at = *trace.place;
  if (display.sheet)
    text += subPixels(trace, display, views);
  else if (trace.end != RayEnd::misses)
    text += tr("\nhogel i %1, j %2 · direction u %3, v %4 (at %5, %6, %7, %8)")
                .arg(floorIndex(at.i))
                .arg(floorIndex(at.j))
                .arg(floorIndex(at.u))
                .arg(floorIndex(at.v))
                .arg(number(at.i, 2), number(at.j, 2), number(at.u, 2), number(at.v, 2));
  return text + tr("\npanel x %1 m, y %2 m · slopes dx/dz %3, dy/dz %4")
                    .arg(number(trace.position.x, 4), number(trace.position.y, 4),
                         number(trace.slopes.x, 4), number(trace.slopes.y, 4));
}

QString SceneText::verdict(const PixelTrace& trace, const PanelParams& display) {
  switch (fateOf(trace)) {
    case PixelFate::noRay:
      return tr(
          "Black, no ray: the lens folds or ends nearer to the centre, so that no light gets to "
          "this pixel.");
    case PixelFate::dark:
      return tr("Black, dark content: it sees the display, which sends no light this way.");
    case PixelFate::lit:
      return tr("Sees the display.");
    case PixelFate::outside:
      break;
  }
  if (!trace.place)
    return tr("Black, outside the viewing zone: its ray does not come to the panel's front.");
  if (trace.end == RayEnd::misses) return tr("Black, outside the panel: its ray passes beside it.");
  return tr("Black, outside the viewing zone: the hogel lights %1° × %2°, and direction u %3, v %4 "
            "is none of its %5 × %6.")
      .arg(display.fov[0])
      .arg(display.fov[1])
      .arg(floorIndex(trace.place->u))
      .arg(floorIndex(trace.place->v))
      .arg(display.directions[0])
      .arg(display.directions[1]);
}

QString SceneText::length(double metres) {
  metres = std::round(1e6 * metres) / 1e6;  // 0 but for rounding errors is 0
  return metres != 0 && std::abs(metres) < 0.1
             ? tr("%1 mm").arg(QString::number(1000 * metres, 'g', 4))
             : tr("%1 m").arg(QString::number(metres, 'g', 4));
}

QString SceneText::measured(const std::vector<Vec3>& points) {
  if (points.empty()) return tr("Measure: click the first point. Escape ends.");
  if (points.size() == 1) return tr("Measure: click the second point.");
  const Vec3 way = points[1] - points[0];
  return tr("Distance %1 · Δx %2, Δy %3, Δz %4")
      .arg(length(hogelscope::length(way)), length(way.x), length(way.y), length(way.z));
}

QString SceneText::sheet(const SheetDisplay& display) {
  const LensSheet sheet(display);
  const auto& [pitch, slope, center, dpi, panel, cone] = display.calibration.params;
  const QString serial = QString::fromStdString(display.calibration.serial);
  return (serial.isEmpty() ? QString() : serial.toHtmlEscaped() + " · ") +
         tr("%1 × %2 px of %3 mm · %4 lenses, %5 apart, leaning %6° to the %7 · cone %8°")
             .arg(panel[0])
             .arg(panel[1])
             .arg(number(1000 * sheet.pixel(), 4), number(sheet.lenses(), 1),
                  length(sheet.period()), number(std::abs(sheet.slant()), 2),
                  sheet.slant() > 0 ? tr("right") : tr("left"))
             .arg(cone);
}

QString SceneText::hogelName(int i, int j) {
  return tr("hogel %1, %2").arg(i).arg(j);
}

QString SceneText::hogel(const PanelParams& display, int i, int j) {
  const Vec2 middle = Display(display).position(i + 0.5, j + 0.5);
  return tr("Hogel i %1, j %2 at x %3 m, y %4 m: %5 × %6 directions over %7° × %8°")
      .arg(i)
      .arg(j)
      .arg(number(middle.x, 4), number(middle.y, 4))
      .arg(display.directions[0])
      .arg(display.directions[1])
      .arg(display.fov[0])
      .arg(display.fov[1]);
}

}  // namespace hogelscope
