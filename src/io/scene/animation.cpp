// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/animation.h"

#include <optional>

#include "core/base/error.h"
#include "core/cameras/camera_path.h"
#include "core/engine/renderer.h"
#include "io/files/atomic_file.h"
#include "io/files/folders.h"
#include "io/images/image_writer.h"
#include "io/images/video_writer.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Files that are deleted at the end unless they are kept.
class NewFiles {
 public:
  NewFiles() = default;
  NewFiles(const NewFiles&) = delete;
  NewFiles& operator=(const NewFiles&) = delete;
  ~NewFiles() {
    std::error_code none;
    for (const fs::path& file : m_files) fs::remove(file, none);
  }
  void add(const fs::path& file) { m_files.push_back(file); }
  void keep() { m_files.clear(); }

 private:
  std::vector<fs::path> m_files;
};

constexpr const char* videoName = "animation.mp4";

}  // namespace

void checkAnimation(const std::vector<CameraState>& states, const fs::path& folder, bool hasVideo) {
  if (hasVideo) requireOneSize(states);
  fs::path there = fs::absolute(folder);
  std::error_code none;
  while (!fs::exists(there, none) && there.has_relative_path()) there = there.parent_path();
  checkWritable(there);
  if (!isFolder(folder)) return;
  for (const fs::path& file : filesIn(folder)) {
    const std::string name = file.filename().string();
    if (name == videoName || (name.starts_with("frame_") && name.ends_with(".png")))
      throw InputError(file.string(), "is there already", "choose an empty folder");
  }
}

void writeAnimation(const AnimationRequest& request, const Progress& progress) {
  const auto& [source, states, folder, framesPerSecond, ffmpeg] = request;
  checkAnimation(states, folder, !ffmpeg.empty());
  makeFolder(folder);
  NewFiles files;
  std::optional<VideoWriter> video;
  if (!ffmpeg.empty())
    video.emplace(folder / videoName, states[0].camera.res, framesPerSecond, ffmpeg);
  Renderer renderer;
  const auto count = double(states.size());
  for (std::size_t k = 0; k < states.size(); ++k) {
    const Progress of = part(progress, double(k) / count, double(k + 1) / count);
    const Image image = renderer.render(source.job(states[k]), of);
    const fs::path file = folder / (states[k].camera.name + ".png");
    writeImage(file, image.width, image.height, image.rgb, [&](double) { return !of || of(1); });
    files.add(file);
    if (video) video->add(image.rgb, of);
  }
  if (video) video->finish(progress);
  files.keep();
}

}  // namespace hogelscope
