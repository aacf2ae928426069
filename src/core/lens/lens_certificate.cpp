// SPDX-License-Identifier: BSD-3-Clause
#include "core/lens/lens_certificate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <mutex>
#include <numbers>

namespace hogelscope {

namespace {

/// Returns the smaller eigenvalue of the model's Jacobian, which is symmetric.
double leastEigenvalue(const Jacobian& j) {
  return (j.xx + j.yy - std::hypot(j.xx - j.yy, 2 * j.xy)) / 2;
}

/// Returns the radius of the first singular point along a direction, or `farthest`. It marches in
/// steps within which the eigenvalue cannot reach 0.
double singularAt(const Distortion& distortion, double angle, double farthest,
                  const Progress& progress) {
  double radius = 0;
  while (radius < farthest) {
    throwIfCancelled(progress);
    const Vec2 here{radius * std::cos(angle), radius * std::sin(angle)};
    const double step = distortion.safeStep(radius, leastEigenvalue(distortion.jacobian(here)),
                                            0.2 * radius + 0.05);
    if (!(step > 1e-9 * (1 + radius))) return radius;
    radius += step;
  }
  return farthest;
}

/// Adds a row of rays to a certificate; lengths in it are squared.
void add(const LensKey& key, int y, const double* idealX, const double* idealY,
         LensCertificate& squared) {
  const Distortion distortion(key.distortion);
  for (int x = 0; x < key.res[0]; ++x) {
    ++squared.pixels;
    const Vec2 ideal{idealX[x], idealY[x]};
    if (std::isnan(ideal.x)) {
      ++squared.withoutRay;
      continue;
    }
    squared.reach = std::max(squared.reach, ideal.x * ideal.x + ideal.y * ideal.y);
    if (key.mapping == LensMapping::direct) continue;
    const Vec2 back = distortion.distort(ideal);
    const double dx = key.focalLength.x * back.x + key.centre.x - x;
    const double dy = key.focalLength.y * back.y + key.centre.y - y;
    squared.worstResidual = std::max(squared.worstResidual, dx * dx + dy * dy);
  }
}

}  // namespace

double validRadius(const Distortion& distortion, const Progress& progress) {
  if (const Fisheye* lens = distortion.fisheye(); lens != nullptr)
    return lens->folds() ? std::tan(lens->end()) : std::numeric_limits<double>::infinity();
  const int directions = distortion.isRound() ? 1 : 720;  // 1: all are alike
  double radius = distortion.marchEnd();
  for (int k = 0; k < directions; ++k) {
    const double angle = 2 * std::numbers::pi * k / directions;
    radius = std::min(radius, singularAt(distortion, angle, radius, progress));
  }
  if (radius < distortion.marchEnd()) return radius;
  return distortion.pole() <= 100 ? distortion.pole() : std::numeric_limits<double>::infinity();
}

LensCertificate certify(const LensKey& lens, const ParallelRows& parallelRows,
                        const Progress& progress) {
  const Progress heard = forThreads(progress);
  LensKey key = lens;
  key.samplesPerPixel = 1;
  const LensRays rays(key, heard);
  std::mutex mutex;
  LensCertificate all;
  parallelRows(key.res[1], [&](int begin, int end) {
    std::vector<double> x(std::size_t(key.res[0]));
    std::vector<double> y(x.size());
    LensCertificate part;
    for (int row = begin; row < end; ++row) {
      throwIfCancelled(heard);
      rays.row(row, {}, 0, key.res[0], x.data(), y.data());
      add(key, row, x.data(), y.data(), part);
    }
    const std::lock_guard lock(mutex);
    all.reach = std::max(all.reach, part.reach);
    all.worstResidual = std::max(all.worstResidual, part.worstResidual);
    all.withoutRay += part.withoutRay;
    all.pixels += part.pixels;
  });
  const Distortion distortion(key.distortion);
  all.validRadius = validRadius(distortion, heard);
  all.endsAtRightAngle = distortion.fisheye() != nullptr && !distortion.fisheye()->folds();
  all.reach = std::sqrt(all.reach);
  all.worstResidual = std::sqrt(all.worstResidual);
  return all;
}

std::string certificateText(const LensCertificate& certificate) {
  const auto degrees = [](double slope) { return std::atan(slope) * 180 / std::numbers::pi; };
  std::array<char, 300> line{};
  if (certificate.endsAtRightAngle)
    std::snprintf(line.data(), line.size(), "one-to-one up to 90° off the axis");
  else if (std::isinf(certificate.validRadius))
    std::snprintf(line.data(), line.size(), "one-to-one everywhere");
  else
    std::snprintf(line.data(), line.size(), "one-to-one within r = %.4f (%.2f° off the axis)",
                  certificate.validRadius, degrees(certificate.validRadius));
  const std::string range = line.data();
  std::snprintf(line.data(), line.size(),
                "; the picture's rays reach r = %.4f (%.2f°), worst residual %.1e px, %zu of %zu "
                "pixels have no ray",
                certificate.reach, degrees(certificate.reach), certificate.worstResidual,
                certificate.withoutRay, certificate.pixels);
  if (!certificate.endsAtRightAngle || certificate.withoutRay == 0) return range + line.data();
  return range + line.data() + ", since they would be 90° off the axis or more";
}

}  // namespace hogelscope
