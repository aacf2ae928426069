// SPDX-License-Identifier: BSD-3-Clause
// Layout "views" in one file.
#include "io/layouts/view_sequences.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "capture/names/view_grid.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "io/images/hdf5_views.h"
#include "io/images/image_file.h"
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

/// Frames are decoded in their order: each needs those before it.
class VideoViews : public ScatteredFile {
 public:
  VideoViews(const LightFieldParams& params, const DisplayParams& display)
      : m_params(params),
        m_image(params.file),
        m_grid(gridOfSequence(
            m_image.frames(),
            {params.file, {}, display.directions, params.scan == ViewScan::serpentine})),
        m_size{int(m_image.width()), int(m_image.height()), int(m_grid.columns), int(m_grid.rows)} {
  }

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

class Hdf5File : public ScatteredFile {
 public:
  explicit Hdf5File(const LightFieldParams& params)
      : m_params(params), m_views(params.file, params.pattern) {}

  [[nodiscard]] StoredType type() const override { return m_views.type(); }
  [[nodiscard]] LightFieldSize size() const override { return m_views.size(); }
  [[nodiscard]] std::vector<fs::path> files() const override { return {m_params.file}; }

  [[nodiscard]] LightField readBand(int begin, int end, const Progress& progress) override {
    const auto [nx, ny, du, dv] = size();
    LightField lightField =
        blankLightField({nx, end - begin, du, dv}, type(), m_params.file, packIt);
    for (int row = 0; row < dv; ++row)
      for (int column = 0; column < du; ++column) {
        const double views = double(du) * dv;
        const double done = double(row) * du + column;
        Hdf5View view = m_views.view(row, column);
        readTexels(view, type(), lightField, m_params.incoming,
                   placeOfView(m_params, size(), row, column, begin, end - begin),
                   part(progress, done / views, (done + 1) / views));
      }
    return lightField;
  }

 private:
  LightFieldParams m_params;
  Hdf5Views m_views;
};

}  // namespace

bool isViewSequence(const std::string& file) {
  std::error_code error;
  return fs::is_regular_file(file, error) && (isVideo(file) || Hdf5Views::isHdf5(file));
}

std::unique_ptr<LightFieldFile> openViewSequence(const LightFieldParams& params,
                                                 const DisplayParams& display) {
  if (Hdf5Views::isHdf5(params.file)) return std::make_unique<Hdf5File>(params);
  return std::make_unique<VideoViews>(params, display);
}

}  // namespace hogelscope
