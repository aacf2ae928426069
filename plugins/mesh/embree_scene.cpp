// SPDX-License-Identifier: BSD-3-Clause
#include "embree_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "core/base/multiversioned.h"
#include "embree.h"

namespace hogelscope::mesh {

namespace {

/// Twice eight units in the last place of the coordinates: the rounding error with a margin.
constexpr float roundings = 16 * std::numeric_limits<float>::epsilon();

/// Computes the longest side up to which a triangle's edges are farther from the ray than rounding
/// errors. A weight times the doubled area across the ray is a side times its distance.
MULTIVERSIONED void findCertain(const RTCRayHit16& p, float extent, float* __restrict certain) {
  for (std::size_t i = 0; i < Hits::most; ++i) {
    const float x = p.ray.dir_x[i], y = p.ray.dir_y[i];
    const float least = std::min({p.hit.u[i], p.hit.v[i], 1 - p.hit.u[i] - p.hit.v[i]});
    const float area = std::abs(p.hit.Ng_x[i] * x + p.hit.Ng_y[i] * y - p.hit.Ng_z[i]);
    const float margin = roundings * (extent + std::abs(p.ray.org_x[i]) + std::abs(p.ray.org_y[i]) +
                                      std::abs(p.ray.org_z[i]));
    const float stretch = 1 + std::abs(x) + std::abs(y);  // of sides as seen by the ray
    certain[i] = least * area / (margin * stretch);
  }
}

/// The limit for detecting ties; beyond it detection would take too much of a view's time.
constexpr std::size_t mostWatched = std::size_t{1} << 18U;

/// The data that Embree passes from a packet's call to watchTies().
struct Watch {
  QueryContext context;
  Hits::Row<float> depths;  ///< of the nearest triangles so far
  std::uint32_t ties = 0;
};

/// Embree calls this for each triangle that may be the nearest to some of a packet's rays. Of two
/// at one depth, where surfaces are coplanar or intersect, the first one depends on the packet. The
/// search therefore extends slightly beyond the nearest, so that both are found. Processors without
/// AVX-512 get a packet in parts, so a ray's place in it is its id; 0 is a ray that is traced
/// alone.
void watchTies(const RTCFilterFunctionNArguments* arguments) {
  constexpr float margin = 1 + 4 * std::numeric_limits<float>::epsilon();
  const unsigned lanes = arguments->N;
  for (unsigned lane = 0; lane < lanes; ++lane) {
    const unsigned id = RTCRayN_id(arguments->ray, lanes, lane);
    if (arguments->valid[lane] == 0 || id == 0) continue;
    Watch& watch = *reinterpret_cast<Watch*>(arguments->context);
    float& nearest = watch.depths[id - 1];
    float& reach = RTCRayN_tfar(arguments->ray, lanes, lane);
    const float depth = reach;
    watch.ties |= std::uint32_t(depth <= nearest * margin && nearest <= depth * margin) << (id - 1);
    if (depth > nearest) {
      arguments->valid[lane] = 0;
    } else {
      nearest = depth;
      reach = depth * margin;
    }
  }
}

bool goOn(void* progress, double done) {
  return static_cast<const plugin::Progress*>(progress)->go(done);
}

}  // namespace

void EmbreeScene::DeviceRelease::operator()(void* device) const {
  rtcReleaseDevice(static_cast<RTCDevice>(device));
}

void EmbreeScene::SceneRelease::operator()(void* scene) const {
  rtcReleaseScene(static_cast<RTCScene>(scene));
}

EmbreeScene::EmbreeScene(std::vector<float> points, std::vector<Corners> triangles,
                         const std::vector<std::uint32_t>& materials, int threads,
                         const plugin::Progress& progress)
    : m_points(std::move(points)), m_triangles(std::move(triangles)) {
  for (const float x : m_points) m_extent = std::max(m_extent, double(std::abs(x)));
  m_points.push_back(0);
  m_traits.reserve(m_triangles.size());
  for (std::size_t t = 0; t < m_triangles.size(); ++t) {
    const auto& [a, b, c] = m_triangles[t];
    const double longest = std::max(
        {length(point(b) - point(a)), length(point(c) - point(b)), length(point(a) - point(c))});
    m_traits.push_back({float(longest), materials[t]});
  }
  build(threads, progress);
}

void EmbreeScene::build(int threads, const plugin::Progress& progress) {
  RTCDevice device = rtcNewDevice(("threads=" + std::to_string(std::max(1, threads))).c_str());
  m_device.reset(device);
  if (!m_device) throw std::runtime_error("Embree: cannot be started: is its library whole?");
  RTCScene scene = rtcNewScene(device);
  m_scene.reset(scene);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             m_points.data(), 0, 3 * sizeof(float), m_points.size() / 3);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             m_triangles.data(), 0, sizeof(Corners), m_triangles.size());
  if (m_triangles.size() <= mostWatched)
    rtcSetGeometryIntersectFilterFunction(geometry, &watchTies);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcSetSceneProgressMonitorFunction(scene, &goOn, const_cast<plugin::Progress*>(&progress));
  rtcCommitScene(scene);
  rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_CANCELLED) throw std::runtime_error("stopped");
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  if (error != RTC_ERROR_NONE)
    throw std::runtime_error("Embree: cannot build the scene: error " + std::to_string(error));
}

