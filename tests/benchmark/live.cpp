// SPDX-License-Identifier: BSD-3-Clause
// How fast live light fields are, against the bare call of Embree with the same rays in the same
// run, and against VTK's locators. Times are of the process, all threads, so that other work on the
// machine counts little; each figure is the median of the ratios of neighbouring runs.
#include <benchmark/benchmark.h>
#include <vtkCellArray.h>
#include <vtkCellLocator.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "core/content/live_source.h"
#include "core/engine/fast_simulation.h"
#include "embree.h"
#include "mesh_source.h"

using namespace hogelscope;

namespace {

/// Seconds of all threads of this process.
double processSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

struct Mesh {
  std::vector<float> points;
  std::vector<std::uint32_t> corners;
};

/// Adds a grid of across × across squares, each point where `at(u, v)` says, 0 … 1.
template <class At>
void addGrid(Mesh& mesh, int across, At at) {
  const auto first = std::uint32_t(mesh.points.size() / 3);
  for (int y = 0; y <= across; ++y)
    for (int x = 0; x <= across; ++x) {
      const Vec3 p = at(double(x) / across, double(y) / across);
      mesh.points.insert(mesh.points.end(), {float(p.x), float(p.y), float(p.z)});
    }
  const auto row = std::uint32_t(across + 1);
  for (std::uint32_t y = 0; y < std::uint32_t(across); ++y)
    for (std::uint32_t x = 0; x < std::uint32_t(across); ++x) {
      const std::uint32_t a = first + y * row + x;
      mesh.corners.insert(mesh.corners.end(), {a, a + 1, a + row, a + 1, a + row + 1, a + row});
    }
}

/// A rough wall of 1.25 million triangles behind the panel, and balls before and behind it.
Mesh makeMesh() {
  Mesh mesh;
  addGrid(mesh, 790, [](double u, double v) {
    return Vec3{1.4 * (u - 0.5), 1.4 * (v - 0.5),
                -0.25 + 0.02 * std::sin(60 * u) * std::cos(45 * v) + 0.004 * std::sin(700 * u * v)};
  });
  for (const Vec3& c : {Vec3{-0.15, 0.05, 0.08}, {0.1, 0.12, -0.08}, {0.13, -0.1, 0.03}})
    addGrid(mesh, 200, [&](double u, double v) {
      const double a = 2 * std::numbers::pi * u, b = std::numbers::pi * v;
      return c + 0.06 * Vec3{std::cos(a) * std::sin(b), std::cos(b), std::sin(a) * std::sin(b)};
    });
  return mesh;
}

void writePly(const Mesh& mesh, const std::string& file) {
  std::ofstream out(file, std::ios::binary);
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << mesh.points.size() / 3
      << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
      << mesh.corners.size() / 3 << "\nproperty list uchar uint vertex_indices\nend_header\n";
  out.write(reinterpret_cast<const char*>(mesh.points.data()),
            std::streamsize(4 * mesh.points.size()));
  for (std::size_t k = 0; k < mesh.corners.size(); k += 3) {
    out.put(3);
    out.write(reinterpret_cast<const char*>(&mesh.corners[k]), 12);
  }
}

class Silent : public plugin::Progress {
 public:
  [[nodiscard]] bool go(double) const override { return true; }
};

/// Sets parameters by their names.
class Setter : public ParameterVisitor {
 public:
  explicit Setter(std::string file) : m_file(std::move(file)) {}
  void group(std::string_view, std::string_view) override {}

 protected:
  void numbers(const Field&, std::span<double>, bool) override {}
  void integers(const Field&, std::span<int>, bool) override {}
  void flag(const Field&, bool&) override {}
  void text(const Field& field, std::string& value) override {
    if (field.name == "file") value = m_file;
  }
  void choice(const Field&, int& index) override { index = 0; }  // unlit

 private:
  std::string m_file;
};

/// Hands on, and keeps the rays.
class Recorder : public plugin::ContentSource {
 public:
  explicit Recorder(const plugin::ContentSource& content) : m_content(content) {}
  void describe(ParameterVisitor& v) override { v.group("recorder", ""); }
  void open(const plugin::Panel&, const plugin::Place&, const plugin::Progress&) override {}
  void depths(double& back, double& front) const override { m_content.depths(back, front); }
  void trace(std::span<const plugin::Ray> list, std::span<plugin::Colour> colours) const override {
    rays.insert(rays.end(), list.begin(), list.end());
    m_content.trace(list, colours);
  }
  mutable std::vector<plugin::Ray> rays;

 private:
  const plugin::ContentSource& m_content;
};

/// The mesh, the plugin's scene and a bare one of Embree, made once.
struct Scene {
  Mesh mesh = makeMesh();
  PanelParams display;
  std::shared_ptr<mesh::MeshSource> content = std::make_shared<mesh::MeshSource>();
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene bare = rtcNewScene(device);

