// SPDX-License-Identifier: BSD-3-Clause
#include "study/stability.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/text.h"
#include "core/engine/plan.h"
#include "study/undistortion.h"

namespace hogelscope {

namespace {

/// Returns a camera whose principal point is the image's middle and whose corner pixel is at the
/// distance `corner` from the centre in the plane z = 1.
LensKey cameraWithCorner(const DistortionParams& distortion, double corner) {
  LensKey key{distortion, LensMapping::exact, {640, 480}, {}, {319.5, 239.5}, 1};
  const double focal = std::hypot(key.centre.x, key.centre.y) / corner;
  key.focalLength = {focal, focal};
  return key;
}

/// Returns the row of a lens that a method inverts; x and y are of lenses on a map.
std::vector<std::string> rowOf(const std::string& kind, const std::string& lens, std::size_t method,
                               const LensOutcomes& o, const std::string& x, const std::string& y) {
  std::vector<std::string> row{kind, lens, inverseMethods()[method].name,
                               std::to_string(o.points())};
  for (const Outcome each :
       {Outcome::right, Outcome::wrongRoot, Outcome::inexact, Outcome::diverged, Outcome::noRay})
    row.push_back(std::to_string(o[each]));
  const std::string worst(outcomeNames()[std::size_t(o.worst())]);
  row.insert(row.end(), {numberText(o.worstResidual), worst, x, y, ""});
  return row;
}

void addRows(Table& table, const LensMap& map) {
  const int side = map.plane.side();
  for (std::size_t m = 0; m < map.outcomes.size(); ++m)
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column)
        table.push_back(
            rowOf(map.plane.name, "", m,
                  map.outcomes[m][std::size_t(row) * std::size_t(side) + std::size_t(column)],
                  numberText(map.plane.at(column)), numberText(map.plane.at(row))));
}

}  // namespace

/// Returns the lenses; the paper's coefficients are those of data/table1.json.
std::vector<NamedLens> hardLenses() {
  const LensKey openCvs{{0.2958943955272433, -1.0354662043042675, 0, 0, 0},
                        LensMapping::exact,
                        {640, 480},
                        {534.8032684505131, 534.8032684505131},
                        {335.6864320439489, 240.66183054066337},
                        1};
  return {{"paper Fig 1", paperCamera({0.6, 0.4, 0, 0, 0.3})},
          {"paper Fig 2", paperCamera({0, 0, 0.2, 0.1, 0})},
          {"paper Fig 3", paperCamera({0.6, 0.3, 0.2, 0.01, 0.2})},
          {"k1 -0.45 k2 0.25 to r_d 1.1336", cameraWithCorner({-0.45, 0.25, 0, 0, 0}, 1.1336)},
          {"k1 0.5 to r_d 3", cameraWithCorner({0.5, 0, 0, 0, 0}, 3)},
          {"OpenCV samples/data/intrinsics.yml", openCvs}};
}

Stability measureStability(const std::vector<NamedLens>& lenses, const ParallelRows& parallelRows,
                           const Progress& progress) {
  constexpr int gridSide = 41;
  constexpr double lensShare = 0.05;  // approximate share of the time
  constexpr double mapShare = 0.4;
  const Progress heard = forThreads(progress);
  Stability result{lenses, {}, {}, {}};
  for (const NamedLens& lens : lenses) {
    const double done = lensShare * double(result.outcomes.size()) / double(lenses.size());
    const LensTrial trial(lens.key, gridSide, gridSide, part(heard, done, done));
    result.outcomes.emplace_back();
    for (const InverseMethod& method : inverseMethods())
      result.outcomes.back().push_back(trial.outcomes(method));
  }
  double from = lensShare;
  for (const LensPlane& plane : lensPlanes()) {
    result.maps.push_back(measureMap(plane, parallelRows, part(heard, from, from + mapShare)));
    from += mapShare;
  }
  result.instabilities = measureInstabilities(parallelRows, part(heard, from, 1));
  std::ranges::move(undistortionErrors(parallelRows, part(heard, 1, 1)),
                    std::back_inserter(result.instabilities));
  return result;
}

std::string csv(const Stability& stability) {
  Table table = csvRows(
      "kind,lens,method,points,right,wrong_root,inexact,diverged,no_ray,worst_residual_px,"
      "outcome,x,y,value");
  for (std::size_t k = 0; k < stability.lenses.size(); ++k)
    for (std::size_t m = 0; m < inverseMethods().size(); ++m)
      table.push_back(rowOf("lens", stability.lenses[k].name, m, stability.outcomes[k][m], "", ""));
  for (const LensMap& map : stability.maps) addRows(table, map);
  for (const auto& [kind, method, x, y, points, value] : stability.instabilities)
    table.push_back({kind, "", method, points ? std::to_string(*points) : "", "", "", "", "", "",
                     "", "", numberText(x), y ? numberText(*y) : "", numberText(value)});
  return csvText(table);
}

}  // namespace hogelscope