void EmbreeScene::meet(std::span<const plugin::Ray> rays, Packet& packet) const {
  RTCRayHit16 packets;
  alignas(64) int valid[Hits::most];
  for (std::size_t i = 0; i < Hits::most; ++i) {
    const plugin::Ray& ray = rays[std::min(i, rays.size() - 1)];
    packets.ray.org_x[i] = float(ray.x);
    packets.ray.org_y[i] = float(ray.y);
    packets.ray.org_z[i] = float(ray.z);
    packets.ray.dir_x[i] = float(-ray.a);
    packets.ray.dir_y[i] = float(-ray.b);
    packets.ray.tfar[i] = float(ray.reach);
    valid[i] = i < rays.size() ? -1 : 0;
  }
  for (std::size_t i = 0; i < Hits::most; ++i) {
    packets.ray.dir_z[i] = -1;
    packets.ray.tnear[i] = 0;
    packets.ray.time[i] = 0;
    packets.ray.mask[i] = UINT32_MAX;
    packets.ray.id[i] = unsigned(i) + 1;
    packets.ray.flags[i] = 0;
    packets.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packets.hit.primID[i] = Hit::none;
    packets.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  Watch watch;
  watch.depths.fill(std::numeric_limits<float>::max());
  intersect16(static_cast<RTCScene>(m_scene.get()), valid, watch.context, packets);
  packet.ties = watch.ties;
  packet.triangles = std::to_array(packets.hit.primID);
  findCertain(packets, float(m_extent), packet.certain.data());
  for (const std::uint32_t triangle : packet.triangles)
    if (triangle != Hit::none) __builtin_prefetch(m_traits.data() + triangle);
}

/// Traces uncertain rays again as single rays. A packet may assign a ray through an edge to the
/// neighbouring triangle or to what lies behind; a single ray's result depends on the ray only.
void EmbreeScene::settle(std::span<const plugin::Ray> rays, const Packet& packet,
                         Hits& hits) const {
  hits.triangles = packet.triangles;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    std::uint32_t& triangle = hits.triangles[i];
    hits.materials[i] = 0;
    if (triangle == Hit::none) continue;
    const bool isTie = (packet.ties >> i & 1U) != 0;
    const bool isCertain = m_traits[triangle].longestSide < packet.certain[i];
    if (isTie || !isCertain) triangle = meetAlone(rays[i]);
    if (triangle != Hit::none) hits.materials[i] = m_traits[triangle].material;
  }
}

std::uint32_t EmbreeScene::meetAlone(const plugin::Ray& ray) const {
  RTCRayHit single{};
  single.ray.org_x = float(ray.x);
  single.ray.org_y = float(ray.y);
  single.ray.org_z = float(ray.z);
  single.ray.dir_x = float(-ray.a);
  single.ray.dir_y = float(-ray.b);
  single.ray.dir_z = -1;
  single.ray.tfar = float(ray.reach);
  single.ray.mask = UINT32_MAX;
  single.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  single.hit.primID = Hit::none;
  single.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  intersect1(static_cast<RTCScene>(m_scene.get()), single);
  return single.hit.primID;
}

/// Projects the triangle along the ray: corner − ray at the corner's depth. The weights are the
/// areas spanned by its edges and the ray, which is at 0.
Hit EmbreeScene::hit(const plugin::Ray& ray, std::uint32_t triangle) const {
  const Corners& corners = m_triangles[triangle];
  std::array<Vec2, 3> flat;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 p = point(corners[k]);
    flat[k] = {p.x - ray.x - ray.a * (p.z - ray.z), p.y - ray.y - ray.b * (p.z - ray.z)};
  }
  const auto area = [&](std::size_t i, std::size_t j) {
    return flat[i].x * flat[j].y - flat[j].x * flat[i].y;
  };
  Hit hit{triangle, {area(1, 2), area(2, 0), area(0, 1)}, 0};
  auto& weights = hit.weights;
  const double whole = weights[0] + weights[1] + weights[2];
  for (double& weight : weights) weight = std::max(0.0, weight / whole);  // 0 for NaN
  const double sum = weights[0] + weights[1] + weights[2];
  if (!(sum > 0)) weights = {1, 0, 0};  // a triangle seen from its edge
  for (std::size_t k = 0; k < 3; ++k) {
    if (sum > 0) weights[k] /= sum;
    hit.z += weights[k] * point(corners[k]).z;
  }
  return hit;
}

bool EmbreeScene::isBlocked(const Vec3& from, const Vec3& way, bool isDirection) const {
  RTCRay ray{};
  ray.org_x = float(from.x);
  ray.org_y = float(from.y);
  ray.org_z = float(from.z);
  ray.dir_x = float(way.x);
  ray.dir_y = float(way.y);
  ray.dir_z = float(way.z);
  ray.tfar = isDirection ? std::numeric_limits<float>::infinity() : 1;
  ray.mask = UINT32_MAX;
  occluded1(static_cast<RTCScene>(m_scene.get()), ray);
  return ray.tfar < 0;  // Embree's mark of a hit
}

}  // namespace hogelscope::mesh
