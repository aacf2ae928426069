// SPDX-License-Identifier: BSD-3-Clause
// The picture of a lens sheet's panel, woven of views.
#pragma once

#include "core/panel/lens_sheet.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// A light field whose hogels are the panel's pixels, with one direction: each sub-pixel has the
/// view that it shows (LensSheet::viewOf), at the pixel's middle.
class WovenFile : public WrappedFile {
 public:
  /// `views` has one row of views; they are of a live scene if `isLive`. Throws InputError for
  /// others.
  WovenFile(std::unique_ptr<LightFieldFile> views, LensSheet sheet, bool isLive);

  [[nodiscard]] LightFieldSize size() const override;
  /// Returns the panel in memory, and the scene behind it if that is live.
  [[nodiscard]] std::shared_ptr<const LightFieldSource> source(const SourceUse& use,
                                                               const Progress& progress) override;
  void stream(const HogelRow& row, const Progress& progress) override;

 private:
  LensSheet m_sheet;
  bool m_isLive;
};

}  // namespace hogelscope
