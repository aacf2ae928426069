// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/design_parameters.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text.h"
#include "core/panel/design_numbers.h"
#include "measure/session_numbers.h"

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

/// Returns "Lens array · Rotation", or "Display · Position x" for a number of a list.
QString labelOf(const SessionNumber& number) {
  const auto field = number.name.rfind('.');
  const auto section = number.name.rfind('.', field - 1);
  const std::size_t from = section == std::string::npos ? 0 : section + 1;
  std::string label =
      formLabel(number.name.substr(from, field - from)) + " · " +
      (number.label.empty() ? formLabel(number.name.substr(field + 1)) : number.label);
  const bool isOfColours = number.count == 3 && number.name.starts_with("twin.");
  constexpr std::array axes{"x", "y", "z"};
  constexpr std::array colours{"red", "green", "blue"};
  if (number.count > 1) label += std::string(" ") + (isOfColours ? colours : axes).at(number.index);
  return QString::fromStdString(label);
}

/// Returns what sweeps a number of the session, whose unit goes on without a document.
DesignParameter parameterOf(const SessionNumber& number) {
  const bool isOfTwin = number.name.starts_with("twin.");
  const Range& range = number.range;
  const bool hasUsual = range.slideMin < range.slideMax;
  return {"",
          labelOf(number),
          QString::fromStdString(number.unit),
          range.min,
          range.max,
          false,
          number.isWhole,
          [number](const Session& session, std::size_t state) {
            const auto numbers = numbersOf(session, state);
            return std::ranges::find_if(numbers,
                                        [&](const SessionNumber& one) {
                                          return one.name == number.name &&
                                                 one.index == number.index;
                                        })
                ->value;
          },
          [number, isOfTwin](Session& session, std::size_t state, double value) {
            setNumber(session, state, number, value);
            if (isOfTwin) session = withTwin(session, session.twin);
          },
          hasUsual ? range.slideMin : range.min,
          hasUsual ? range.slideMax : range.max,
          isOfTwin};
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

const std::vector<DesignParameter>& sweptParameters() {
  static const std::vector<DesignParameter> all = [] {
    std::vector<DesignParameter> parameters = designParameters();
    Session session;
    session.cameras.emplace_back();
    for (const SessionNumber& number : numbersOf(session)) {
      const bool isOfDisplay = number.name.starts_with("display.") && !number.range.mayBeLeftOut &&
                               number.name != "display.size" && number.name != "display.fov";
      if (isOfDisplay || number.name.starts_with("twin."))
        parameters.push_back(parameterOf(number));
    }
    return parameters;
  }();
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
