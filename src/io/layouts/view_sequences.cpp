// SPDX-License-Identifier: BSD-3-Clause
// Layout "views" in one file.
#include "io/layouts/view_sequences.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "capture/names/view_grid.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "io/images/image_file.h"
#include "io/images/image_inputs.h"
#include "io/layouts/scattered_file.h"
#include "io/layouts/texel_placement.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

bool isVideo(const fs::path& file) {
  constexpr std::array<std::string_view, 6> extensions{".avi", ".mov", ".mp4",
                                                       ".m4v", ".qt",  ".mj2"};
  const std::string extension = lowerCase(file.extension().string());
  return std::ranges::find(extensions, extension) != extensions.end();
}

/// Frames of a video are decoded in their order: each needs those before it.
class ViewSequence : public ScatteredFile {
 public:
  ViewSequence(const LightFieldParams& params, ImageFile image, const SequenceGrid& grid)
      : m_params(params),
        m_image(std::move(image)),
        m_grid(grid),
        m_size{int(m_image.width()), int(m_image.height()), int(grid.columns), int(grid.rows)} {}

  [[nodiscard]] StoredType type() const override { return m_image.type(); }
  [[nodiscard]] int bits() const override { return m_image.bits(); }
  [[nodiscard]] LightFieldSize size() const override { return m_size; }
  [[nodiscard]] std::vector<fs::path> files() const override { return {m_image.file()}; }

  [[nodiscard]] LightField readBand(int begin, int end, const Progress& progress) override {
    LightField lightField = blankLightField({m_size.nx, end - begin, m_size.du, m_size.dv}, type(),
                                            m_params.file, packIt);
    const std::size_t frames = m_image.frames();
    for (std::size_t frame = 0; frame < frames; ++frame) {
      const std::size_t cell = m_grid.cellOf(frame);
      m_image.select(frame);
      readTexels(
          m_image, type(), lightField, m_params.incoming,
          placeOfView(m_params, m_size, int(cell / m_grid.columns), int(cell % m_grid.columns),
                      begin, end - begin),
          part(progress, double(frame) / double(frames), double(frame + 1) / double(frames)));
    }
    return lightField;
  }

 private:
  LightFieldParams m_params;
  ImageFile m_image;
  SequenceGrid m_grid;
  LightFieldSize m_size;
};

}  // namespace

bool isViewSequence(const std::string& file) {
  std::error_code error;
  return fs::is_regular_file(file, error) && (isVideo(file) || isHdf5(file));
}

std::unique_ptr<LightFieldFile> openViewSequence(const LightFieldParams& params,
                                                 const DisplayParams& display) {
  if (isHdf5(params.file)) {
    auto views = openHdf5(params.file, params.pattern);
    const SequenceGrid grid{views->facts().frames / views->facts().columns, views->facts().columns};
    return std::make_unique<ViewSequence>(params, ImageFile(params.file, std::move(views)), grid);
  }
  ImageFile video(params.file);
  const SequenceGrid grid = gridOfSequence(
      video.frames(), {params.file, {}, display.directions, params.scan == ViewScan::serpentine});
  return std::make_unique<ViewSequence>(params, std::move(video), grid);
}

}  // namespace hogelscope
