// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/live_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <limits>
#include <mutex>
#include <string_view>
#include <tuple>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/cameras/state_list_edits.h"
#include "core/content/capture_content.h"
#include "core/content/cut_edges.h"
#include "io/documents/session_file.h"
#include "io/images/other_formats.h"
#include "io/plugins/plugin_library.h"
#include "io/scene/view_source.h"
#include "io/store/light_field_store.h"

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

/// Returns the points of a mesh, of one that moves at some times of its animation, which is set.
std::vector<float> movingPoints(LightFieldParams& params, const DisplayParams& display,
                                const Progress& progress) {
  const std::string animation = "animation";
  params.content.set(animation, std::string("0"));
  std::unique_ptr<LiveFile> file;
  try {
    file = std::make_unique<LiveFile>(params, display, progress);
  } catch (const InputError&) {  // as a rule it has none
    params.content.set(animation, std::string());
    file = std::make_unique<LiveFile>(params, display, progress);
  }
  std::vector<float> points;
  constexpr int times = 16;
  const int last = file->frames().last;
  for (int k = 0; k <= std::min(times, last); ++k) {
    if (k > 0) file->select(int(std::int64_t(last) * k / std::min(times, last)));
    const std::vector<float> moved = file->content().triangles().points;
    points.insert(points.end(), moved.begin(), moved.end());
  }
  return points;
}

struct Capture {
  std::shared_ptr<const LightFieldSource> lightField;
  PanelParams display;  ///< with its hogels and directions
  std::vector<std::string> files;
};

using Stamp = std::tuple<std::string, std::filesystem::file_time_type, std::uintmax_t>;

std::vector<Stamp> stampsOf(const std::vector<std::filesystem::path>& files) {
  std::vector<Stamp> stamps;
  for (const auto& file : files) {
    std::error_code none;
    stamps.emplace_back(file.string(), std::filesystem::last_write_time(file, none),
                        std::filesystem::file_size(file, none));
  }
  return stamps;
}

/// The capture that was opened last: a focus that is dragged opens it for each picture.
struct Latest {
  std::mutex mutex;
  Session session;
  std::vector<Stamp> stamps;
  std::weak_ptr<const LightFieldSource> lightField;
  PanelParams display;
};

Capture openCapture(const Session& session, const std::string& sessionFile,
                    const Progress& progress) {
  static Latest latest;
  const auto opened = openLightField(session.lightField, session.display);
  Capture capture;
  const std::vector<std::filesystem::path> files = filesOf(session, *opened);
  capture.files.push_back(sessionFile);
  for (const auto& file : files) capture.files.push_back(file.string());
  const std::vector<Stamp> stamps = stampsOf(files);
  {
    const std::lock_guard lock(latest.mutex);
    capture.lightField = latest.lightField.lock();
    capture.display = latest.display;
    if (capture.lightField && session == latest.session && stamps == latest.stamps) return capture;
  }
  capture.display = resolved(displayOf(session), opened->size());
  if (session.lightField.layout == Layout::pack)
    capture.lightField = std::make_shared<const LightFieldStore>(
        session.lightField.file, session.lightField.incoming,
        std::min(allowedMemory() / 2, SourceUse().cache), 1);
  else
    capture.lightField = opened->source({}, progress);
  const std::lock_guard lock(latest.mutex);
  latest.session = session;
  latest.stamps = stamps;
  latest.lightField = capture.lightField;
  latest.display = capture.display;
  return capture;
}

