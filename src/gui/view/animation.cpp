// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/animation.h"

#include <unistd.h>
#include <QCheckBox>
#include <QFormLayout>
#include <QProcess>
#include <QSpinBox>
#include <cstdio>

#include "core/base/error.h"
#include "core/engine/renderer.h"
#include "io/files/atomic_file.h"
#include "io/files/folders.h"
#include "io/images/image_writer.h"

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

constexpr const char* pattern = "frame_%04d.png";  // also for ffmpeg

fs::path frameOf(const fs::path& folder, int number) {
  std::array<char, 32> name{};
  (void)std::snprintf(name.data(), name.size(), pattern, number);
  return folder / name.data();
}

/// Throws if there are old frames, which could belong to the user and would end up in the video.
void refuseOldFrames(const fs::path& folder) {
  if (!isFolder(folder)) return;
  for (const fs::path& file : filesIn(folder)) {
    const std::string name = file.filename().string();
    if (name == "animation.mp4" || (name.starts_with("frame_") && name.ends_with(".png")))
      throw InputError(file.string(), "is there already", "choose an empty folder");
  }
}

void requireOneSize(const std::vector<RenderJob>& views, const fs::path& video) {
  const CameraParams& first = views.front().state.camera;
  for (const RenderJob& view : views) {
    const CameraParams& camera = view.state.camera;
    if (camera.res != first.res)
      throw InputError(video.string(), "cannot be written",
                       "a video's pictures have one size, those of " + first.name + " and " +
                           camera.name + " differ; the numbered pictures alone may");
  }
}

std::string lastLine(const QByteArray& output) {
  const QByteArray text = output.trimmed();
  return text.mid(text.lastIndexOf('\n') + 1).toStdString();
}

/// Writes the video to an unnamed temporary file.
void writeVideo(const AnimationRequest& request, const fs::path& video, const Progress& progress) {
  AtomicFile file(video);
  const QString descriptor = QString("/proc/%1/fd/%2").arg(::getpid()).arg(file.descriptor());
  const auto path = [](const fs::path& of) { return QString::fromStdString(of.string()); };
  QProcess ffmpeg;
  ffmpeg.setProcessChannelMode(QProcess::MergedChannels);
  // H.264 in a pixel format that all players support needs even sides.
  ffmpeg.start(path(request.ffmpeg),
               {"-nostdin", "-loglevel", "error", "-y", "-framerate",
                QString::number(request.framesPerSecond), "-start_number", "1", "-i",
                path(request.folder / pattern), "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt",
                "yuv420p", "-crf", "17", "-f", "mp4", descriptor});
  constexpr int patience = 50;  // milliseconds
  while (ffmpeg.state() != QProcess::NotRunning) {
    ffmpeg.waitForFinished(patience);
    if (progress && !progress(0)) {
      ffmpeg.kill();
      ffmpeg.waitForFinished();
      throw Cancelled();
    }
  }
  if (ffmpeg.error() == QProcess::FailedToStart)
    throw InputError(request.ffmpeg.string(), "cannot be started",
                     ffmpeg.errorString().toStdString());
  if (ffmpeg.exitStatus() != QProcess::NormalExit || ffmpeg.exitCode() != 0)
    throw InputError(video.string(), "cannot be written", "ffmpeg: " + lastLine(ffmpeg.readAll()));
  file.commit();
}

}  // namespace

void writeAnimation(const AnimationRequest& request, const Progress& progress) {
  const fs::path video = request.folder / "animation.mp4";
  const bool hasVideo = !request.ffmpeg.empty();
  if (hasVideo) requireOneSize(request.views, video);
  refuseOldFrames(request.folder);
  makeFolder(request.folder);
  NewFiles files;
  Renderer renderer;
  // Encoding a frame takes about a tenth of the time of rendering it.
  const double frames = hasVideo ? 0.9 : 1;
  const auto count = double(request.views.size());
  for (std::size_t k = 0; k < request.views.size(); ++k) {
    const Progress of = part(progress, frames * double(k) / count, frames * double(k + 1) / count);
    const Image image = renderer.render(request.views[k], of);
    const fs::path file = frameOf(request.folder, int(k) + 1);
    writeImage(file, image.width, image.height, image.rgb, [&](double) { return !of || of(1); });
    files.add(file);
  }
  if (hasVideo) writeVideo(request, video, part(progress, frames, 1));
  files.keep();
}

AnimationDialog::AnimationDialog(const QSize& proposed, const QString& ffmpeg, QWidget* parent)
    : SizeDialog(tr("Save animation"), proposed, parent),
      m_video(new QCheckBox(tr("&Video (animation.mp4)"))),
      m_rate(new QSpinBox) {
  m_video->setObjectName("videoBox");
  m_rate->setObjectName("rateBox");
  m_rate->setRange(1, 120);
  m_rate->setValue(10);
  m_rate->setSuffix(tr(" per second"));
  m_rate->setToolTip(tr("How many states the video shows in a second"));
  m_video->setEnabled(!ffmpeg.isEmpty());
  m_video->setChecked(!ffmpeg.isEmpty());
  m_video->setToolTip(
      ffmpeg.isEmpty() ? tr("Needs the program ffmpeg, which is not installed: no ffmpeg in PATH")
                       : tr("Beside the numbered pictures, made by %1").arg(ffmpeg));
  m_rate->setEnabled(m_video->isChecked());
  connect(m_video, &QCheckBox::toggled, m_rate, &QWidget::setEnabled);
  form()->addRow(m_video);
  form()->addRow(tr("&States"), m_rate);
}

bool AnimationDialog::hasVideo() const {
  return m_video->isChecked();
}

int AnimationDialog::framesPerSecond() const {
  return m_rate->value();
}

}  // namespace hogelscope
