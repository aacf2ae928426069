// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/design_parameters.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "core/panel/design_numbers.h"

namespace hogelscope {

namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("DesignParameters", text);
}

template <auto pair>
double across(const Session& session, std::size_t /*state*/) {
  return double((session.display.*pair)[0]);
}

template <auto pair>
void setAcross(Session& session, std::size_t /*state*/, double value) {
  auto& [x, y] = session.display.*pair;
  const double ratio = x > 0 ? double(y) / double(x) : 1;
  if constexpr (std::is_same_v<std::remove_reference_t<decltype(x)>, int>) {
    x = int(value);
    if (y != 1) y = std::max(1, int(std::lround(ratio * value)));
  } else {
    x = value;
    y = ratio * value;
  }
}

double leakage(const Session& session, std::size_t state) {
  const PsfParams& psf = session.cameras.at(state).psf;
  return psf.windowSize == 1 ? 0 : psf.sigma;
}

/// Two deviations are in the window, as in the paper, whose deviation of 0.67 has five directions.
void setLeakage(Session& session, std::size_t state, double sigma) {
  PsfParams& psf = session.cameras.at(state).psf;
  psf.windowSize = 2 * int(std::ceil(2 * sigma)) + 1;
  if (sigma > 0) psf.sigma = sigma;
}

}  // namespace

double DesignParameter::shareOf(double value) const {
  const double share = isLogarithmic
                           ? std::log(std::max(value, least) / least) / std::log(most / least)
                           : (value - least) / (most - least);
  return std::clamp(share, 0.0, 1.0);
}

double DesignParameter::at(double share) const {
  const double value =
      isLogarithmic ? least * std::pow(most / least, share) : least + share * (most - least);
  return isWhole ? std::round(value) : QString::number(value, 'g', 3).toDouble();
}

QString DesignParameter::text(double value) const {
  const QString number = QLocale().toString(value, 'g', 4);
  return unit.isEmpty() ? number : number + QStringLiteral(" ") + unit;
}

const std::vector<DesignParameter>& designParameters() {
  static const std::vector<DesignParameter> all{
      {"Hogels", tr("Hogels across"), "", 8, 2048, true, true, across<&DisplayParams::hogels>,
       setAcross<&DisplayParams::hogels>},
      {"Directions", tr("Directions across"), "", 2, 512, true, true,
       across<&DisplayParams::directions>, setAcross<&DisplayParams::directions>},
      {"Fov", tr("Field of view"), "°", 5, 150, false, false, across<&DisplayParams::fov>,
       setAcross<&DisplayParams::fov>},
      {"Size", tr("Width"), "m", 0.02, 3, true, false, across<&DisplayParams::size>,
       setAcross<&DisplayParams::size>},
      {"Leakage", tr("Leakage σ"), tr("directions"), 0, 3, false, false, leakage, setLeakage},
      {"Distance", tr("Distance of the eye"), "m", 0.1, 5, true, false,
       [](const Session& session, std::size_t state) {
         return session.cameras.at(state).camera.eye.z;
       },
       [](Session& session, std::size_t state, double value) {
         session.cameras.at(state).camera.eye.z = value;
       }}};
  return all;
}

Session withValue(Session session, std::size_t state, const DesignParameter& parameter,
                  double value, Hold hold) {
  const DisplayParams before = session.display;
  parameter.set(session, state, value);
  DisplayParams& after = session.display;
  if (hold == Hold::pixels && after != before) holdPixels(before, after);
  if (hold != Hold::pitch) return session;
  if (after.hogels != before.hogels) {
    holdPitch(before, after);
    return session;
  }
  // A light field in files has its own number of hogels, which its display may leave out.
  if (after.size != before.size && session.lightField.isLive())
    for (const std::size_t axis : {0, 1})
      after.hogels[axis] =
          std::max(1, int(std::lround(after.hogels[axis] * after.size[axis] / before.size[axis])));
  return session;
}

}  // namespace hogelscope
