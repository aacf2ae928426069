// SPDX-License-Identifier: BSD-3-Clause
// Shared by the layouts that are made of views.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/files/system_limits.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// A file whose rows of hogels are spread over all of it: if memory is too small for the whole, it
/// is read once for each band of rows.
class ScatteredFile : public LightFieldFile {
 public:
  [[nodiscard]] LightField read(const Progress& progress) override {
    return readBand(0, size().ny, progress);
  }

  void stream(const HogelRow& row, const Progress& progress) override {
    const int ny = size().ny;
    const int rows = rowsAtATime();
    for (int begin = 0; begin < ny; begin += rows) {
      const int end = std::min(ny, begin + rows);
      const Progress ofBand = part(progress, double(begin) / ny, double(end) / ny);
      handOut(readBand(begin, end, part(ofBand, 0, 0.5)), begin, row, part(ofBand, 0.5, 1));
    }
  }

 protected:
  /// Hogel rows [begin, end), of which the first one has j = 0 here.
  [[nodiscard]] virtual LightField readBand(int begin, int end, const Progress& progress) = 0;

 private:
  [[nodiscard]] int rowsAtATime() const {
    constexpr double mostTexels = std::numeric_limits<std::uint32_t>::max() - 1.0;
    const double texels =
        std::min(mostTexels, double(allowedMemory()) / 2 / double(memoryBytes(type())));
    const double fitting = texels / (double(size().width()) * size().dv);
    return std::max(1, int(std::min(fitting, double(size().ny))));
  }

  static void handOut(const LightField& band, int begin, const HogelRow& row,
                      const Progress& progress) {
    for (int j = 0; j < band.size().ny; ++j) {
      reportProgress(progress, double(j) / band.size().ny);
      for (int v = 0; v < band.size().dv; ++v) handOutRow(band, j, v, row, begin + j);
    }
  }
};

/// Returns the parameters with the views as they lie in the file: the usual order, no shear.
inline LightFieldParams withoutOrder(LightFieldParams params) {
  params.rows = RowOrder::topDown;
  params.columns = ColumnOrder::leftRight;
  params.shear = {0, 0};
  return params;
}

/// Returns where pixel (x, y) of the view in this row and column of the grid goes within hogel rows
/// [begin, begin + rows): its texel, or none.
inline auto placeOfView(const LightFieldParams& params, const LightFieldSize& size, int row,
                        int column, int begin, int rows) {
  const int u = params.columns == ColumnOrder::leftRight ? column : size.du - 1 - column;
  const int v = params.rows == RowOrder::topDown ? row : size.dv - 1 - row;
  const int right = int(std::floor(params.shear[0] * (u - (size.du - 1) / 2.0) + 0.5));
  const int down = int(std::floor(params.shear[1] * (v - (size.dv - 1) / 2.0) + 0.5));
  return [=, nx = size.nx](int x, int y) -> std::optional<TexelIndex> {
    const TexelIndex at{x + right, y + down - begin, u, v};
    if (at.i < 0 || at.i >= nx || at.j < 0 || at.j >= rows) return std::nullopt;
    return at;
  };
}

}  // namespace hogelscope
