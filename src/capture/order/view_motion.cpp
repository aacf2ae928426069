// SPDX-License-Identifier: BSD-3-Clause
#include "capture/order/view_motion.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

namespace hogelscope {

namespace {

cv::Mat1f smoothed(const cv::Mat1b& picture) {
  constexpr double sigma = 0.7;  // reduces noise and effects of resampling
  cv::Mat1f result;
  picture.convertTo(result, CV_32F);
  cv::GaussianBlur(result, result, {}, sigma);
  return result;
}

/// Returns the place that each pixel moves to.
cv::Mat2f arrivals(const cv::Mat2f& shift) {
  cv::Mat2f map(shift.size());
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x) map(y, x) = shift(y, x) + cv::Vec2f(float(x), float(y));
  return map;
}

template <class Picture>
Picture fetched(const Picture& picture, const cv::Mat2f& map) {
  constexpr double nowhere = 1e4;  // neither a value nor a motion
  Picture result;
  cv::remap(picture, result, map, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT,
            cv::Scalar::all(nowhere));
  return result;
}

/// The two pixels of a view that move to one pixel of another and differ most in motion.
struct Arrivals {
  cv::Mat1f least;  ///< motion along the axis from one view to the next
  cv::Mat1f most;
  cv::Mat2i fromLeast;
  cv::Mat2i fromMost;
};

/// Returns the arrivals in the view `t` steps away, to which the motion is `factor` times `motion`.
Arrivals arrivalsOf(const DenseMotion& motion, double factor, int t, int axis) {
  const cv::Size size = motion.shift.size();
  constexpr float far = 1e9F;
  Arrivals result{cv::Mat1f(size, far), cv::Mat1f(size, -far), cv::Mat2i(size), cv::Mat2i(size)};
  const cv::Rect inside(2, 2, size.width - 4, size.height - 4);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      if (motion.isSure(y, x) == 0) continue;
      const cv::Vec2d shift = cv::Vec2d(motion.shift(y, x)) * factor;
      const cv::Point to(cvRound(x + shift[0]), cvRound(y + shift[1]));
      if (!inside.contains(to)) continue;
      const auto perView = float(shift[axis] / t);
      if (perView < result.least(to)) {
        result.least(to) = perView;
        result.fromLeast(to) = {x, y};
      }
      if (perView > result.most(to)) {
        result.most(to) = perView;
        result.fromMost(to) = {x, y};
      }
    }
  return result;
}

/// Returns the mean absolute difference of 3×3 pixels around `a` and `b`.
double difference(const cv::Mat1f& one, const cv::Vec2i& a, const cv::Mat1f& other,
                  const cv::Point& b) {
  double sum = 0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      sum += std::abs(
          one(std::clamp(a[1] + y, 0, one.rows - 1), std::clamp(a[0] + x, 0, one.cols - 1)) -
          other(b.y + y, b.x + x));
  return sum / 9;
}

/// Returns one vote per square of pixels, because neighbours are not independent.
Occlusions votesOf(const cv::Mat1f& view, const cv::Mat1f& other, const Arrivals& arrivals, int t) {
  constexpr double leastWay = 3;    // pixels apart, more than motion can be wrong
  constexpr double mostOfSeen = 9;  // code values
  constexpr double leastOfHidden = 18;
  constexpr int side = 12;        // pixels of a square
  constexpr int leastPixels = 3;  // in a square
  std::map<std::pair<int, int>, Occlusions> squares;
  for (int y = 2; y < view.rows - 2; ++y)
    for (int x = 2; x < view.cols - 2; ++x) {
      if ((arrivals.most(y, x) - arrivals.least(y, x)) * std::abs(t) < leastWay) continue;
      const double least = difference(view, arrivals.fromLeast(y, x), other, {x, y});
      const double most = difference(view, arrivals.fromMost(y, x), other, {x, y});
      const double hidden = std::max(least, most);
      const double seen = std::min(least, most);
      if (seen > mostOfSeen || hidden < leastOfHidden || hidden < 3 * seen) continue;
      Occlusions& square = squares[{y / side, x / side}];
      (least < most ? square.ordered : square.reversed) += 1;
    }
  Occlusions votes;
  for (const auto& [at, square] : squares) {
    if (square.count() < leastPixels || square.ordered == square.reversed) continue;
    const int area = 8 * (8 * at.first * side / view.rows) + 8 * at.second * side / view.cols;
    Occlusions vote{1, 0, {}, {}};
    vote.orderedAreas.set(std::size_t(std::min(area, 63)));
    votes += square.ordered > square.reversed ? vote : vote.backwards();
  }
  return votes;
}

/// Returns the range of the content's motion from one view to the next, in pixels.
double spreadOf(const DenseMotion& motion, int axis) {
  std::vector<float> values;
  for (int y = 0; y < motion.shift.rows; y += 2)
    for (int x = 0; x < motion.shift.cols; x += 2)
      if (motion.isSure(y, x) != 0) values.push_back(motion.shift(y, x)[axis]);
  if (values.size() < 100) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() * 98 / 100] - values[values.size() * 2 / 100];
}

}  // namespace

