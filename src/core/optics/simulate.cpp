// SPDX-License-Identifier: BSD-3-Clause
#include "core/optics/simulate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/light_field/light_field.h"
#include "core/panel/twin.h"

namespace hogelscope {

namespace {

/// The two cells whose centres lie around a real-valued index, and the weight of the second one. At
/// the border both are the edge cell.
struct Neighbours {
  std::array<int, 2> cell;
  double share;
};

/// The texels as a twin's panel drives them.
class DrivenTexels : public LightFieldSource {
 public:
  DrivenTexels(std::shared_ptr<const LightFieldSource> content, std::shared_ptr<const Twin> twin)
      : m_content(std::move(content)), m_twin(std::move(twin)) {}

  [[nodiscard]] LightFieldSize size() const override { return m_content->size(); }
  [[nodiscard]] StoredType type() const override { return m_content->type(); }
  [[nodiscard]] std::shared_ptr<const LightField> slice(const ViewReads& reads,
                                                        const Progress& progress) const override {
    return m_content->slice(reads, progress);
  }
  [[nodiscard]] std::shared_ptr<const LightField> overview() const override {
    return m_content->overview();
  }
  [[nodiscard]] Rgb texel(const TexelIndex& at) const override {
    if (m_twin->hasDead() && m_twin->isDead(at)) return {};
    const Rgb code = m_content->texel(at);
    if (!m_twin->drivesTexels()) return code;
    const auto seen = [this](double value) {
      return encodedFromLinear(panelLight(m_twin->params().light, value));
    };
    return {seen(code.r), seen(code.g), seen(code.b)};
  }

 private:
  std::shared_ptr<const LightFieldSource> m_content;
  std::shared_ptr<const Twin> m_twin;
};

Neighbours neighbours(double index, int count, bool interpolate) {
  const int nearest = static_cast<int>(index);
  if (!interpolate) return {{nearest, nearest}, 0};
  const double left = std::floor(index - 0.5);
  const int cell = static_cast<int>(left);
  return {{std::max(cell, 0), std::min(cell + 1, count - 1)}, index - 0.5 - left};
}

}  // namespace

std::optional<Vec2> idealPoint(const Distortion& distortion, LensMapping mapping,
                               const Vec2& onSensor) {
  return mapping == LensMapping::exact ? distortion.undistort(onSensor)
                                       : distortion.distort(onSensor);
}

void checkContent(const RenderJob& job) {
  checkContent(job, Display(job.display, job.twin));
}

void checkContent(const RenderJob& job, const Display& display) {
  if (!job.lightField) throw InputError("lightField", "is not loaded");
  (void)resolved(job.display, job.lightField->size());
  const DisplayTraits& traits = display.traits();
  display.checkContent(job.lightField->size());
  if (!traits.hasDirections) {
    checkWithoutDirections(job.sampling, job.twin ? job.twin->params() : TwinParams{});
    checkWithoutDirections(job.state.psf, "");
  }
  if (traits.needsLinearLight && job.state.psf.light != LightModel::linear)
    throw InputError("psf.light", "must be \"linear\", because the twin scales or adds light");
  if ((traits.hasUnlikeHogels || FieldLeakage::isNeeded(job.twin.get(), job.state.psf)) &&
      job.sampling.reconstruction == Reconstruction::quadrilinear)
    throw InputError(
        "sampling.reconstruction",
        "cannot be \"quadrilinear\", because the twin's hogels differ from each other");
}

Simulation::Simulation(RenderJob job)
    : m_job(std::move(job)),
      m_display(m_job.display, m_job.twin),
      m_camera(m_job.state.camera, m_job.state.intrinsics),
      m_distortion(m_job.state.distortion),
      m_psf(m_job.state.psf),
      m_samples(samplesOf(m_job.sampling.samplesPerPixel)),
      m_aperture(
          apertureOf(m_job.state.pupil, m_job.state.camera, m_job.display, m_job.method.aperture)) {
  checkContent(m_job, m_display);
  if (FieldLeakage::isNeeded(m_job.twin.get(), m_job.state.psf))
    m_leakage.emplace(*m_job.twin, m_job.state.psf);
  if (m_display.traits().drivesTexels)
    m_job.lightField = std::make_shared<const DrivenTexels>(m_job.lightField, m_job.twin);
  for (const AperturePoint& point : m_aperture.points)
    m_displayFromPoint.push_back(m_display.displayFromWorld() *
                                 fromPoint(m_camera.worldFromCamera(), point));
}

/// Returns the hits of red, green and blue; none unless all see the display.
std::optional<std::array<Hit, 3>> Simulation::hitsOf(const Vec2& ideal,
                                                     const RigidTransform& from) const {
  const bool isSplit = m_display.traits().splitsColours;
  const Vec3 direction = from.direction({ideal.x, ideal.y, 1});
  std::array<Hit, 3> hits;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const std::optional<Hit> hit =
        channel == 0 || isSplit ? m_display.hit(from.origin, direction, channel) : hits[0];
    if (!hit) return std::nullopt;
    hits[channel] = *hit;
  }
  return hits;
}

