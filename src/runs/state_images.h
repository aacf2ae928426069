// SPDX-License-Identifier: BSD-3-Clause
// The images of many camera states from one light field, however large it is.
#pragma once

#include <string>
#include <vector>

#include "core/base/shard.h"
#include "core/engine/renderer.h"
#include "io/scene/view_source.h"

namespace hogelscope {

/// A state's image, or the problem.
struct StateImage {
  Image image;
  std::string problem;
};

/// Whether the file exceeds `memory` bytes and can be streamed.
bool mustStream(const LightFieldFile& file, std::size_t memory);

/// Renders views of a light field that has nothing in memory. Uses at most `memory` bytes besides
/// the images and one hogel row of the file; if that is too little for all views, the file is read
/// several times, and a view that alone needs more has a problem. Throws InputError (damaged file,
/// images exceed the machine's memory), Cancelled.
std::vector<StateImage> renderStreamed(LightFieldFile& file, const std::vector<RenderJob>& views,
                                       std::size_t memory, const ParallelRows& parallelRows,
                                       const Progress& progress);

/// Renders images on request. Only those of a light field that must be streamed (mustStream()) are
/// made while it is read, and kept.
class StateImages {
 public:
  struct Options {
    SourceUse use{};
    Shard shard{};                ///< the states that are rendered
    int bits = 8;                 ///< of the images' values
    bool keepsUnrounded = false;  ///< in addition to the rounded values
    ParallelRows rows = parallelRows;
  };

  /// Takes a scene whose light field is open.
  StateImages(ViewSource source, const std::vector<CameraState>& states)
      : m_source(std::move(source)), m_states(states) {}
  /// Reads `file`, the light field that `unloaded` is without. Throws InputError, Cancelled.
  StateImages(ViewSource unloaded, LightFieldFile& file, const std::vector<CameraState>& states,
              const Options& options, const Progress& progress);

  /// Returns the image of a state. Throws InputError if it cannot be rendered, and Cancelled.
  [[nodiscard]] Image render(std::size_t state, Renderer& renderer, const Progress& progress) const;
  /// Returns an unrounded image; not for a streamed light field.
  [[nodiscard]] FloatImage renderFloat(std::size_t state, Renderer& renderer,
                                       const Progress& progress) const {
    return renderer.renderFloat(job(state), progress);
  }

  [[nodiscard]] RenderJob job(std::size_t state) const { return m_source.job(m_states[state]); }
  [[nodiscard]] bool areStreamed() const { return !m_streamed.empty(); }
  [[nodiscard]] const ViewSource& source() const { return m_source; }
  /// Switches to ideal views.
  void showIdeal() { m_source.isIdeal = true; }

 private:
  ViewSource m_source;
  std::vector<CameraState> m_states;
  std::vector<StateImage> m_streamed;  ///< of all states; empty if they are rendered on request
};

}  // namespace hogelscope
