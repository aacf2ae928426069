// SPDX-License-Identifier: BSD-3-Clause
// --render: one image for each camera state.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <iterator>
#include <span>
#include <utility>

#include "cli/explain.h"
#include "cli/inputs.h"
#include "cli/jobs.h"
#include "cli/terminal.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/cameras/camera_path.h"
#include "core/cameras/focus_stack.h"
#include "core/optics/eyes.h"
#include "core/optics/stereo_image.h"
#include "io/documents/session_file.h"
#include "io/files/atomic_file.h"
#include "io/files/folders.h"
#include "io/files/system_limits.h"
#include "io/images/image_writer.h"
#include "io/images/video_writer.h"
#include "runs/frame_reader.h"
#include "runs/state_images.h"
#include "study/undistortion.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

bool isDistorted(const CameraState& state) {
  return !Distortion(state.distortion).isIdentity();
}

/// A file of the results, and the camera states that it shows: both eyes of a stereo picture,
/// otherwise one.
struct Picture {
  std::string name;  ///< the file's, without an ending
  std::vector<CameraState> eyes;
  double focus = 0;          ///< metres, of a focus stack
  int frame = 0;             ///< of the light field
  std::string ofFrame = {};  ///< the frame in names, such as ".frame0010"; "" without --frames
  /// Whether it is the picture before it without the lens, and has two more files: --undistort.
  bool isUndistorted = false;
};

/// The files of all states and the text of --explain.
struct RenderOutput {
  std::string session;
  fs::path folder;
  std::string format;
  bool hasMasks = false;
  bool isExplained = false;
  bool isIdeal = false;
  std::optional<StereoMode> stereo = {};
  std::optional<VideoWriter> video = {};
  bool isUndistorting = false;

  [[nodiscard]] fs::path file(const std::string& name, const std::string& ending) const {
    return folder / (name + "." + ending);
  }
  [[nodiscard]] std::string maskName(const Picture& picture, std::size_t eye) const {
    return picture.eyes.size() == 1 ? picture.name
                                    : fileNameOf(picture.eyes[eye].camera.name) + picture.ofFrame;
  }
  [[nodiscard]] std::vector<fs::path> allFiles(const std::vector<Picture>& pictures) const {
    std::vector<fs::path> files;
    for (const Picture& picture : pictures) {
      files.push_back(file(picture.name, format));
      for (std::size_t eye = 0; hasMasks && eye < picture.eyes.size(); ++eye)
        files.push_back(file(maskName(picture, eye), "mask.png"));
      if (!picture.isUndistorted) continue;
      files.push_back(openCvsFile(picture));
      files.push_back(differenceFile(picture));
    }
    return files;
  }
  [[nodiscard]] fs::path openCvsFile(const Picture& undistorted) const {
    return file(undistorted.name + "-opencv", format);
  }
  [[nodiscard]] fs::path differenceFile(const Picture& undistorted) const {
    return folder / fs::path(undistorted.name).replace_extension("undistortion." + format);
  }

  /// Writes OpenCV's straightened picture and its difference; returns a line about it.
  [[nodiscard]] std::string writeUndistortion(const Image& distorted, const CameraState& state,
                                              const Picture& picture, const Image& image) const {
    const Undistortion result = compareUndistortion(distorted, image, state);
    const auto& [openCvs, difference, psnr, points] = result;
    writeImage(openCvsFile(picture), openCvs.width, openCvs.height, openCvs.rgb);
    writeImage(differenceFile(picture), openCvs.width, openCvs.height, difference.image.rgb);
    const double share = double(points) / double(openCvs.pixelCount());
    return printable(state.camera.name) + ": OpenCV's picture without the lens: PSNR " +
           rounded(psnr, 2) + (std::isfinite(psnr) ? " dB" : "") + " over " +
           rounded(100 * share, 1) + " % of the pixels, difference × " +
           std::to_string(difference.gain) + "\n";
  }

