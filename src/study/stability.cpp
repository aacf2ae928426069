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

LensKey camera(const DistortionParams& lens, const std::array<int, 2>& res, const Vec2& focal,
               const Vec2& centre) {
  return {lens, LensMapping::exact, res, focal, centre, 1};
}

/// Coefficients in OpenCV's order.
DistortionParams rational(const std::array<double, 8>& k) {
  return {k[0], k[1], k[2], k[3], k[4], k[5], k[6], k[7], DistortionModel::rational};
}

DistortionParams fisheye(const std::array<double, 4>& k) {
  return {k[0], k[1], 0, 0, k[2], k[3], 0, 0, DistortionModel::fisheye};
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

/// Returns the lenses; the paper's coefficients are those of data/table1.json. Those of cameras
/// were published with them: Kinect in pointCloudGen/calib.md of panispani/3DReconstruct, OAK-D in
/// a listing of its topic camera_info, TUM VI in the data set's camchain.
std::vector<NamedLens> hardLenses() {
  const LensKey openCvs{{0.2958943955272433, -1.0354662043042675, 0, 0, 0},
                        LensMapping::exact,
                        {640, 480},
                        {534.8032684505131, 534.8032684505131},
                        {335.6864320439489, 240.66183054066337},
                        1};
  return {
      {"paper Fig 1", paperCamera({0.6, 0.4, 0, 0, 0.3})},
      {"paper Fig 2", paperCamera({0, 0, 0.2, 0.1, 0})},
      {"paper Fig 3", paperCamera({0.6, 0.3, 0.2, 0.01, 0.2})},
      {"k1 -0.45 k2 0.25 to r_d 1.1336", cameraWithCorner({-0.45, 0.25, 0, 0, 0}, 1.1336)},
      {"k1 0.5 to r_d 3", cameraWithCorner({0.5, 0, 0, 0, 0}, 3)},
      {"OpenCV samples/data/intrinsics.yml", openCvs},
      {"Azure Kinect colour",
       camera(rational({0.722746, -2.88559, 0.000783, -0.000143, 1.632723, 0.602199, -2.719626,
                        1.565053}),
              {1920, 1080}, {904.141541, 903.521362}, {953.284424, 555.142456})},
      {"Azure Kinect depth", camera(rational({3.130577, 2.324939, 0.000081, -0.000051, 0.130416,
                                              3.458652, 3.350115, 0.662942}),
                                    {640, 576}, {503.927643, 503.978729}, {332.06427, 325.880615})},
      {"OAK-D Lite colour",
       camera(rational({-4.0933966636657715, 9.190781593322754, -0.0012543922057375312,
                        -0.0010304413735866547, -8.917245864868164, -4.187956809997559,
                        9.556831359863281, -9.303533554077148}),
              {250, 250}, {196.7876739501953, 196.7876739501953},
              {123.86207580566406, 127.05023193359375})},
      {"TUM VI cam0", camera(fisheye({0.0034823894022493434, 0.0007150348452162257,
                                      -0.0020532361418706202, 0.00020293673591811182}),
                             {512, 512}, {190.97847715128717, 190.9733070521226},
                             {254.93170605935475, 256.8974428996504})},
      {"fisheye k1 0.1 to 85°", cameraWithCorner(fisheye({0.1, 0, 0, 0}), 1.81)},
      {"fisheye k1 -0.3 to its fold", cameraWithCorner(fisheye({-0.3, 0, 0, 0}), 0.7)}};
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