/// Opens the capture of a session, without the session's twin and states. One that is in use, and
/// whose files are as they were, is not read again. A store is read slice by slice, also where all
/// of it had room: most views need a small part of it.
Capture openCapture(const std::string& sessionFile, const Progress& progress) {
  if (sessionFile.empty())
    throw InputError("lightField.session.file", "is missing: name the session of a capture");
  Session session = loadSession(sessionFile);
  return inFile(sessionFile, [&] {
    if (session.lightField.isLive())
      throw InputError("lightField.layout",
                       "is \"live\", which is no capture: give its source to this session");
    requireHogels(session.display, "a capture");
    session.twin = {};
    return openCapture(session, sessionFile, progress);
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
  m_content = opened(progress);
  m_contents.push_back(m_content);
  const double seconds = m_content->duration();
  if (seconds <= 0) return;
  constexpr double rounding = 1e-6;  // as in FrameNumbers::shownAt()
  const double rate = frameRateOf(params, *this);
  const double last = std::floor(seconds * rate + rounding);
  constexpr double most = 1e6;
  if (last >= most)
    throw InputError("lightField.fps", numberText(rate) + " makes more than 1000000 frames of " +
                                           numberText(seconds) + " seconds");
  m_frameCount = std::size_t(last) + 1;
  m_frames = listedFrames(params, {0, int(last), 1});
  select(m_frames.first);
}

std::shared_ptr<plugin::ContentSource> LiveFile::opened(const Progress& progress) const {
  std::shared_ptr<plugin::ContentSource> content = m_params.content.make();
  if (auto* ofSession = dynamic_cast<CaptureContent*>(content.get())) {
    Capture capture = openCapture(ofSession->file(), progress);
    ofSession->take(std::move(capture.lightField), capture.display, std::move(capture.files));
  }
  content->open(panelOf(m_display), {".", std::int32_t(threadCount())}, Listener(progress));
  return content;
}

double LiveFile::frameRate() const {
  constexpr double usual = 30;  // where the session says none
  return m_content->duration() > 0 ? usual : 0;
}

void LiveFile::select(int frame) {
  if (m_frameCount == 1) return;
  const auto isFree = [this](const std::shared_ptr<plugin::ContentSource>& content) {
    return content.use_count() == (content == m_content ? 2 : 1);
  };
  const auto free = std::ranges::find_if(m_contents, isFree);
  const bool isThere = free != m_contents.end();
  // What the thread that used it last has read is read.
  std::atomic_thread_fence(std::memory_order_acquire);
  std::shared_ptr<plugin::ContentSource> content = isThere ? *free : opened({});
  content->setTime(frame / frameRateOf(m_params, *this));
  if (!isThere) m_contents.push_back(content);
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
  const auto* capture = dynamic_cast<const CaptureContent*>(m_content.get());
  const bool isReal = m_params.type == LiveType::capture && capture != nullptr
                          ? capture->type() != StoredType::uint8
                          : m_params.type == LiveType::real;
  return isReal ? StoredType::real : StoredType::uint8;
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
  const double most = std::max(1.0, double(allowedMemory()) / 2 / bytesOfRow);
  // A thread traces 16 rows of hogels at once; where there is no room for one, a part of it is.
  const int hogelRows = int(std::clamp(most / dv, 1.0, 32.0 * threadCount()));
  const int directions = int(std::min(most, double(dv)));
  for (int j0 = 0; j0 < ny; j0 += hogelRows)
    for (int v0 = 0; v0 < dv; v0 += directions) {
      const int j1 = std::min(j0 + hogelRows, ny), v1 = std::min(v0 + directions, dv);
      const auto fraction = [&, ny = ny, dv = dv](int v) {
        return (j0 + double(v) / dv * (j1 - j0)) / ny;
      };
      const auto texels = source.slice(readsOfRows(size(), {j0, j1 - 1}, {0, du - 1}, {v0, v1 - 1}),
                                       part(progress, fraction(v0), fraction(v1)));
      for (int j = j0; j < j1; ++j)
        for (int v = v0; v < v1; ++v) handOutRow(*texels, j, v, row, j);
    }
}

void fitMesh(LightFieldParams& params, DisplayParams& display, const Progress& progress) {
  shapePanel(display, 1, 1);
  params.content.set("position", std::vector<double>{0, 0, 0});
  constexpr float measuring = 0x1p-19F;  // near the least scale: large meshes are measured, too
  params.content.set("scale", std::vector<double>{measuring});
  std::vector<float> points = movingPoints(params, display, progress);
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