  /// Writes the images of a picture's eyes, each an Image or a FloatImage; returns what was
  /// written.
  template <class AnyImage>
  AnyImage write(const Picture& picture, const std::vector<AnyImage>& images) const {
    AnyImage image =
        images.size() == 1 ? images[0] : stereoImage(images[0], images[1], stereo.value());
    writeImage(file(picture.name, format), image.width, image.height, image.rgb);
    for (std::size_t eye = 0; hasMasks && eye < images.size(); ++eye)
      writeMask(file(maskName(picture, eye), "mask.png"), images[eye].width, images[eye].height,
                images[eye].seen);
    return image;
  }
};

/// Returns the pictures of a state: for each distance of focus, one of both eyes or one of each.
std::vector<Picture> picturesOf(const CameraState& head, const DisplayParams& display,
                                const std::vector<double>& distances, bool areJoined) {
  std::vector<std::vector<CameraState>> stacks;  // of the eyes
  for (const CameraState& eye : eyesOf(head, display))
    stacks.push_back(distances.empty() ? std::vector{eye} : focusStack(eye, distances));
  std::vector<Picture> pictures;
  for (std::size_t k = 0; k < stacks.front().size(); ++k) {
    const double focus = stacks.front()[k].pupil.focus;
    if (areJoined && stacks.size() == 2) {
      const std::string name =
          distances.empty() ? head.camera.name : focusStack(head, distances)[k].camera.name;
      pictures.push_back({name, {stacks[0][k], stacks[1][k]}, focus});
      continue;
    }
    for (const std::vector<CameraState>& stack : stacks)
      pictures.push_back({fileNameOf(stack[k].camera.name), {stack[k]}, focus});
  }
  return pictures;
}

/// Everything that --render writes.
struct Pictures {
  std::vector<Picture> all;
  std::vector<std::pair<std::string, std::string>> tables;  ///< files of focus stacks, and texts
  std::size_t undistorted = 0;                              ///< pictures without their lens

  /// `digits` returns a frame's number in names of files; none without --frames.
  Pictures(const Session& session, const std::vector<FrameState>& states,
           const std::function<std::string(int frame)>& digits, const PanelParams& display,
           int stackCount, const RenderOutput& output) {
    for (const auto& [state, frame] : states) {
      const std::string ofFrame = digits ? ".frame" + digits(frame) : "";
      std::vector<double> distances;
      if (stackCount > 0)
        inFile(output.session + ": " + state.camera.name,
               [&] { distances = focusDistances(state, display, stackCount); });
      std::vector<Picture> own =
          picturesOf(state, session.display, distances, output.stereo.has_value());
      for (Picture& picture : own) {
        picture.frame = frame;
        picture.ofFrame = ofFrame;
        picture.name += ofFrame;
      }
      if (stackCount > 0)
        tables.emplace_back(state.camera.name + ofFrame + ".focus.csv", tableOf(own, output));
      for (Picture& picture : own) {
        all.push_back(picture);
        if (!output.isUndistorting || !isDistorted(picture.eyes[0])) continue;
        picture.name += ".undistorted";
        picture.eyes[0].distortion = {};
        picture.isUndistorted = true;
        all.push_back(picture);
        ++undistorted;
      }
    }
  }

 private:
  static std::string tableOf(const std::vector<Picture>& pictures, const RenderOutput& output) {
    Table table{{"file", "focus", "dioptres"}};
    for (const Picture& picture : pictures)
      table.push_back({output.file(picture.name, output.format).filename().string(),
                       numberText(picture.focus), numberText(1 / picture.focus)});
    return csvText(table);
  }
};

/// Writes pictures one after the other; for PNG without a video, it goes on after one that cannot
/// be rendered.
class PictureWriter {
 public:
  explicit PictureWriter(RenderOutput& output) : m_output(output) {}

