// SPDX-License-Identifier: BSD-3-Clause
// Content for one unit: texels that show through a twin what the light field would show through the
// display as designed.
#pragma once

#include "core/panel/twin.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// A light field whose texels are the content's light along the twin's own rays: traced if the
/// content is live, else that of the texel that the display as designed sends there. Each texel is
/// divided by its hogel's gain, with the dimmest hogel that is not dark as white. Light outside the
/// display's field is that of its border.
class TwinContent : public WrappedFile {
 public:
  /// `display` has its hogels and directions.
  TwinContent(std::shared_ptr<LightFieldFile> content, const PanelParams& display,
              std::shared_ptr<const Twin> twin);

  void stream(const HogelRow& row, const Progress& progress) override;

 private:
  [[nodiscard]] std::vector<Rgb> lightOf(const LightFieldSource& source, int j, int v) const;
  [[nodiscard]] std::vector<Rgb> lightAlong(const LightFieldSource& source,
                                            const std::vector<PanelRay>& rays) const;
  void divideByGain(int j, std::vector<Rgb>& light) const;

  Display m_design;
  std::shared_ptr<const Twin> m_twin;
  double m_leastGain;
};

}  // namespace hogelscope
