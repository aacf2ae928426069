// SPDX-License-Identifier: BSD-3-Clause
// A plenoptic camera, traced ray by ray: a thin main lens, an array of pinholes in its image plane
// and a sensor behind. Independent of the program.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

/// The camera. Lengths are in pixels of the sensor. The axis passes through the image's middle.
struct LensletCamera {
  int width = 250;
  int height = 220;
  double pitch = 15.3846;  ///< of the lenslets' images on the sensor
  double degrees = 0.7;    ///< clockwise in the image
  bool isHexagonal = false;
  double phaseX = 3.3;  ///< of the lenslets relative to the axis
  double phaseY = -2.6;

  double toSensor = 100;      ///< from the lenslets
  double toMainLens = 4000;   ///< from the lenslets
  double toObject = 8000;     ///< from the main lens to the plane in focus
  double nearFraction = 0.7;  ///< of that distance, to a plane nearer to the camera

  struct Point {
    double x = 0;
    double y = 0;
  };

  /// The light of the scene at the plane in focus, and whether the near plane hides it; x to the
  /// right and y downwards as seen looking into the scene, in images of lenslets.
  std::function<double(double x, double y)> farLight = [](double, double) { return 1.0; };
  std::function<bool(double x, double y)> isHidden = [](double, double) { return false; };
  /// The transmission of the main lens at a point of its aperture; 1 is its edge.
  std::function<double(double x, double y)> aperture = [](double x, double y) {
    return x * x + y * y < 1 ? 1 - 0.4 * (x * x + y * y) : 0.005;
  };

  /// Returns the index of a pixel in picture().
  [[nodiscard]] std::size_t indexOf(int x, int y) const {
    return std::size_t(y) * std::size_t(width) + std::size_t(x);
  }
  [[nodiscard]] Point middleOfPicture() const { return {(width - 1) / 2.0, (height - 1) / 2.0}; }

  /// Returns the centre of a lenslet's image, in pixels of the image.
  [[nodiscard]] Point image(int n, int j) const {
    const double angle = degrees * std::numbers::pi / 180;
    const double across = (n + (isHexagonal && j % 2 != 0 ? 0.5 : 0)) * pitch;
    const double down = j * pitch * (isHexagonal ? std::sqrt(3.0) / 2 : 1);
    const auto [x0, y0] = middleOfPicture();
    return {x0 + phaseX + across * std::cos(angle) - down * std::sin(angle),
            y0 + phaseY + across * std::sin(angle) + down * std::cos(angle)};
  }

  /// Returns the light at a point of the image, through the lenslet whose image has that centre.
  [[nodiscard]] double light(const Point& at, const Point& lensletImage) const {
    // The camera turns its sensor's image upright. A lenslet image's centre is where light from the
    // middle of the main lens falls.
    const double closer = toMainLens / (toMainLens + toSensor);
    const auto [x0, y0] = middleOfPicture();
    const Point sensor{x0 - at.x, y0 - at.y};
    const Point lenslet{(x0 - lensletImage.x) * closer, (y0 - lensletImage.y) * closer};
    // Backwards along the light: from the sensor through the lenslet to the main lens, …
    const Point lens{lenslet.x + (lenslet.x - sensor.x) * toMainLens / toSensor,
                     lenslet.y + (lenslet.y - sensor.y) * toMainLens / toSensor};
    const double edge = 0.47 * pitch * toMainLens / toSensor;
    const double through = aperture(lens.x / edge, lens.y / edge);
    // … and from there to the lenslet's image in the scene, which is upside down.
    const double larger = toObject / toMainLens;
    const Point object{-lenslet.x * larger, -lenslet.y * larger};
    const Point near{lens.x + (object.x - lens.x) * nearFraction,
                     lens.y + (object.y - lens.y) * nearFraction};
    const double unit = pitch * larger;
    if (isHidden(near.x / unit, near.y / unit)) return 0;
    return through * farLight(object.x / unit, object.y / unit);
  }

  /// Returns the image: the mean of 4×4 rays per pixel, each through the nearest of all lenslets.
  [[nodiscard]] std::vector<double> picture() const {
    std::vector<Point> images;
    const int most = int(std::max(width, height) / pitch);
    for (int j = -most; j <= most; ++j)
      for (int n = -most; n <= most; ++n)
        if (const Point at = image(n, j);
            at.x > -20 && at.x < width + 20 && at.y > -20 && at.y < height + 20)
          images.push_back(at);
    std::vector<double> values;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        double sum = 0;
        const std::vector<Point> close = nearTo(images, {double(x), double(y)});
        for (int ray = 0; ray < 16; ++ray) {
          const Point at{x + (ray % 4 - 1.5) / 4, y + (ray / 4 - 1.5) / 4};
          sum += light(at, nearest(close, at));
        }
        values.push_back(sum / 16);
      }
    return values;
  }

 private:
  static double squaredDistance(const Point& a, const Point& b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
  }
  static Point nearest(const std::vector<Point>& points, const Point& at) {
    Point best = points.front();
    double least = squaredDistance(best, at);
    for (const Point& point : points) {
      const double distance = squaredDistance(point, at);
      if (distance >= least) continue;
      least = distance;
      best = point;
    }
    return best;
  }
  /// Returns the points that are nearest to any ray of a pixel.
  static std::vector<Point> nearTo(const std::vector<Point>& points, const Point& pixel) {
    constexpr double mostOff = 0.54;  // distance of a ray from the pixel's middle
    const double most = std::sqrt(squaredDistance(nearest(points, pixel), pixel)) + 2 * mostOff;
    std::vector<Point> close;
    for (const Point& point : points)
      if (squaredDistance(point, pixel) <= most * most) close.push_back(point);
    return close;
  }
};