Rgb Simulation::leaked(const TexelIndex& at) const {
  if (!m_leakage) return m_psf.leaked(*m_job.lightField, at);
  return m_leakage->leaked(m_display.size(), at, [this](const TexelIndex& tap) {
    return decoded(m_job.state.psf.light, m_job.lightField->texel(tap));
  });
}

/// Sums the pixels beside the one that a ray meets; beyond the panel there are none.
Rgb Simulation::spotLight(const Hit& hit, const std::vector<double>& spot) const {
  Rgb sum;
  const auto reach = static_cast<int>(spot.size() / 2);
  for (int k = -reach; k <= reach; ++k) {
    const TexelIndex at{static_cast<int>(hit.i) + k, static_cast<int>(hit.j), 0, 0};
    if (at.i >= 0 && at.i < m_display.size().nx)
      sum = sum + spot[std::size_t(k + reach)] * leaked(at);
  }
  return sum;
}

Rgb Simulation::reconstructed(const Hit& hit) const {
  const std::vector<double>& spot = m_display.traits().spot;
  if (!spot.empty()) return spotLight(hit, spot);
  const LightFieldSize& size = m_display.size();
  const Reconstruction reconstruction = m_job.sampling.reconstruction;
  const bool hogelsToo = reconstruction == Reconstruction::quadrilinear;
  const bool directions = reconstruction != Reconstruction::nearest;
  const std::array axes{
      neighbours(hit.i, size.nx, hogelsToo), neighbours(hit.j, size.ny, hogelsToo),
      neighbours(hit.u, size.du, directions), neighbours(hit.v, size.dv, directions)};
  Rgb sum;
  for (unsigned corner = 0; corner < 16; ++corner) {
    std::array<int, 4> index{};
    double weight = 1;
    for (unsigned axis = 0; axis < 4; ++axis) {
      const unsigned side = corner >> axis & 1U;
      index[axis] = axes[axis].cell[side];
      weight *= side == 1 ? axes[axis].share : 1 - axes[axis].share;
    }
    if (weight > 0) sum = sum + weight * leaked({index[0], index[1], index[2], index[3]});
  }
  return sum;
}

/// Returns the light that a ray's pixels send.
Rgb Simulation::sent(const std::array<Hit, 3>& hits) const {
  const bool isSplit = m_display.traits().splitsColours;
  Rgb light = reconstructed(hits[0]);
  if (isSplit) light = {light.r, reconstructed(hits[1]).g, reconstructed(hits[2]).b};
  return m_display.traits().changesLight ? m_job.twin->lit(hits, light) : light;
}

/// Returns the points of the plane z = 1 that a pixel's rays come from, of the samples that have a
/// ray: the same for all points of the aperture.
std::vector<Vec2> Simulation::ideals(int x, int y) const {
  std::vector<Vec2> ideals;
  for (const RaySample& sample : m_samples) {
    const Vec2 onSensor = m_camera.normalised(x + sample.place.x - 0.5, y + sample.place.y - 0.5);
    if (const auto ideal = idealPoint(m_distortion, m_job.sampling.mapping, onSensor))
      ideals.push_back(*ideal);
  }
  return ideals;
}

/// Averages the pixel's rays from one point of the aperture.
std::optional<Rgb> Simulation::lightFrom(const RigidTransform& point,
                                         const std::vector<Vec2>& ideals) const {
  bool seen = false;
  Rgb sum;
  for (const Vec2& ideal : ideals) {
    const auto hits = hitsOf(ideal, point);
    seen = seen || hits;
    if (hits) sum = sum + sent(*hits);
  }
  if (!seen) return std::nullopt;
  const auto rays = double(m_samples.size());
  return encoded(m_job.state.psf.light, {sum.r / rays, sum.g / rays, sum.b / rays});
}

std::optional<PixelLight> Simulation::pixel(int x, int y) const {
  const std::vector<Vec2> rays = ideals(x, y);
  if (m_aperture.isPinhole) {
    const std::optional<Rgb> light = lightFrom(m_displayFromPoint.front(), rays);
    return light ? std::optional(PixelLight{*light}) : std::nullopt;
  }
  Rgb sum;
  std::size_t seeing = 0;
  for (const RigidTransform& point : m_displayFromPoint) {
    const std::optional<Rgb> light = lightFrom(point, rays);
    if (!light) continue;
    ++seeing;
    sum = sum + decoded(LightModel::linear, *light);
  }
  if (seeing == 0) return std::nullopt;
  const std::size_t points = m_displayFromPoint.size();
  return PixelLight{encoded(LightModel::linear, (1.0 / double(points)) * sum), seeing == points};
}

void Simulation::render(int x, int y, Image& image) const {
  const std::optional<PixelLight> colour = pixel(x, y);
  if (!colour) return;
  const std::size_t at = std::size_t(y) * std::size_t(image.width) + std::size_t(x);
  if (colour->isSeen) image.seen[at] = 255;
  image.rgb[3 * at] = quantised(colour->r);
  image.rgb[3 * at + 1] = quantised(colour->g);
  image.rgb[3 * at + 2] = quantised(colour->b);
}

Image simulate(const RenderJob& job) {
  const Simulation simulation(job);
  const auto [width, height] = job.state.camera.res;
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) simulation.render(x, y, image);
  return image;
}

}  // namespace hogelscope
