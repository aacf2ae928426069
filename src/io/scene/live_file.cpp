// SPDX-License-Identifier: BSD-3-Clause
// Live scenes as light fields that can be opened.
#include "io/scene/live_file.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/content/scene_content.h"
#include "io/layouts/texel_placement.h"
#include "io/plugins/plugin_library.h"

namespace hogelscope {

namespace {

/// What content hears of a progress, from any thread.
class Listener : public plugin::Progress {
 public:
  explicit Listener(const hogelscope::Progress& progress) {
    if (progress) m_progress = forThreads(progress);
  }
  [[nodiscard]] bool go(double done) const override { return !m_progress || m_progress(done); }

 private:
  hogelscope::Progress m_progress;
};

plugin::Panel panelOf(const DisplayParams& params) {
  const Display display(params);
  const Vec2 first = display.slopes(0, 0);
  const Vec2 last = display.slopes(params.directions[0], params.directions[1]);
  return {{params.size[0], params.size[1]},
          {params.hogels[0], params.hogels[1]},
          {params.directions[0], params.directions[1]},
          {(last.x - first.x) / params.directions[0], (first.y - last.y) / params.directions[1]}};
}

}  // namespace

ContentParams contentOf(const std::string& source) {
  if (source == "scene") return ContentParams([] { return std::make_unique<SceneContent>(); });
  const PluginLibrary library = loadPlugin(source, PluginKind::content);
  return ContentParams([library] { return library.makeContent(); });
}

bool isMeshFile(const std::string& file) {
  const std::string ending = lowerCase(std::filesystem::path(file).extension().string());
  return ending == ".glb" || ending == ".gltf" || ending == ".obj" || ending == ".ply";
}

LightFieldParams lightFieldOfMesh(const std::string& file) {
  LightFieldParams params;
  params.layout = Layout::live;
  params.source = "mesh";
  try {
    params.content = contentOf(params.source);
  } catch (const InputError& error) {
    throw error.in(file);
  }
  params.content.set("file", file);
  return params;
}

namespace {

/// The box around content, in the display frame.
struct Box {
  Vec3 least;
  Vec3 most;
};

Box boxAround(const plugin::ContentSource& content) {
  const std::vector<float> points = content.triangles().points;
  constexpr double far = std::numeric_limits<double>::infinity();
  Box box{{far, far, far}, {-far, -far, -far}};
  for (std::size_t k = 0; k + 2 < points.size(); k += 3) {
    const Vec3 p{points[k], points[k + 1], points[k + 2]};
    box.least = {std::min(box.least.x, p.x), std::min(box.least.y, p.y),
                 std::min(box.least.z, p.z)};
    box.most = {std::max(box.most.x, p.x), std::max(box.most.y, p.y), std::max(box.most.z, p.z)};
  }
  return box;
}

/// A panel of a shape, with square hogels.
void shapePanel(DisplayParams& display, double width, double height) {
  constexpr int hogels = 256;  // along the longer side
  constexpr double side = 0.5;
  const double longer = std::max(width, height);
  const auto count = [&](double extent) {
    return std::max(1, int(std::lround(hogels * extent / longer)));
  };
  display.hogels = {count(width), count(height)};
  display.size = {side * display.hogels[0] / hogels, side * display.hogels[1] / hogels};
  display.directions = {100, 100};
  display.fov = {60, 60};
}

}  // namespace

void fitMesh(LightFieldParams& params, DisplayParams& display, const Progress& progress) {
  shapePanel(display, 1, 1);
  params.content.set("position", std::vector<double>{0, 0, 0});
  constexpr double measuring = 0x1p-19;  // near the least scale: large meshes are measured, too
  params.content.set("scale", std::vector<double>{measuring});
  auto [least, most] = boxAround(LiveFile(params, display, progress).content());
  least = 1 / measuring * least;
  most = 1 / measuring * most;
  const Vec3 extent = most - least;
  const double longer = std::max(extent.x, extent.y);
  const Vec3 middle = 0.5 * (least + most);
  constexpr double filled = 0.9;
  constexpr double mostSlender = 8;  // a line still gets some rows of hogels
  const double scale = filled * 0.5 / longer;
  if (!(longer > 0) || scale < 1e-6 || scale > 1e6 || !(scale * length(middle) < 1000))
    throw InputError(contentName(params),
                     "is no mesh that a panel fits: it is too small, too large, or farther from "
                     "its origin than 2000 times its size");
  shapePanel(display, std::max(extent.x, longer / mostSlender),
             std::max(extent.y, longer / mostSlender));
  const double fitted = fourDigits(scale);
  params.content.set("scale", std::vector<double>{fitted});
  const auto place = [&](double of) {
    return std::round(-1e4 * fitted * of) / 1e4 + 0.0;  // tenths of a millimetre; 0, not −0
  };
  params.content.set("position",
                     std::vector<double>{place(middle.x), place(middle.y), place(middle.z)});
}

LiveFile::LiveFile(const LightFieldParams& params, const DisplayParams& display,
                   const Progress& progress)
    : m_params(params), m_display(display) {
  m_display.viewingDistance = params.viewingDistance;
  if (!params.content.isGiven())
    throw InputError("lightField.source", "is missing: name what computes the content");
  if (display.hogels[0] <= 0 || display.directions[0] <= 0)
    throw InputError(display.hogels[0] > 0 ? "display.directions" : "display.hogels",
                     "is missing: a scene does not say it");
  auto content = params.content.make();
  content->open(panelOf(display), {".", std::int32_t(threadCount())}, Listener(progress));
  m_content = std::move(content);
}

std::vector<std::filesystem::path> LiveFile::files() const {
  const std::vector<std::string> names = m_content->files();
  return {names.begin(), names.end()};
}

StoredType LiveFile::type() const {
  return m_params.type == LiveType::real ? StoredType::real : StoredType::uint8;
}

std::shared_ptr<const LightFieldSource> LiveFile::source(const SourceUse& use,
                                                         const Progress& /*progress*/) {
  return std::make_shared<const LiveSource>(
      m_content, m_display, m_params.live, type(), use.memory,
      use.threads == 1 ? ParallelRows(serialRows) : ParallelRows(parallelRows));
}

LightField LiveFile::read(const Progress& progress) {
  LightField lightField = blankLightField(size(), type(), m_params.source, packIt);
  const auto [nx, ny, du, dv] = size();
  stream(
      [&, nx = nx, du = du](int j, int v, const StoredRows& row) {
        std::visit(
            [&](const auto* rgb) {
              for (int i = 0; i < nx; ++i)
                for (int u = 0; u < du; ++u, rgb += 3) lightField.set({i, j, u, v}, rgb);
            },
            row);
      },
      progress);
  return lightField;
}

void LiveFile::stream(const HogelRow& row, const Progress& progress) {
  const LiveSource source(m_content, m_display, m_params.live, type(),
                          std::numeric_limits<std::size_t>::max());
  const auto [nx, ny, du, dv] = size();
  const double bytesOfRow = double(size().width()) * double(memoryBytes(type()) + 1);
  const int most = int(std::clamp(double(allowedMemory()) / 2 / bytesOfRow, 1.0, double(dv)));
  for (int j = 0; j < ny; ++j)
    for (int v0 = 0; v0 < dv; v0 += most) {
      const int v1 = std::min(v0 + most, dv);
      const double done = (j + double(v0) / dv) / ny;
      const auto texels = source.slice(readsOfRows(size(), {j, j}, {0, du - 1}, {v0, v1 - 1}),
                                       part(progress, done, (j + double(v1) / dv) / ny));
      for (int v = v0; v < v1; ++v) handOutRow(*texels, j, v, row, j);
    }
}

}  // namespace hogelscope
