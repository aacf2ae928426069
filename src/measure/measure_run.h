// SPDX-License-Identifier: BSD-3-Clause
// --measure: all figures of a session's display, as its first state's eye sees it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/shard.h"
#include "core/optics/session.h"
#include "measure/measurement.h"

namespace hogelscope {

struct MeasureRequest {
  std::string name;  ///< of the session, for the page
  Session session;   ///< its first state's eye, PSF and pupil count, and its twin
  PanelParams display;
  std::filesystem::path output;  ///< "": nothing is written
  std::optional<Shard> shard;
};

/// A measurement's result.
struct MeasuredFigure {
  Measurement of;
  double value = 0;  ///< NaN if it cannot be measured, or there is only the closed form
  std::string problem;

  /// Returns value − closed form: 0 if both are infinite, NaN if one is missing.
  [[nodiscard]] double difference() const;
};

struct Measured {
  std::vector<MeasuredFigure> figures;
  std::size_t taken = 0;          ///< figures of an earlier run
  bool replacedAnother = false;   ///< the journal of another run
  std::vector<std::string> left;  ///< of keepThoseOfUnit()
};

/// Returns the display of a session; a lens sheet's directions are the views of its quilt. The
/// light field is opened only if a display of hogels leaves out its hogels or directions. Throws
/// InputError, Cancelled.
PanelParams displayToMeasure(const Session& session, const Progress& progress);

/// Returns the bench of a session's first state, with the unit or the design. Throws InputError
/// (also for a lens sheet whose quilt does not say its number of views).
Bench benchOf(const Session& session, const PanelParams& display,
              std::shared_ptr<const Twin> twin = nullptr);
/// Returns all figures of the session, not measured yet.
std::vector<Measurement> measurementsOf(const Session& session, const Bench& bench);

/// Measures the display, or with a twin the unit (of a lens sheet the design), and writes
/// measure.csv, measure.html and plots/NAME.svg and .csv; for a shard only its part of the figures.
/// After a stop the same request goes on where it was. Throws InputError, Cancelled.
Measured measure(const MeasureRequest& request, const Progress& progress);

/// Returns "measure.csv".
std::string csv(const std::vector<MeasuredFigure>& figures);

}  // namespace hogelscope
