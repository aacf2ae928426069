// SPDX-License-Identifier: BSD-3-Clause
// Layout "views": images of one direction of all hogels, in a folder or as the frames of a file.
#include <algorithm>
#include <cmath>
#include <string_view>

#include "capture/names/view_grid.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "io/files/folders.h"
#include "io/images/image_inputs.h"
#include "io/images/picture_facts.h"
#include "io/images/video_format.h"
#include "io/layouts/layouts.h"
#include "io/layouts/picture_files.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

class ViewsFolder : public ScatteredFile {
 public:
  ViewsFolder(const LightFieldParams& params, const DisplayParams& display)
      : ScatteredFile(params), m_views(findViews(params, display.directions)) {
    ImageFile first(m_views.found().front(), params.yuv);
    takeTypeOf(first);
    takeFramesOf(first);
    if (!frames().isStill()) m_videos.resize(m_views.files.size());
    m_size = {int(first.width()), int(first.height()), m_views.columns, m_views.rows};
    if (!m_views.missing.empty()) m_warnings.push_back(m_views.missing);
    warnOf("the first view, " + first.file().filename().string() + ",", first.notesOfOne());
  }

  [[nodiscard]] std::vector<fs::path> files() const override { return m_views.found(); }

 private:
  /// Reads views side by side: most of the time is for decoding.
  void fill(LightField& band, int begin, const Progress& progress) override {
    const std::size_t count = m_views.files.size();
    StepProgress steps(progress);
    steps.expect(double(count));
    sideBySide(count, threadCount(), [&](std::size_t k, std::size_t /*worker*/) {
      if (!m_views.files[k].empty())  // missing views stay black
        readInto(k, begin, band, steps.within());
      steps.finish();
    });
  }

  void readInto(std::size_t k, int begin, LightField& band, const Progress& progress) {
    if (m_videos.empty()) {
      ImageFile image(m_views.files[k], m_params.yuv);
      return readImage(image, k, begin, band, progress);
    }
    if (!m_videos[k]) m_videos[k] = std::make_unique<ImageFile>(m_views.files[k], m_params.yuv);
    requireSameFrames(*m_videos[k]);
    m_videos[k]->select(frame());
    readImage(*m_videos[k], k, begin, band, progress);
  }

  /// Throws InputError unless a video has the frames and the rate of the first view.
  void requireSameFrames(const ImageFile& video) const {
    if (video.frames() != framesInFiles())
      throw InputError(video.file().string(), "frames",
                       "are " + std::to_string(video.frames()) + ", but the first view has " +
                           std::to_string(framesInFiles()));
    if (std::abs(video.rate() - frameRate()) > 1e-3 * frameRate())
      throw InputError(video.file().string(), "frames",
                       "are " + numberText(video.rate()) +
                           " a second, but those of the first view " + numberText(frameRate()));
  }

  void readImage(ImageFile& image, std::size_t k, int begin, LightField& band,
                 const Progress& progress) const {
    if (image.width() != std::size_t(m_size.nx) || image.height() != std::size_t(m_size.ny))
      throw InputError(image.file().string(), "size",
                       "is " + pairText(image.width(), image.height()) +
                           " px, but the first view is " + pairText(m_size.nx, m_size.ny) +
                           "; lightField.exclude leaves out what is no view");
    const int row = int(k) / m_views.columns;
    const int column = int(k) % m_views.columns;
    readView(image, band, m_params.incoming, originOfView(m_params, m_size, row, column, begin),
             progress);
  }

  ViewFiles m_views;
  /// The views' videos, which stay open for their next frames; empty if the views are pictures.
  std::vector<std::unique_ptr<ImageFile>> m_videos;
};

/// Whether the content or the name is a video's: a damaged one is still a video.
bool isVideo(const fs::path& file) {
  constexpr std::array<std::string_view, 10> extensions{".avi", ".mov",  ".mp4", ".m4v", ".qt",
                                                        ".mj2", ".webm", ".mkv", ".y4m", ".yuv"};
  const std::string extension = lowerCase(file.extension().string());
  return std::ranges::find(extensions, extension) != extensions.end() ||
         !videoFormatOf(file).empty();
}

/// The frames of a file, read in their order, because each frame of a video needs those before it.
class ViewSequence : public ScatteredFile {
 public:
  ViewSequence(const LightFieldParams& params, ImageFile image, const SequenceGrid& grid)
      : ScatteredFile(params), m_image(std::move(image)), m_grid(grid) {
    takeTypeOf(m_image);
    m_size = {int(m_image.width()), int(m_image.height()), int(grid.columns), int(grid.rows)};
    warnOf("the file", m_image.notes());
    if (const auto [across, down] = quiltNameOf(m_params.file).tiles; across > 0)
      m_warnings.push_back("the name says that each frame is a quilt of " + pairText(across, down) +
                           " views, but each is read as one view; lightField.layout=quilt reads "
                           "them as quilts");
  }

 private:
  void fill(LightField& band, int begin, const Progress& progress) override {
    const std::size_t frames = m_image.frames();
    for (std::size_t frame = 0; frame < frames; ++frame) {
      const std::size_t cell = m_grid.cellOf(frame);
      m_image.select(frame);
      readView(m_image, band, m_params.incoming,
               originOfView(m_params, m_size, int(cell / m_grid.columns),
                            int(cell % m_grid.columns), begin),
               part(progress, double(frame) / double(frames), double(frame + 1) / double(frames)));
    }
  }

  ImageFile m_image;
  SequenceGrid m_grid;
};

std::unique_ptr<LightFieldFile> openViews(const LightFieldParams& params,
                                          const DisplayParams& display, const Progress&) {
  if (!isViewSequence(params.file)) return std::make_unique<ViewsFolder>(params, display);
  const bool isArray = isHdf5(params.file);
  ImageFile views = isArray ? ImageFile(params.file, openHdf5(params.file, params.pattern))
                            : ImageFile(params.file, params.yuv);
  const SequenceGrid grid =
      views.columns() > 0
          ? SequenceGrid{views.frames() / views.columns(), views.columns()}
          : gridOfSequence(views.frames(), {params.file, {}, display.directions, params.scan});
  return std::make_unique<ViewSequence>(params, std::move(views), grid);
}

}  // namespace

bool isViewSequence(const std::string& file) {
  std::error_code error;
  return fs::is_regular_file(file, error) && (isVideo(file) || isHdf5(file) || hasViewPages(file));
}

const LayoutType viewsLayout{
    .open = openViews, .holder = Holder::views, .foundBy = [](const LightFieldParams& params) {
      return FoundBy{isFolder(params.file) ? "a folder of pictures" : "frames of one file",
                     "size and number of the pictures", "display.directions"};
    }};

}  // namespace hogelscope