  /// Renders a picture; `first` is the number of its first eye among the states of `images`.
  void write(const Picture& picture, const StateImages& images, std::size_t first,
             const Progress& progress) {
    const std::size_t end = first + picture.eyes.size();
    if (m_output.format != "png") {
      std::vector<FloatImage> eyes;
      for (std::size_t k = first; k < end; ++k)
        eyes.push_back(images.renderFloat(k, m_renderer, progress));
      m_output.write(picture, eyes);
      return;
    }
    std::vector<Image> eyes;
    try {
      for (std::size_t k = first; k < end; ++k)
        eyes.push_back(images.render(k, m_renderer, progress));
    } catch (const InputError& error) {
      if (m_output.video) throw InputError(picture.name, error.what());
      if (!m_failed) m_failed.emplace(picture.name, error.what());
      m_before.reset();
      return;
    }
    Image image = m_output.write(picture, eyes);
    if (picture.isUndistorted && m_before)
      m_lines += m_output.writeUndistortion(*m_before, images.job(first - 1).state, picture, image);
    if (m_output.video) m_output.video->add(image.rgb, progress);
    if (m_output.isUndistorting) m_before = std::move(image);
  }

  /// Returns lines about the pictures. Throws the first picture's error.
  std::string finish(const Progress& progress) {
    if (m_output.video) m_output.video->finish(progress);
    if (m_failed) throw InputError(*m_failed);
    return m_lines;
  }

 private:
  RenderOutput& m_output;
  Renderer m_renderer;
  std::optional<InputError> m_failed;
  std::optional<Image> m_before;  ///< the picture before, for --undistort
  std::string m_lines;
};

/// Returns the pictures of the same frame as the first one, as many as follow each other.
std::span<const Picture> ofOneFrame(std::span<const Picture> pictures) {
  std::size_t count = 0;
  while (count < pictures.size() && pictures[count].frame == pictures[0].frame) ++count;
  return pictures.first(count);
}

std::vector<CameraState> eyesOf(std::span<const Picture> pictures) {
  std::vector<CameraState> eyes;
  for (const Picture& picture : pictures) std::ranges::copy(picture.eyes, std::back_inserter(eyes));
  return eyes;
}

/// Writes all pictures, frame by frame. Returns lines about them.
std::string renderAll(const ViewSource& source, LightFieldFile& file, Session session,
                      std::span<const Picture> pictures, RenderOutput& output,
                      const Progress& progress) {
  const bool isStreamed = mustStream(file, allowedMemory());
  if (isStreamed && output.format != "png")
    throw InputError("--format " + output.format,
                     "needs the light field in memory or in a store: give it more --memory, or "
                     "--pack it first");
  std::vector<int> frames;
  for (const Picture& picture : pictures)
    if (frames.empty() || frames.back() != picture.frame) frames.push_back(picture.frame);
  const SourceUse use{.threads = threadCount()};
  const double reading = isStreamed ? 1 : 0.5;
  FrameReader reader(file, frames, use);
  PictureWriter writer(output);
  const auto imagesOfFrame = [&](int frame, const Progress& own) {
    ViewSource ofFrame = source;
    if (isStreamed) {
      file.select(frame);
      return StateImages(ofFrame, file, session.cameras, {.use = use}, own);
    }
    ofFrame.lightField = reader.next(own);
    return StateImages(ofFrame, session.cameras);
  };
  for (std::size_t begin = 0; begin < pictures.size();) {
    const std::span<const Picture> own = ofOneFrame(pictures.subspan(begin));
    const double each = 1 / double(pictures.size());
    const Progress ofFrame =
        part(progress, double(begin) * each, double(begin + own.size()) * each);
    session.cameras = eyesOf(own);
    StateImages images = imagesOfFrame(own[0].frame, part(ofFrame, 0, reading));
    if (output.isIdeal) images.showIdeal();
    if (output.isExplained && begin == 0)
      std::cout << explanations(images.source(), session, part(ofFrame, reading, reading));
    std::size_t state = 0;
    for (const Picture& picture : own) {
      const std::size_t first = std::exchange(state, state + picture.eyes.size());
      const double ofEye = (1 - reading) / double(session.cameras.size());
      writer.write(picture, images, first,
                   part(ofFrame, reading + double(first) * ofEye, reading + double(state) * ofEye));
    }
    begin += own.size();
  }
  return writer.finish(progress);
}

