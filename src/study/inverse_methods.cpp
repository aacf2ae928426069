// SPDX-License-Identifier: BSD-3-Clause
#include "study/inverse_methods.h"

#include <opencv2/calib3d.hpp>

#include "core/lens/batch_undistort.h"

namespace hogelscope {

namespace {

using Points = std::vector<Vec2>;

/// Calls cv::undistortPoints for points of the plane z = 1.
Points byOpenCv(const Distortion& lens, const Points& distorted, int iterations) {
  const auto& [k1, k2, p1, p2, k3] = lens.params();
  std::vector<cv::Point2d> from;
  for (const Vec2& p : distorted) from.emplace_back(p.x, p.y);
  std::vector<cv::Point2d> to;
  cv::undistortPoints(from, to, cv::Matx33d::eye(), cv::Vec<double, 5>(k1, k2, p1, p2, k3),
                      cv::noArray(), cv::noArray(),
                      cv::TermCriteria(cv::TermCriteria::COUNT, iterations, 0));
  Points ideal;
  for (const cv::Point2d& p : to) ideal.push_back({p.x, p.y});
  return ideal;
}

/// Performs plain Newton steps without safeguards, which may diverge.
Vec2 newton(const Distortion& lens, const Vec2& distorted) {
  constexpr int steps = 20;
  Vec2 ideal = distorted;
  for (int step = 0; step < steps; ++step) {
    const Vec2 here = lens.distort(ideal);
    const Vec2 error{distorted.x - here.x, distorted.y - here.y};
    const Jacobian j = lens.jacobian(ideal);
    const double det = j.xx * j.yy - j.xy * j.yx;
    ideal.x += (j.yy * error.x - j.xy * error.y) / det;
    ideal.y += (j.xx * error.y - j.yx * error.x) / det;
  }
  return ideal;
}

Points byNewton(const Distortion& lens, const Points& distorted, const Progress&) {
  Points ideal;
  for (const Vec2& p : distorted) ideal.push_back(newton(lens, p));
  return ideal;
}

Points byOurs(const Distortion& lens, const Points& distorted, const Progress& progress) {
  std::vector<double> x;
  std::vector<double> y;
  for (const Vec2& p : distorted) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
  BatchUndistort(lens, progress).undistort(x.data(), y.data(), int(x.size()));
  Points ideal;
  for (std::size_t k = 0; k < x.size(); ++k) ideal.push_back({x[k], y[k]});
  return ideal;
}

InverseMethod openCv(int iterations) {
  return {"OpenCV " + std::to_string(iterations), false,
          [iterations](const Distortion& lens, const Points& distorted, const Progress&) {
            return byOpenCv(lens, distorted, iterations);
          }};
}

}  // namespace

const std::vector<InverseMethod>& inverseMethods() {
  static const std::vector<InverseMethod> methods{
      openCv(5), openCv(20), openCv(200), {"Newton 20", false, byNewton}, {"ours", true, byOurs}};
  return methods;
}

}  // namespace hogelscope
