// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/live_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/cameras/state_list_edits.h"
#include "core/content/capture_content.h"
#include "core/content/cut_edges.h"
#include "io/documents/session_file.h"
#include "io/images/other_formats.h"
#include "io/plugins/plugin_library.h"
#include "io/scene/view_source.h"

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

constexpr double panelSide = 0.5;  // the panel's longer one
constexpr double filled = 0.9;

/// The box around content, in the display frame.
struct Box {
  Vec3 least;
  Vec3 most;
};

Box boxAround(const std::vector<float>& points) {
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

/// Gives the panel a shape, with square hogels.
void shapePanel(DisplayParams& display, double width, double height) {
  constexpr int hogels = 256;  // along the longer side
  const double longer = std::max(width, height);
  const auto count = [&](double extent) {
    return std::max(1, int(std::lround(hogels * extent / longer)));
  };
  display.hogels = {count(width), count(height)};
  display.size = {panelSide * display.hogels[0] / hogels, panelSide * display.hogels[1] / hogels};
  display.directions = {100, 100};
  display.fov = {60, 60};
}

/// Returns the largest scale, at most `scale`, at which every point lies within the pyramid from
/// the eye over the panel, or nine tenths of it, where the front of the box stands at the depth
/// `front`. A point that is q behind the front and x beside the middle lies within it where s |x| ≤
/// h (1 − (front − s q) / D), with h nine tenths of half the panel and D the eye's distance.
double scaleWithin(const DisplayParams& display, const std::vector<float>& points, const Box& box,
                   double front, double scale) {
  const Vec3 middle = 0.5 * (box.least + box.most);
  const double distance = length(inFrontOf({display}).camera.eye - display.position);
  const auto limit = [&](double beside, double behind, double panel) {
    const double half = filled * panel / 2;
    const double growth = std::abs(beside) - half * behind / distance;
    if (growth > 0) scale = std::min(scale, half * (1 - front / distance) / growth);
  };
  for (std::size_t k = 0; k + 2 < points.size(); k += 3) {
    const double behind = box.most.z - points[k + 2];
    limit(points[k] - middle.x, behind, display.size[0]);
    limit(points[k + 1] - middle.y, behind, display.size[1]);
  }
  return scale;
}

/// Reads the capture of another session into memory, without the session's twin and states.
void takeCapture(CaptureContent& content, const Progress& progress) {
  const std::string& file = content.file();
  if (file.empty())
    throw InputError("lightField.session.file", "is missing: name the session of a capture");
  Session session = loadSession(file);
  inFile(file, [&] {
    if (session.lightField.isLive())
      throw InputError("lightField.layout",
                       "is \"live\", which is no capture: give its source to this session");
    requireHogels(session.display, "a capture");
    session.twin = {};
    const auto opened = openLightField(session.lightField, session.display);
    const ViewSource source = loadViewSource(session, *opened, progress);
    if (!source.lightField->isInMemory())
      throw InputError("lightField",
                       "is larger than memory: give it more --memory, or a capture "
                       "of fewer hogels or directions");
    std::vector<std::string> files{file};
    for (const auto& each : filesOf(session, *opened)) files.push_back(each.string());
    content.take(source.lightField->overview(), source.display, files);
  });
}

}  // namespace

bool isMeshFile(const std::string& file) {
  return endsInOneOf(meshEndings, file) || endsInOneOf(otherEndings, file);
}

LightFieldParams lightFieldOfMesh(const std::string& file) {
  if (!endsInOneOf(meshEndings, file))
    throw InputError(file, "is a mesh of a kind that is not read",
                     "export it as .glb, .gltf, .obj or .ply");
  if (const std::string advice = adviceOnFormat(file); !advice.empty())
    throw InputError(file, "", advice);
  LightFieldParams params;
  params.layout = Layout::live;
  params.source = "mesh";
  params.content = inFile(file, [&] { return contentParamsOf(params.source); });
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
  if (auto* capture = dynamic_cast<CaptureContent*>(content.get())) takeCapture(*capture, progress);
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

std::vector<std::string> LiveFile::warnings() const {
  const bool isCapture = dynamic_cast<const CaptureContent*>(m_content.get()) != nullptr;
  return isCapture ? m_content->notes() : std::vector<std::string>();
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
  return readStreamed(m_params.source, packIt, progress);
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

void fitMesh(LightFieldParams& params, DisplayParams& display, const Progress& progress) {
  shapePanel(display, 1, 1);
  params.content.set("position", std::vector<double>{0, 0, 0});
  constexpr float measuring = 0x1p-19F;  // near the least scale: large meshes are measured, too
  params.content.set("scale", std::vector<double>{measuring});
  std::vector<float> points = LiveFile(params, display, progress).content().triangles().points;
  for (float& value : points) value /= measuring;
  const Box box = boxAround(points);
  const Vec3 extent = box.most - box.least;
  const double longer = std::max(extent.x, extent.y);
  const Vec3 middle = 0.5 * (box.least + box.most);
  constexpr double mostSlender = 8;  // a line still gets some rows of hogels
  const double largest = filled * panelSide / longer;
  if (!(longer > 0) || largest < 1e-6 || largest > 1e6 || !(largest * length(middle) < 1000))
    throw InputError(contentName(params),
                     "is no mesh that a panel fits: it is too small, too large, or farther from "
                     "its origin than 2000 times its size");
  shapePanel(display, std::max(extent.x, longer / mostSlender),
             std::max(extent.y, longer / mostSlender));
  const double front = std::min(largest * extent.z / 4, panelSide / 10);
  const double fitted = fourDigits(scaleWithin(display, points, box, front, largest));
  params.content.set("scale", std::vector<double>{fitted});
  const auto tenths = [](double place) {
    return std::round(1e4 * place) / 1e4 + 0.0;  // of a millimetre; 0, not −0
  };
  params.content.set("position",
                     std::vector<double>{tenths(-fitted * middle.x), tenths(-fitted * middle.y),
                                         tenths(front - fitted * box.most.z)});
}

}  // namespace hogelscope
