// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/twin_content.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/optics/image.h"
#include "core/optics/psf.h"

namespace hogelscope {

namespace {

int cellOf(double index, int count) {
  return std::clamp(static_cast<int>(std::floor(index)), 0, count - 1);
}

}  // namespace

TwinContent::TwinContent(std::shared_ptr<LightFieldFile> content, const PanelParams& display,
                         std::shared_ptr<const Twin> twin)
    : WrappedFile(std::move(content)),
      m_design(display),
      m_twin(std::move(twin)),
      m_leastGain(m_twin->leastGain()) {}

/// Returns the light along rays: of the scene, or of the texels of the design that send it.
std::vector<Rgb> TwinContent::lightAlong(const LightFieldSource& source,
                                         const std::vector<PanelRay>& rays) const {
  std::vector<Rgb> light(rays.size());
  if (const LiveScene* const scene = source.scene()) {
    scene->traceRays(rays, light);
    return light;
  }
  const auto [nx, ny, du, dv] = size();
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const auto& [at, slopes] = rays[k];
    const std::optional<Hit> hit =
        m_design.intersectPlane({at.x + slopes.x, at.y + slopes.y, 1}, {-slopes.x, -slopes.y, -1});
    light[k] = source.texel(
        {cellOf(hit->i, nx), cellOf(hit->j, ny), cellOf(hit->u, du), cellOf(hit->v, dv)});
  }
  return light;
}

void TwinContent::divideByGain(int j, std::vector<Rgb>& light) const {
  if (!m_twin->hasGains()) return;
  const auto [nx, ny, du, dv] = size();
  for (int i = 0; i < nx; ++i) {
    const std::array<float, 3> gain = m_twin->gainOf(i, j);
    const auto divided = [&](double code, std::size_t c) {
      if (!(gain[c] > 0)) return code;
      const double share = m_leastGain / double(gain[c]);
      return encodedFromLinear(share * linearFromEncoded(code));
    };
    for (int u = 0; u < du; ++u) {
      Rgb& own = light[std::size_t(i) * std::size_t(du) + std::size_t(u)];
      own = {divided(own.r, 0), divided(own.g, 1), divided(own.b, 2)};
    }
  }
}

/// Returns directions (·, v) of hogels (·, j), in code values.
std::vector<Rgb> TwinContent::lightOf(const LightFieldSource& source, int j, int v) const {
  const auto [nx, ny, du, dv] = size();
  const auto along = [&, nx = nx, du = du](std::size_t channel) {
    std::vector<PanelRay> rays;
    for (int i = 0; i < nx; ++i)
      for (int u = 0; u < du; ++u) rays.push_back(m_twin->rayOf(i, j, u + 0.5, v + 0.5, channel));
    return lightAlong(source, rays);
  };
  std::vector<Rgb> light = along(greenChannel);
  if (m_twin->traits().splitsColours) {
    const std::vector<Rgb> red = along(0);
    const std::vector<Rgb> blue = along(2);
    for (std::size_t k = 0; k < light.size(); ++k) {
      light[k].r = red[k].r;
      light[k].b = blue[k].b;
    }
  }
  divideByGain(j, light);
  return light;
}

void TwinContent::stream(const HogelRow& row, const Progress& progress) {
  const std::shared_ptr<const LightFieldSource> source =
      content().source({}, part(progress, 0, 0.2));
  const Progress rest = part(progress, source->isInMemory() ? 0.2 : 0, 1);
  const auto [nx, ny, du, dv] = size();
  withStoredType(type(), [&, ny = ny, dv = dv](auto zero) {
    using T = decltype(zero);
    std::vector<std::vector<T>> rows(static_cast<std::size_t>(dv));
    for (int j = 0; j < ny; ++j) {
      reportProgress(rest, double(j) / ny);
      parallelRows(dv, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
          auto& values = rows[static_cast<std::size_t>(v)];
          values.clear();
          for (const Rgb& code : lightOf(*source, j, v))
            for (const double value : {code.r, code.g, code.b})
              values.push_back(storedValue<T>(value));
        }
      });
      for (int v = 0; v < dv; ++v) row(j, v, StoredRows(rows[static_cast<std::size_t>(v)].data()));
    }
  });
}

}  // namespace hogelscope