  Scene() {
    display.hogels = {512, 512};
    display.directions = {600, 600};
    const std::string file =
        (std::filesystem::temp_directory_path() / "hogelscope_benchmark.ply").string();
    writePly(mesh, file);
    Setter setter(file);
    content->describe(setter);
    const double step = 2 * std::tan(std::numbers::pi / 6) / 600;
    content->open({{0.5, 0.5}, {512, 512}, {600, 600}, {step, step}},
                  {"", threadCount(), std::uint64_t{1} << 30}, Silent());
    std::filesystem::remove(file);
    rtcSetSceneFlags(bare, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* points = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                           12, mesh.points.size() / 3);
    std::memcpy(points, mesh.points.data(), 4 * mesh.points.size());
    void* corners = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            12, mesh.corners.size() / 3);
    std::memcpy(corners, mesh.corners.data(), 4 * mesh.corners.size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(bare, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(bare);
  }
};

Scene& scene() {
  static Scene one;
  return one;
}

/// Rays as Embree has them, 16 by 16.
std::vector<RTCRayHit16> packetsOf(const std::vector<plugin::Ray>& rays) {
  std::vector<RTCRayHit16> packets(rays.size() / 16);
  for (std::size_t k = 0; k < 16 * packets.size(); ++k) {
    const auto& [x, y, z, a, b, reach] = rays[k];
    auto& [ray, hit] = packets[k / 16];
    const std::size_t lane = k % 16;
    ray.org_x[lane] = float(x), ray.org_y[lane] = float(y), ray.org_z[lane] = float(z);
    ray.dir_x[lane] = float(-a), ray.dir_y[lane] = float(-b), ray.dir_z[lane] = -1;
    ray.tnear[lane] = 0, ray.tfar[lane] = float(reach);
    ray.mask[lane] = 0xffffffffU;
  }
  return packets;
}

void traceBare(const std::vector<RTCRayHit16>& packets) {
  alignas(64) static constexpr std::array<int, 16> valid{-1, -1, -1, -1, -1, -1, -1, -1,
                                                         -1, -1, -1, -1, -1, -1, -1, -1};
  const int pieces = int(packets.size() / 64);
  parallelRows(pieces, [&](int begin, int end) {
    for (std::size_t k = 64 * std::size_t(begin); k < 64 * std::size_t(end); ++k) {
      RTCRayHit16 packet = packets[k];
      for (std::size_t lane = 0; lane < 16; ++lane)
        packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
      mesh::QueryContext context;
      mesh::intersect16(scene().bare, valid.data(), context, packet);
      benchmark::DoNotOptimize(packet.hit.primID[3]);
    }
  });
}

/// Runs both in turn; the counter is the median of work / bare.
template <class Work>
void compareWithBare(benchmark::State& state, const std::vector<plugin::Ray>& rays, Work work) {
  const std::vector<RTCRayHit16> packets = packetsOf(rays);
  traceBare(packets);
  work();
  std::vector<double> ratios, seconds;
  for (auto _ : state) {
    const double start = processSeconds();
    traceBare(packets);
    const double middle = processSeconds();
    work();
    const double end = processSeconds();
    ratios.push_back((end - middle) / (middle - start));
    seconds.push_back(end - middle);
  }
  std::ranges::sort(ratios);
  std::ranges::sort(seconds);
  state.counters["ratio"] = ratios[ratios.size() / 2];
  state.counters["rays"] = double(rays.size());
  state.counters["rays/cpu_s"] = double(rays.size()) / seconds[seconds.size() / 2];
}

RenderJob viewOf(std::shared_ptr<const plugin::ContentSource> content, int psf, bool isTurned) {
  RenderJob job;
  job.display = scene().display;
  job.lightField = std::make_shared<const LiveSource>(std::move(content), job.display, LiveParams{},
                                                      StoredType::uint8, std::size_t{1} << 32);
  job.state.camera.eye = {0.01, 0.02, 0.559};
  job.state.camera.lookat = {0.01, 0.02, 0};
  job.state.camera.fov = 48.2;
  job.state.psf.windowSize = psf;
  if (isTurned) {
    job.state.camera.up = {0.17, 1, 0};
    job.state.distortion = {0.6, 0.3, 0.2, 0.01, 0.2};
  }
  return job;
}

void render(const RenderJob& job, LensTables& tables) {
  const FastSimulation simulation(job, tables, parallelRows);
  Image image(600, 600);
  parallelRows(600, [&](int begin, int end) {
    const std::size_t first = 600 * std::size_t(begin);
    simulation.rows(begin, end, 0, 600, &image.rgb[3 * first], &image.seen[first]);
  });
  benchmark::DoNotOptimize(image.rgb.data());
}

std::vector<plugin::Ray> raysOf(const std::function<void(const LiveSource&)>& use) {
  const auto recorder = std::make_shared<Recorder>(*scene().content);
  use(LiveSource(recorder, scene().display, {}, StoredType::uint8, std::size_t{1} << 32,
                 serialRows));
  return recorder->rays;
}

void view(benchmark::State& state, int psf, bool isTurned) {
  LensTables tables;
  const auto recorder = std::make_shared<Recorder>(*scene().content);
  RenderJob recorded = viewOf(recorder, psf, isTurned);
  recorded.lightField =
      std::make_shared<const LiveSource>(recorder, recorded.display, LiveParams{},
                                         StoredType::uint8, std::size_t{1} << 32, serialRows);
  render(recorded, tables);
  const RenderJob job = viewOf(scene().content, psf, isTurned);
  compareWithBare(state, recorder->rays, [&] { render(job, tables); });
}

/// The plugin alone, with the rays of a view in the order of the host.
void pluginAlone(benchmark::State& state, int psf) {
  const auto recorder = std::make_shared<Recorder>(*scene().content);
  RenderJob job = viewOf(recorder, psf, false);
  job.lightField = std::make_shared<const LiveSource>(
      recorder, job.display, LiveParams{}, StoredType::uint8, std::size_t{1} << 32, serialRows);
  LensTables tables;
  render(job, tables);
  const std::vector<plugin::Ray>& rays = recorder->rays;
  compareWithBare(state, rays, [&] {
    constexpr std::size_t list = 1024;
    parallelRows(int(rays.size() / list), [&](int begin, int end) {
      std::vector<plugin::Colour> colours(list);
      for (std::size_t k = std::size_t(begin); k < std::size_t(end); ++k)
        scene().content->trace(std::span(rays).subspan(k * list, list), colours);
    });
  });
}

/// A row of hogels.
void exportRow(benchmark::State& state) {
  const LightFieldSize size{512, 512, 600, 600};
  const ViewReads row = readsOfRows(size, {200, 200}, {0, 599}, {0, 39});
  const std::vector<plugin::Ray> rays =
      raysOf([&](const LiveSource& source) { (void)source.slice(row, {}); });
  const LiveSource source(scene().content, scene().display, {}, StoredType::uint8,
                          std::size_t{1} << 32);
  compareWithBare(state, rays, [&] { benchmark::DoNotOptimize(source.slice(row, {})->size()); });
}

/// Rays a second of a core by a locator of VTK, and how much faster the live view is.
template <class Locator>
void locator(benchmark::State& state) {
  vtkNew<vtkPoints> points;
  const Mesh& mesh = scene().mesh;
  for (std::size_t k = 0; k < mesh.points.size(); k += 3) points->InsertNextPoint(&mesh.points[k]);
  vtkNew<vtkCellArray> cells;
  for (std::size_t k = 0; k < mesh.corners.size(); k += 3)
    cells->InsertNextCell({vtkIdType(mesh.corners[k]), vtkIdType(mesh.corners[k + 1]),
                           vtkIdType(mesh.corners[k + 2])});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  vtkNew<Locator> locator;
  locator->SetDataSet(data);
  locator->BuildLocator();
  const RenderJob job = viewOf(scene().content, 1, false);
  const std::vector<plugin::Ray> rays = raysOf([&](const LiveSource& source) {
    LensTables tables;
    RenderJob own = job;
    own.lightField = {std::shared_ptr<void>(), &source};
    render(own, tables);
  });
  LensTables tables;
  render(job, tables);
  const double start = processSeconds();
  render(job, tables);
  const double live = (processSeconds() - start) / double(rays.size());
  std::size_t next = 0;
  constexpr std::size_t atATime = 500;
  double spent = 0;
  for (auto _ : state) {
    const double from = processSeconds();
    for (std::size_t k = 0; k < atATime; ++k) {
      const auto& [x, y, z, a, b, reach] = rays[next = (next + 997) % rays.size()];
      std::array<double, 3> begin{x, y, z}, end{x - a * reach, y - b * reach, z - reach}, at{},
          pc{};
      double t = 0;
      int sub = 0;
      benchmark::DoNotOptimize(
          locator->IntersectWithLine(begin.data(), end.data(), 0, t, at.data(), pc.data(), sub));
    }
    spent += processSeconds() - from;
  }
  const double each = spent / double(atATime * std::size_t(state.iterations()));
  state.counters["rays/cpu_s"] = 1 / each;
  state.counters["live is faster by"] = each / live;
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  const auto add = [](const char* name, auto function, int iterations, auto... arguments) {
    benchmark::RegisterBenchmark(name, function, arguments...)
        ->Iterations(iterations)
        ->Unit(benchmark::kMillisecond);
  };
  add("live/nearest", view, 15, 1, false);
  add("live/leakage 5x5", view, 5, 5, false);
  add("live/nearest, lens and roll", view, 9, 1, true);
  add("live/leakage 5x5, lens and roll", view, 5, 5, true);
  add("plugin/nearest", pluginAlone, 15, 1);
  add("plugin/leakage 5x5", pluginAlone, 5, 5);
  add("live/export", exportRow, 5);
  add("locator/vtkCellLocator", locator<vtkCellLocator>, 3);
  add("locator/vtkStaticCellLocator", locator<vtkStaticCellLocator>, 3);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
