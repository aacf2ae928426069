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

/// Sixteen rays, the corners of the triangles that they meet, and where they meet them.
struct EmbreeScene::Lanes {
  using Row = std::array<double, packet>;

  alignas(64) Row x{}, y{}, z{}, a{}, b{};
  alignas(64) std::array<Row, 3> cornerX{}, cornerY{}, cornerZ{};
  alignas(64) Row tolerance{};  ///< how near to an edge packets may differ from single rays, metres
  alignas(64) std::array<Row, 3> weights{};
  alignas(64) Row depth{};
  alignas(64) std::array<long long, packet> isNearEdge{};
  std::array<std::uint32_t, packet> triangles{};
};

namespace {

/// Along the ray a triangle is a flat one: corner − ray at the corner's depth. The weights are the
/// areas that its edges span with the ray, which stands at 0.
template <class Lanes>
MULTIVERSIONED void solve(Lanes& l) {
  for (std::size_t i = 0; i < EmbreeScene::packet; ++i) {
    const auto flatX = [&](std::size_t k) {
      return l.cornerX[k][i] - l.x[i] - l.a[i] * (l.cornerZ[k][i] - l.z[i]);
    };
    const auto flatY = [&](std::size_t k) {
      return l.cornerY[k][i] - l.y[i] - l.b[i] * (l.cornerZ[k][i] - l.z[i]);
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
    const double near = l.tolerance[i] * l.tolerance[i];
    l.isNearEdge[i] = (area0 * area0 <= near * side0) | (area1 * area1 <= near * side1) |
                      (area2 * area2 <= near * side2) | (area0 * area <= 0) | (area1 * area <= 0) |
                      (area2 * area <= 0);
    const double scale = area != 0 ? 1 / area : 0;
    const double w0 = std::max(area0 * scale, 0.0);
    const double w1 = std::max(area1 * scale, 0.0);
    const double w2 = std::max(area2 * scale, 0.0);
    const double sum = w0 + w1 + w2;
    const double unit = sum > 0 ? 1 / sum : 0;
    l.weights[0][i] = sum > 0 ? w0 * unit : 1;
    l.weights[1][i] = w1 * unit;
    l.weights[2][i] = w2 * unit;
    l.depth[i] = l.weights[0][i] * l.cornerZ[0][i] + l.weights[1][i] * l.cornerZ[1][i] +
                 l.weights[2][i] * l.cornerZ[2][i];
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

EmbreeScene::EmbreeScene(std::vector<float> points, std::vector<Corners> triangles, int threads,
                         const plugin::Progress& progress)
    : m_points(std::move(points)), m_triangles(std::move(triangles)) {
  for (const float x : m_points) m_extent = std::max(m_extent, double(std::abs(x)));
  m_points.push_back(0);
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

void EmbreeScene::gather(Lanes& lanes, std::size_t lane) const {
  const Corners& corners = m_triangles[lanes.triangles[lane]];
  for (std::size_t k = 0; k < 3; ++k) {
    const float* p = &m_points[std::size_t{3} * corners[k]];
    lanes.cornerX[k][lane] = p[0];
    lanes.cornerY[k][lane] = p[1];
    lanes.cornerZ[k][lane] = p[2];
  }
}

void EmbreeScene::intersect(std::span<const plugin::Ray> rays, std::span<Hit, packet> hits) const {
  Lanes lanes;
  RTCRayHit16 packets;
  alignas(64) int valid[packet];
  // Rounding of coordinates, with a margin: eight units in the last place.
  constexpr double roundings = 8 * std::numeric_limits<float>::epsilon();
  for (std::size_t i = 0; i < packet; ++i) {
    const plugin::Ray& ray = rays[std::min(i, rays.size() - 1)];
    lanes.x[i] = ray.x;
    lanes.y[i] = ray.y;
    lanes.z[i] = ray.z;
    lanes.a[i] = ray.a;
    lanes.b[i] = ray.b;
    lanes.tolerance[i] =
        roundings * (m_extent + std::abs(ray.x) + std::abs(ray.y) + std::abs(ray.z));
    valid[i] = i < rays.size() ? -1 : 0;
    packets.ray.org_x[i] = float(ray.x);
    packets.ray.org_y[i] = float(ray.y);
    packets.ray.org_z[i] = float(ray.z);
    packets.ray.dir_x[i] = float(-ray.a);
    packets.ray.dir_y[i] = float(-ray.b);
    packets.ray.dir_z[i] = -1;
    packets.ray.tnear[i] = 0;
    packets.ray.tfar[i] = float(ray.reach);
    packets.ray.time[i] = 0;
    packets.ray.mask[i] = UINT32_MAX;
    packets.ray.id[i] = 0;
    packets.ray.flags[i] = 0;
    packets.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packets.hit.primID[i] = Hit::none;
    packets.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  intersect16(static_cast<RTCScene>(m_scene.get()), valid, packets);
  for (std::size_t i = 0; i < packet; ++i) {
    lanes.triangles[i] = packets.hit.primID[i];
    if (lanes.triangles[i] != Hit::none) gather(lanes, i);
  }
  solve(lanes);
  traceAgain(rays, lanes);
  for (std::size_t i = 0; i < rays.size(); ++i)
    hits[i] = {lanes.triangles[i],
               {lanes.weights[0][i], lanes.weights[1][i], lanes.weights[2][i]},
               lanes.depth[i]};
}

/// A packet may hand a ray that passes an edge to the neighbour on its other side, or to what lies
/// behind; a single ray's way depends on the ray alone.
void EmbreeScene::traceAgain(std::span<const plugin::Ray> rays, Lanes& lanes) const {
  bool isChanged = false;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (lanes.triangles[i] == Hit::none || lanes.isNearEdge[i] == 0) continue;
    const plugin::Ray& ray = rays[i];
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
    if (single.hit.primID == lanes.triangles[i]) continue;
    lanes.triangles[i] = single.hit.primID;
    if (lanes.triangles[i] != Hit::none) gather(lanes, i);
    isChanged = true;
  }
  if (isChanged) solve(lanes);
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
