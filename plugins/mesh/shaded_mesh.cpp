// SPDX-License-Identifier: BSD-3-Clause
#include "shaded_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "errors.h"
#include "lighting.h"
#include "repeated_triangles.h"
#include "srgb.h"

namespace hogelscope::mesh {

namespace {

/// The ambient light in files with lamps, so that unlit parts are not black.
constexpr float ambientLight = 0.1F;

Affine displayFromFile(const Pose& pose) {
  const RigidTransform turn = transformFromPose(pose.position, pose.orientation);
  return {{pose.scale * turn.xAxis, pose.scale * turn.yAxis, pose.scale * turn.zAxis}, turn.origin};
}

std::vector<float> placedPoints(const Posture& posture, const Affine& frame, double scale,
                                const std::string& file) {
  std::vector<float> points;
  points.reserve(posture.points.size() * 3 + 1);
  constexpr double farthest = 1e6;
  constexpr double leastScale = 1e-5;  // a smaller scale leaves almost nothing
  for (const Vec3& point : posture.points) {
    const Vec3 p = frame.point(point);
    if (!(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= farthest))
      fail(file, "reaches farther than 1000 km from the panel",
           scale > leastScale ? "make its scale smaller" : "it is too large for any scale");
    for (const double x : {p.x, p.y, p.z}) points.push_back(float(x));
  }
  return points;
}

plugin::Colour codes(const Linear& light) {
  return {codeOf(light[0]), codeOf(light[1]), codeOf(light[2])};
}

Linear product(const Linear& a, const Linear& b) {
  return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
}

Linear sum(const Linear& a, const Linear& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// Returns the weighted mean of a triangle's three corners.
template <class List>
auto blended(const List& list, const Corners& corners, const std::array<double, 3>& weights) {
  typename List::value_type mean{};
  for (std::size_t c = 0; c < mean.size(); ++c)
    mean[c] =
        float(weights[0] * double(list[corners[0]][c]) + weights[1] * double(list[corners[1]][c]) +
              weights[2] * double(list[corners[2]][c]));
  return mean;
}

}  // namespace

ShadedMesh::ShadedMesh(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Posture> posture,
                       const Pose& pose, int threads, const plugin::Progress& progress)
    : m_mesh(std::move(mesh)),
      m_posture(std::move(posture)),
      m_materialOf(m_mesh->materialOf),
      m_unit(pose.scale) {
  const Affine frame = displayFromFile(pose);
  std::vector<float> points = placedPoints(*m_posture, frame, pose.scale, m_mesh->files[0]);
  std::vector<Corners> triangles = withoutRepeated(m_mesh->triangles, points, m_materialOf);
  m_displayFromFile = frame;
  m_back = std::numeric_limits<double>::max();
  m_front = std::numeric_limits<double>::lowest();
  for (const Corners& corners : triangles) {
    for (const std::uint32_t corner : corners) {
      const double z = points[std::size_t{3} * corner + 2];
      m_back = std::min(m_back, z);
      m_front = std::max(m_front, z);
    }
  }
  m_scene = std::make_unique<EmbreeScene>(std::move(points), std::move(triangles), m_materialOf,
                                          threads, progress);
  placeLights(frame);
}

void ShadedMesh::placeLights(const Affine& frame) {
  for (Light light : m_posture->lights) {
    light.position = frame.point(light.position);
    light.direction = normalise(frame.direction(light.direction));
    m_lights.push_back(light);
  }
  m_ambient = m_lights.empty() ? 0 : ambientLight;
  if (!m_lights.empty()) return;
  constexpr auto white = float(std::numbers::pi);
  m_lights.push_back({});  // a headlight along −z
  m_lights.back().intensity = {white, white, white};
}

void ShadedMesh::setLook(Shading shading, const plugin::Panel& panel,
                         const plugin::Colour& background) {
  m_shading = shading;
  m_background = background;
  m_pitch = (panel.size[0] / panel.hogels[0] + panel.size[1] / panel.hogels[1]) / 2;
  m_slopeStep = (panel.slopeStep[0] + panel.slopeStep[1]) / 2;
  m_plain.clear();
  for (const Material& material : m_mesh->materials) {
    const bool isLit = m_shading == Shading::lambert && !material.isUnlit;
    m_plain.emplace_back();
    if (!isLit && material.layer.texture < 0 && material.glow.texture < 0 &&
        m_mesh->colours.empty())
      m_plain.back() = codes(sum(material.colour, material.emission));
  }
}

void ShadedMesh::trace(std::span<const plugin::Ray> rays, std::span<plugin::Colour> colours) const {
  m_scene->trace(rays, [&](const Hits& hits, std::size_t first) {
    const std::size_t count = std::min(Hits::most, rays.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const plugin::Ray& ray = rays[first + i];
      const std::uint32_t triangle = hits.triangles[i];
      const bool isMissed = triangle == Hit::none;
      const auto& plain = m_plain[hits.materials[i]];
      colours[first + i] = isMissed ? m_background
                           : plain  ? *plain
                                    : colour(m_scene->hit(ray, triangle), hits.materials[i], ray);
    }
  });
}

void ShadedMesh::traceDepths(std::span<const plugin::Ray> rays, std::span<double> depths) const {
  m_scene->trace(rays, [&](const Hits& hits, std::size_t first) {
    for (std::size_t i = 0; i < std::min(Hits::most, rays.size() - first); ++i)
      depths[first + i] = hits.triangles[i] == Hit::none
                              ? std::numeric_limits<double>::quiet_NaN()
                              : m_scene->hit(rays[first + i], hits.triangles[i]).z;
  });
}

plugin::Colour ShadedMesh::colour(const Hit& hit, std::uint32_t number,
                                  const plugin::Ray& ray) const {
  const Material& material = m_mesh->materials[number];
  const Linear surface = albedo(hit, material);
  const bool isLit = m_shading == Shading::lambert && !material.isUnlit;
  return codes(sum(isLit ? product(surface, lightOn(hit, ray)) : surface, emission(hit, material)));
}

Linear ShadedMesh::albedo(const Hit& hit, const Material& material) const {
  Linear light = material.colour;
  if (!m_mesh->colours.empty())
    light = product(light, blended(m_mesh->colours, m_scene->corners(hit.triangle), hit.weights));
  return product(light, textureColour(hit, material.layer));
}

Linear ShadedMesh::emission(const Hit& hit, const Material& material) const {
  if (material.emission == Linear{}) return {};
  return product(material.emission, textureColour(hit, material.glow));
}

/// Returns a texture's colour at the level whose texels are as wide as a directional pixel's light
/// at the hit's depth.
Linear ShadedMesh::textureColour(const Hit& hit, const Layer& layer) const {
  if (layer.texture < 0 || m_mesh->uv.empty()) return {1, 1, 1};
  const Texture& texture = m_mesh->textures[std::size_t(layer.texture)];
  const Corners& corners = m_scene->corners(hit.triangle);
  const auto& uv = m_mesh->uv;
  const auto edge = [&](std::size_t k, std::size_t axis) {
    return double(uv[corners[k]][axis]) - double(uv[corners[0]][axis]);
  };
  const Vec3 p0 = m_scene->point(corners[0]);
  const double area =
      length(cross(m_scene->point(corners[1]) - p0, m_scene->point(corners[2]) - p0));
  const double texels =
      std::abs((edge(1, 0) * edge(2, 1) - edge(1, 1) * edge(2, 0)) * layer.area()) * texture.size();
  const double width = m_pitch + std::abs(hit.z) * m_slopeStep;
  const double level = area > 0 && texels > 0 ? std::log2(width * std::sqrt(texels / area)) : 0;
  const Vec2 at = layer.place(blended(uv, corners, hit.weights));
  return texture.sample(at.x, at.y, level, layer.wrap);
}

Vec3 ShadedMesh::shadingNormal(const Hit& hit, const Vec3& geometric) const {
  if (m_posture->normals.empty()) return geometric;
  const auto mean = blended(m_posture->normals, m_scene->corners(hit.triangle), hit.weights);
  const Vec3 n = normalise(m_displayFromFile.direction({mean[0], mean[1], mean[2]}));
  if (n == Vec3{}) return geometric;
  return dot(n, geometric) < 0 ? -1.0 * n : n;
}

/// Returns the light on the side of the surface that the ray sees.
Linear ShadedMesh::lightOn(const Hit& hit, const plugin::Ray& ray) const {
  const Corners& corners = m_scene->corners(hit.triangle);
  const Vec3 p0 = m_scene->point(corners[0]);
  const Vec3 p1 = m_scene->point(corners[1]);
  const Vec3 p2 = m_scene->point(corners[2]);
  Vec3 side = normalise(cross(p1 - p0, p2 - p0));
  if (dot(side, {ray.a, ray.b, 1}) < 0) side = -1.0 * side;
  const Vec3 normal = shadingNormal(hit, side);
  const Vec3 point = hit.weights[0] * p0 + hit.weights[1] * p1 + hit.weights[2] * p2;
  const double reach =
      std::max({m_scene->extent(), std::abs(point.x), std::abs(point.y), std::abs(point.z)});
  const Vec3 start = point + (4 * std::numeric_limits<float>::epsilon() * reach) * side;
  Linear shown{m_ambient, m_ambient, m_ambient};
  for (const Light& light : m_lights) {
    const auto arriving = lightAt(light, point, m_unit);
    if (!arriving || !(dot(side, arriving->way) > 0)) continue;
    const double cosine = dot(normal, arriving->way) / length(arriving->way);
    if (!(cosine > 0)) continue;
    const Vec3 way = arriving->isDirection ? arriving->way : light.position - start;
    if (m_scene->isBlocked(start, way, arriving->isDirection)) continue;
    for (std::size_t c = 0; c < 3; ++c) shown[c] += float(cosine) * arriving->strength[c];
  }
  return shown;
}

plugin::Triangles ShadedMesh::triangles() const {
  plugin::Triangles shown;
  shown.points.assign(m_scene->points().begin(), m_scene->points().end());
  shown.colours.assign(shown.points.size(), 255);
  for (std::uint32_t t = 0; t < m_scene->triangles().size(); ++t) {
    const Corners& corners = m_scene->corners(t);
    shown.corners.insert(shown.corners.end(), corners.begin(), corners.end());
    for (std::size_t k = 0; k < 3; ++k) {
      Hit corner{t, {}, m_scene->point(corners[k]).z};
      corner.weights[k] = 1;
      const Material& material = m_mesh->materials[m_materialOf[t]];
      const plugin::Colour code = codes(sum(albedo(corner, material), emission(corner, material)));
      std::uint8_t* rgb = &shown.colours[std::size_t{3} * corners[k]];
      rgb[0] = std::uint8_t(std::lround(code.r));
      rgb[1] = std::uint8_t(std::lround(code.g));
      rgb[2] = std::uint8_t(std::lround(code.b));
    }
  }
  return shown;
}

}  // namespace hogelscope::mesh
