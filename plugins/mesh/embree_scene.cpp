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

/// The corners of the triangles that a packet meets.
struct EmbreeScene::Lanes {
  using Row = Hits::Row<double>;

  alignas(64) std::array<Row, 3> x, y, z;
  alignas(64) Hits::Row<std::int64_t> isNearEdge;
};

namespace {

// Rounding of coordinates, with a margin: eight units in the last place.
constexpr double roundings = 8 * std::numeric_limits<float>::epsilon();

/// Along the ray a triangle is a flat one: corner − ray at the corner's depth. The weights are the
/// areas that its edges span with the ray, which stands at 0. Near an edge, closer than rounding
/// goes, packets may differ from single rays.
template <class Packet, class Lanes>
MULTIVERSIONED void solve(const Packet& p, double extent, Lanes& __restrict l,
                          Hits& __restrict hits) {
  for (std::size_t i = 0; i < Hits::most; ++i) {
    const auto flatX = [&](std::size_t k) {
      return l.x[k][i] - p.x[i] - p.a[i] * (l.z[k][i] - p.z[i]);
    };
    const auto flatY = [&](std::size_t k) {
      return l.y[k][i] - p.y[i] - p.b[i] * (l.z[k][i] - p.z[i]);
    };
    const double x0 = flatX(0), x1 = flatX(1), x2 = flatX(2);
    const double y0 = flatY(0), y1 = flatY(1), y2 = flatY(2);
    const double area0 = x1 * y2 - x2 * y1;
    const double area1 = x2 * y0 - x0 * y2;
    const double area2 = x0 * y1 - x1 * y0;
    const double area = area0 + area1 + area2;
    const double side0 = (x2 - x1) * (x2 - x1) + (y2 - y1) * (y2 - y1);
    const double side1 = (x0 - x2) * (x0 - x2) + (y0 - y2) * (y0 - y2);
    const double side2 = (x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0);
    const double margin =
        roundings * (extent + std::abs(p.x[i]) + std::abs(p.y[i]) + std::abs(p.z[i]));
    const double near = margin * margin;
    l.isNearEdge[i] = (area0 * area0 <= near * side0) | (area1 * area1 <= near * side1) |
                      (area2 * area2 <= near * side2) | (area0 * area <= 0) | (area1 * area <= 0) |
                      (area2 * area <= 0);
    const double scale = area != 0 ? 1 / area : 0;
    const double w0 = std::max(area0 * scale, 0.0);
    const double w1 = std::max(area1 * scale, 0.0);
    const double w2 = std::max(area2 * scale, 0.0);
    const double sum = w0 + w1 + w2;
    const double unit = sum > 0 ? 1 / sum : 0;
    hits.weights[0][i] = sum > 0 ? w0 * unit : 1;
    hits.weights[1][i] = w1 * unit;
    hits.weights[2][i] = w2 * unit;
    hits.z[i] = hits.weights[0][i] * l.z[0][i] + hits.weights[1][i] * l.z[1][i] +
                hits.weights[2][i] * l.z[2][i];
  }
}

/// Above so many triangles the watch for ties costs more than its share of a view's time.
constexpr std::size_t mostWatched = std::size_t{1} << 18U;

/// What Embree hands on from a packet's call to watchTies().
struct Watch {
  QueryContext context;
  Hits::Row<float> depths;  ///< of the nearest triangles so far
  std::uint32_t ties = 0;
};

/// Embree calls this for each triangle that may be the nearest to some of a packet's rays. Which of
/// two at one depth it comes to first, where surfaces lie in one plane or cross, depends on the
/// packet: so it is made to look a little farther than the nearest, and both are seen.
void watchTies(const RTCFilterFunctionNArguments* arguments) {
  if (arguments->N != Hits::most) return;  // a single ray
  constexpr float margin = 1 + 4 * std::numeric_limits<float>::epsilon();
  Watch& watch = *reinterpret_cast<Watch*>(arguments->context);
  float* depths = &RTCRayN_tfar(arguments->ray, Hits::most, 0);
  for (std::size_t i = 0; i < Hits::most; ++i) {
    if (arguments->valid[i] == 0) continue;
    const float depth = depths[i];
    const float nearest = watch.depths[i];
    watch.ties |= std::uint32_t(depth <= nearest * margin && nearest <= depth * margin) << i;
    if (depth > nearest) {
      arguments->valid[i] = 0;
    } else {
      watch.depths[i] = depth;
      depths[i] = depth * margin;
    }
  }
}

struct DeviceRelease {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};

bool goOn(void* progress, double done) {
  return static_cast<const plugin::Progress*>(progress)->go(done);
}

}  // namespace

