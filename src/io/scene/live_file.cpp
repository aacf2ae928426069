// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/live_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/content/cut_edges.h"
#include "io/plugins/plugin_library.h"

namespace hogelscope {

namespace {

/// Receives the progress of content, from any thread.
class Listener : public plugin::Progress {
 public:
  explicit Listener(const hogelscope::Progress& progress) {
    if (progress) m_progress = forThreads(progress);
  }
  [[nodiscard]] bool go(double done) const override { return !m_progress || m_progress(done); }

 private:
  hogelscope::Progress m_progress;
};

plugin::Panel panelOf(const PanelParams& params) {
  const Display display(params);
  const Vec2 first = display.slopes(0, 0);
  const Vec2 last = display.slopes(params.directions[0], params.directions[1]);
  return {{params.size[0], params.size[1]},
          {params.hogels[0], params.hogels[1]},
          {params.directions[0], params.directions[1]},
          {(last.x - first.x) / params.directions[0], (first.y - last.y) / params.directions[1]}};
}

/// The endings of meshes that the plugin reads, and of other common ones.
constexpr std::array<std::string_view, 4> meshEndings{".glb", ".gltf", ".obj", ".ply"};
constexpr std::array<std::string_view, 14> otherEndings{".stl",  ".fbx",  ".dae", ".3ds",  ".3mf",
                                                        ".off",  ".wrl",  ".x3d", ".usd",  ".usda",
                                                        ".usdc", ".usdz", ".abc", ".blend"};

template <class Endings>
bool endsInOneOf(const Endings& endings, const std::string& file) {
  const std::string ending = lowerCase(std::filesystem::path(file).extension().string());
  return std::ranges::find(endings, ending) != endings.end();
}

}  // namespace

bool isMeshFile(const std::string& file) {
  return endsInOneOf(meshEndings, file) || endsInOneOf(otherEndings, file);
}

LightFieldParams lightFieldOfMesh(const std::string& file) {
  if (!endsInOneOf(meshEndings, file))
    throw InputError(file, "is a mesh of a kind that is not read",
                     "export it as .glb, .gltf, .obj or .ply");
  LightFieldParams params;
  params.layout = Layout::live;
  params.source = "mesh";
  try {
    params.content = contentParamsOf(params.source);
  } catch (const InputError& error) {
    throw error.in(file);
  }
  params.content.set("file", file);
  return params;
}

LiveFile::LiveFile(const LightFieldParams& params, const DisplayParams& display,
                   const Progress& progress)
    : m_params(params), m_display{display, params.viewingDistance} {
  if (!params.content.isGiven())
    throw InputError("lightField.source", "is missing: name what computes the content");
  if (display.hogels[0] <= 0 || display.directions[0] <= 0)
    throw InputError(display.hogels[0] > 0 ? "display.directions" : "display.hogels",
                     "is missing: a scene does not say it");
  auto content = params.content.make();
  content->open(panelOf(m_display), {".", std::int32_t(threadCount())}, Listener(progress));
  m_content = std::move(content);
}

std::vector<std::filesystem::path> LiveFile::files() const {
  const std::vector<std::string> names = m_content->files();
  return {names.begin(), names.end()};
}

std::string LiveFile::cutWarning(const CameraState& state) const {
  return hogelscope::cutWarning(*m_content, m_display, state);
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
