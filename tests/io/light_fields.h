// SPDX-License-Identifier: BSD-3-Clause
// Known content for tests of stores and streams, and its parameters.
#pragma once

#include <QTest>

#include "io/layouts/light_field_file.h"
#include "tests/io/images.h"
#include "tests/io/texels.h"

namespace hogelscope {

/// Returns values that differ in each index and channel; black in some blocks, uniform in others.
inline float valueAt(const TexelIndex& at, int channel) {
  if (at.i < 8 && at.u < 8) return 0;
  if (at.i < 8) return 0.5F;
  const int mixed = at.i * 131 + at.j * 37 + at.u * 11 + at.v * 71 + channel * 53;
  return float(mixed % 255) / 255;
}

inline PictureValue hogelImage(const LightFieldSize& size) {
  return [size](int x, int y, int channel) {
    return valueAt({x / size.du, y / size.dv, x % size.du, y % size.dv}, channel);
  };
}

inline PanelParams displayOf(const LightFieldSize& size) {
  PanelParams display;
  display.hogels = {size.nx, size.ny};
  display.directions = {size.du, size.dv};
  return display;
}

inline LightFieldParams paramsOf(const std::string& file, Layout layout = Layout::hogels,
                                 bool incoming = false) {
  LightFieldParams params;
  params.file = file;
  params.layout = layout;
  params.incoming = incoming;
  return params;
}

inline QString firstDifference(const LightField& is, const LightField& should) {
  if (is.size() != should.size()) return "the size";
  if (is.texels().index() != should.texels().index()) return "the type";
  return firstWrong(is, [&](const TexelIndex& at) { return should.texel(at); });
}

/// Returns the streamed rows as a light field.
inline LightField streamed(LightFieldFile& file) {
  LightField result(file.size(), file.type());
  const int du = file.size().du;
  int last = 0;
  file.stream(
      [&](int j, int v, const StoredRows& rgb) {
        QVERIFY(j >= last);
        last = j;
        std::visit(
            [&](const auto* values) {
              for (int x = 0; x < int(file.size().width()); ++x, values += 3)
                result.set({x / du, j, x % du, v}, values);
            },
            rgb);
      },
      {});
  return result;
}

}  // namespace hogelscope