/// Returns the mode of --stereo, if it is given and a state has two eyes.
std::optional<StereoMode> stereoModeOf(const CommandLine& line, const Session& session) {
  if (!line.has("stereo")) return std::nullopt;
  const std::string text = line.text("stereo");
  if (std::ranges::none_of(session.cameras, hasTwoEyes))
    throw InputError("--stereo " + text,
                     "needs two eyes, but no state has them: --set stereo.ipd=0.063");
  const auto names = stereoModeNames();
  return static_cast<StereoMode>(std::ranges::find(names, text) - names.begin());
}

/// Gives the pictures of a path their times, if the light field has several frames.
void setTimes(std::vector<CameraState>& path, const LightFieldParams& params,
              const LightFieldFile& file) {
  if (file.frames().isStill()) return;
  const double rate = frameRateOf(params, file);
  for (std::size_t k = 0; k < path.size(); ++k)
    path[k].camera.time = rate > 0 ? double(k) / rate : 0;
}

/// Throws InputError if other options or the states keep a video from being made.
void requireVideo(const CommandLine& line, const Session& session) {
  if (!line.has("video")) throw InputError("--fps", "belongs to --video");
  if (line.has("shard") || line.has("format"))
    throw InputError("--video",
                     "is of all pictures, and these are PNG: leave out --shard, --format");
  requireOneSize(session.cameras);
  if (line.has("frames") && session.cameras.size() > 1)
    throw InputError("--video", "is of one state's frames: choose it with --states");
  if (std::ranges::none_of(session.cameras, hasTwoEyes)) return;
  if (!line.has("stereo"))
    throw InputError("--video", "has one picture for both eyes: add --stereo side-by-side");
  if (!std::ranges::all_of(session.cameras, hasTwoEyes))
    throw InputError("--video", "has pictures of one size, but only some states have two eyes");
}

/// Throws InputError if other options or the states leave nothing for --undistort.
void requireUndistortable(const CommandLine& line, const Session& session) {
  for (const char* other : {"format", "stereo", "video"})
    if (line.has(other))
      throw InputError("--undistort",
                       "compares PNG pictures of one eye: leave out --" + std::string(other));
  if (std::ranges::none_of(session.cameras, isDistorted))
    throw InputError("--undistort", "no state has a distortion");
}

/// Returns the size of a video's pictures.
std::array<int, 2> sizeOf(const Picture& picture, const RenderOutput& output) {
  auto [width, height] = picture.eyes.front().camera.res;
  const bool isBeside =
      output.stereo == StereoMode::sideBySide || output.stereo == StereoMode::crossEyed;
  return {isBeside ? width * int(picture.eyes.size()) : width, height};
}

/// Returns the pictures that a video shows in a second: as many as the light field has frames.
double usualRate(const Input& input) {
  constexpr double ofStills = 30;
  const double rate =
      input.file->frames().isStill() ? 0 : frameRateOf(input.session.lightField, *input.file);
  return rate > 0 ? rate : ofStills;
}

int runRender(const CommandLine& line) {
  Session session = loadSelected(line);
  if (line.has("between"))
    session.cameras = statesAlong({PathKind::between, int(*line.number("between"))}, session, 0);
  if (line.has("video") || line.has("fps")) requireVideo(line, session);
  if (line.has("undistort")) requireUndistortable(line, session);
  const std::optional<StereoMode> stereo = stereoModeOf(line, session);
  Input input(session);
  if (line.has("between")) setTimes(input.session.cameras, session.lightField, *input.file);
  std::vector<FrameState> states = statesInTime(line, input);
  if (const auto shard = shardOf(line)) keepShard(states, *shard);
  RenderOutput output{line.text("session"),
                      line.text("output"),
                      line.text("format", "png"),
                      line.has("masks"),
                      line.has("explain"),
                      line.has("ideal"),
                      stereo};
  output.isUndistorting = line.has("undistort");
  if (output.isIdeal) requireLive(input.session);
  const PanelParams display = input.display();
  const FrameNumbers listed = input.file->frames();
  std::function<std::string(int)> digits;
  if (line.has("frames")) digits = [&](int frame) { return frameDigits(frame, listed); };
  const Pictures pictures(input.session, states, digits, display,
                          int(line.number("focus-stack").value_or(0)), output);
  std::vector<fs::path> files = output.allFiles(pictures.all);
  for (const auto& [name, text] : pictures.tables) files.push_back(output.folder / name);
  if (line.has("video")) files.emplace_back(line.text("video"));
  checkResults(line, input.session, files);
  warnOfCuts(*input.file, input.session, line);
  warnOfPupils(display, input.session, line);
  const ViewSource source = unloadedOf(input.session, *input.file, line);
  if (line.has("video")) {
    makeFolderOf(line.text("video"));
    output.video.emplace(line.text("video"), sizeOf(pictures.all.front(), output),
                         line.number("fps").value_or(usualRate(input)));
  }
  makeFolder(output.folder);
  const bool isQuiet = line.has("quiet");
  announceStreaming(*input.file, allowedMemory(), isQuiet);
  ProgressBar bar("rendering", isQuiet);
  const std::string lines =
      renderAll(source, *input.file, input.session, pictures.all, output, bar.progress());
  for (const auto& [name, text] : pictures.tables) writeTextFile(output.folder / name, text);
  bar.done();
  if (finish(line, input.session))
    std::cout << lines << pictures.all.size() + 2 * pictures.undistorted << " picture(s) in "
              << printable(output.folder.string()) << "\n";
  return 0;
}

}  // namespace