void EmbreeScene::Release::operator()(void* scene) const {
  rtcReleaseScene(static_cast<RTCScene>(scene));
}

EmbreeScene::EmbreeScene(std::vector<float> points, std::vector<Corners> triangles,
                         const std::vector<std::uint32_t>& materials, int threads,
                         const plugin::Progress& progress)
    : m_points(std::move(points)), m_triangles(std::move(triangles)) {
  for (const float x : m_points) m_extent = std::max(m_extent, double(std::abs(x)));
  m_points.push_back(0);
  m_settled.resize(m_triangles.size());
  for (std::size_t t = 0; t < m_triangles.size(); ++t) {
    m_settled[t].material = materials[t];
    for (std::size_t k = 0; k < 9; ++k)
      m_settled[t].corners[k] = m_points[std::size_t{3} * m_triangles[t][k / 3] + k % 3];
  }
  build(threads, progress);
}

void EmbreeScene::build(int threads, const plugin::Progress& progress) {
  const std::unique_ptr<RTCDeviceTy, DeviceRelease> device(
      rtcNewDevice(("threads=" + std::to_string(std::max(1, threads))).c_str()));
  if (!device) throw std::runtime_error("Embree: cannot be started: is its library whole?");
  RTCScene scene = rtcNewScene(device.get());
  m_scene.reset(scene);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
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
  const RTCError error = rtcGetDeviceError(device.get());
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
    packet.x[i] = ray.x;
    packet.y[i] = ray.y;
    packet.z[i] = ray.z;
    packet.a[i] = ray.a;
    packet.b[i] = ray.b;
    packet.reach[i] = ray.reach;
    valid[i] = i < rays.size() ? -1 : 0;
  }
  for (std::size_t i = 0; i < Hits::most; ++i) {
    packets.ray.org_x[i] = float(packet.x[i]);
    packets.ray.org_y[i] = float(packet.y[i]);
    packets.ray.org_z[i] = float(packet.z[i]);
    packets.ray.dir_x[i] = float(-packet.a[i]);
    packets.ray.dir_y[i] = float(-packet.b[i]);
    packets.ray.tfar[i] = float(packet.reach[i]);
    packets.ray.dir_z[i] = -1;
    packets.ray.tnear[i] = 0;
    packets.ray.time[i] = 0;
    packets.ray.mask[i] = UINT32_MAX;
    packets.ray.id[i] = 0;
    packets.ray.flags[i] = 0;
    packets.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packets.hit.primID[i] = Hit::none;
    packets.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  Watch watch;
  watch.depths.fill(std::numeric_limits<float>::max());
  intersect16(static_cast<RTCScene>(m_scene.get()), valid, watch.context, packets);
  packet.ties = watch.ties;
  for (std::size_t i = 0; i < Hits::most; ++i) {
    packet.triangles[i] = packets.hit.primID[i];
    if (packet.triangles[i] == Hit::none) continue;
    const Triangle* triangle = m_settled.data() + packet.triangles[i];
    __builtin_prefetch(triangle);
    __builtin_prefetch(&triangle->material);
  }
}

void EmbreeScene::gather(Lanes& lanes, Hits& hits, std::size_t lane) const {
  static constexpr Triangle nothing{};
  const std::uint32_t number = hits.triangles[lane];
  const Triangle& triangle = number == Hit::none ? nothing : m_settled[number];
  hits.materials[lane] = triangle.material;
  for (std::size_t k = 0; k < 3; ++k) {
    lanes.x[k][lane] = triangle.corners[3 * k];
    lanes.y[k][lane] = triangle.corners[3 * k + 1];
    lanes.z[k][lane] = triangle.corners[3 * k + 2];
  }
}

/// A packet may hand a ray that passes an edge to the neighbour on its other side, or to what lies
/// behind; a single ray's way depends on the ray alone.
void EmbreeScene::settle(std::span<const plugin::Ray> rays, const Packet& packet,
                         Hits& hits) const {
  Lanes lanes;
  hits.triangles = packet.triangles;
  for (std::size_t i = 0; i < Hits::most; ++i) gather(lanes, hits, i);
  solve(packet, m_extent, lanes, hits);
  bool isChanged = false;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool isTie = (packet.ties >> i & 1U) != 0;
    if (hits.triangles[i] == Hit::none || (lanes.isNearEdge[i] == 0 && !isTie)) continue;
    const std::uint32_t alone = meetAlone(rays[i]);
    if (alone == hits.triangles[i]) continue;
    hits.triangles[i] = alone;
    gather(lanes, hits, i);
    isChanged = true;
  }
  if (isChanged) solve(packet, m_extent, lanes, hits);
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
  return ray.tfar < 0;  // Embree's sign of a hit
}

}  // namespace hogelscope::mesh