bool Occlusions::isLeaning() const {
  constexpr int fewest = 6;
  constexpr double part = 0.75;
  const int most = std::max(ordered, reversed);
  return most >= fewest && most >= part * count();
}

Occlusions Occlusions::backwards() const {
  return {reversed, ordered, reversedAreas, orderedAreas};
}

Occlusions& Occlusions::operator+=(const Occlusions& more) {
  ordered += more.ordered;
  reversed += more.reversed;
  orderedAreas |= more.orderedAreas;
  reversedAreas |= more.reversedAreas;
  return *this;
}

MotionFinder::MotionFinder()
    : m_flow(cv::DISOpticalFlow::create(cv::DISOpticalFlow::PRESET_MEDIUM)) {
  m_flow->setFinestScale(0);  // every pixel, because only edges show occlusions
}

cv::Mat2f MotionFinder::flow(const cv::Mat1b& from, const cv::Mat1b& to) {
  cv::Mat2f shift;  // empty: no guess to begin with
  m_flow->calc(from, to, shift);
  return shift;
}

DenseMotion MotionFinder::between(const cv::Mat1b& from, const cv::Mat1b& to) {
  constexpr double mostReturn = 0.5;  // pixels
  constexpr double mostChange = 8;    // code values
  DenseMotion motion{flow(from, to), cv::Mat1b::zeros(from.size())};
  const cv::Mat2f map = arrivals(motion.shift);
  const cv::Mat2f back = fetched(flow(to, from), map);
  const cv::Mat1f here = smoothed(from);
  const cv::Mat1f there = fetched(smoothed(to), map);
  for (int y = 0; y < from.rows; ++y)
    for (int x = 0; x < from.cols; ++x)
      motion.isSure(y, x) = cv::norm(motion.shift(y, x) + back(y, x)) < mostReturn &&
                                    std::abs(there(y, x) - here(y, x)) < mostChange
                                ? 255
                                : 0;
  return motion;
}

cv::Mat1b repetitions(const cv::Mat1b& picture, int axis) {
  constexpr int nearest = 4;
  constexpr int farthest = 28;
  constexpr float mostOfContrast = 0.4F;  // of a window's standard deviation; noise has 1.1
  const cv::Size window(17, 17);
  const cv::Mat1f values = smoothed(picture);
  cv::Mat1f mean;
  cv::Mat1f contrast;
  cv::boxFilter(values, mean, -1, window);
  cv::sqrBoxFilter(values, contrast, CV_32F, window);
  contrast -= mean.mul(mean);
  cv::sqrt(cv::max(contrast, 0), contrast);
  cv::Mat1b result = cv::Mat1b::zeros(picture.size());
  for (int way = nearest; way <= farthest; ++way)
    for (const int by : {-way, way}) {
      const cv::Matx23f moved(1, 0, axis == 0 ? float(by) : 0, 0, 1, axis == 0 ? 0 : float(by));
      cv::Mat1f other;
      cv::warpAffine(values, other, moved, picture.size(), cv::INTER_NEAREST,
                     cv::BORDER_REFLECT_101);
      cv::absdiff(other, values, other);
      cv::boxFilter(other, other, -1, window);
      result |= other < mostOfContrast * contrast;
    }
  return result;
}

DenseMotion motionPerView(const Neighbours& neighbours) {
  const auto& [view, step, before, after] = neighbours;
  if (!neighbours.hasBefore() && !neighbours.hasAfter()) return {};
  if (!neighbours.hasBefore()) return {after.shift / step, after.isSure};
  if (!neighbours.hasAfter()) return {before.shift / -step, before.isSure};
  DenseMotion motion{(after.shift - before.shift) / (2 * step), after.isSure & before.isSure};
  constexpr double mostDifference = 0.25;  // of the motion, beyond 1 px: cameras stand unevenly
  for (int y = 0; y < view.rows; ++y)
    for (int x = 0; x < view.cols; ++x)
      if (cv::norm(after.shift(y, x) + before.shift(y, x)) >
          1 + mostDifference * step * cv::norm(motion.shift(y, x)))
        motion.isSure(y, x) = 0;
  return motion;
}

Occlusions occlusionsIn(const Neighbours& neighbours, const cv::Mat1b& repeats, int axis,
                        int before, int after, const std::function<cv::Mat1b(int)>& target) {
  constexpr double wanted = 48;  // pixels that the nearest and the farthest content move apart
  Occlusions votes;
  const double spread = spreadOf(motionPerView(neighbours), axis);
  if (!(spread > 0)) return votes;
  const cv::Mat1f view = smoothed(neighbours.view);
  const auto judge = [&](const DenseMotion& motion, int stepOfMotion, int t) {
    if (motion.shift.empty() || t == 0) return;
    const DenseMotion certain{motion.shift, motion.isSure & ~repeats};
    votes += votesOf(view, smoothed(target(t)),
                     arrivalsOf(certain, double(t) / stepOfMotion, t, axis), t);
  };
  const int far = int(std::clamp(wanted / spread, 1.0, 1e6));
  judge(neighbours.before, -neighbours.step, std::min(far, after));
  judge(neighbours.after, neighbours.step, -std::min(far, before));
  return votes;
}

}  // namespace hogelscope