Job renderJob() {
  return {
      .name = "render",
      .help = "Writes one picture for each camera state: DIR/<name>.png.",
      .examples =
          "  hogelscope --render --session data/table1.json --output out --masks\n"
          "  hogelscope --render --session data/table1.json --output out --states 'Fig 1' \\\n"
          "             --set camera.res=[1200,1200] --set sampling.samplesPerPixel=4\n"
          "  hogelscope --render --session s.json --output out --calibration camera.yml "
          "--explain\n",
      .needs = {"session", "output"},
      .takes = {"set", "states", "calibration", "twin", "plugins-path", "save-session", "shard",
                "frames", "explain", "memory", "threads", "quiet"},
      .own =
          {{.name = "format",
            .value = "png|exr|tif",
            .after = "save-session",
            .choices = {"png", "exr", "tif"},
            .help = "Of the pictures: EXR holds the unrounded values, TIFF 16 bits."},
           {.name = "ideal",
            .help = "In place of what the display shows: what the eye would see of the session's "
                    "live scene itself through the panel."},
           {.name = "undistort",
            .help =
                "Also writes, for each state with a distortion, DIR/<name>.undistorted.png, its "
                "view without the lens, <name>.undistorted-opencv.png, its picture "
                "straightened by OpenCV, and <name>.undistortion.png, the difference of the "
                "two."},
           {.name = "stereo",
            .value = "MODE",
            .choices = {stereoModeNames().begin(), stereoModeNames().end()},
            .help = "One picture for both eyes, DIR/<name>.png, of states with stereo.ipd, in "
                    "place of one for each: side-by-side, anaglyph, anaglyph-grey (red on the left "
                    "and cyan on the right), cross-eyed."},
           {.name = "focus-stack",
            .value = "N",
            .range = NumberRange{.min = 2, .max = 9999, .isInteger = true},
            .help = "Of each state with a pupil N pictures, focused evenly in dioptres over the "
                    "depths that the display can show: DIR/<name>.focus01.png and so on, and their "
                    "distances in DIR/<name>.focus.csv."},
           {.name = "between",
            .value = "N",
            .range = NumberRange{.min = 1, .max = 9999, .isInteger = true},
            .help = "The path through the states in place of them: N pictures between each two, "
                    "and the states' own, DIR/frame_0001 and so on."},
           {.name = "video",
            .value = "FILE.mp4",
            .help = "Also a video of the pictures, made by the program ffmpeg."},
           {.name = "fps",
            .value = "F",
            .range = NumberRange{.min = 0.1, .max = 240},
            .help =
                "Pictures that the video shows in a second: by default as many as a light field "
                "in time has frames, otherwise 30."},
           {.name = "masks", .help = "Also DIR/<name>.mask.png, white where the display is seen."}},
      .run = runRender};
}

}  // namespace hogelscope
