// SPDX-License-Identifier: BSD-3-Clause
// Renders the views that Python asks for, and keeps what they share from one call to the next.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/optics/eyes.h"
#include "core/optics/viewing.h"
#include "python/bindings.h"
#include "python/content.h"
#include "python/picture_memory.h"

namespace hogelscope {

struct OpenScene;
struct SceneOrigin;
struct ViewRenderers;

/// The request of views.
struct ViewRequest {
  Document document;
  std::optional<std::vector<std::string>> states;  ///< their names; all without them
  LightChoice light;
  bool isIdeal = false;
  std::optional<Eye> eye;  ///< of states with `stereo`; the head's view without one
  int stackCount = 0;      ///< of a focus stack; 0: none
  std::size_t first = 0;   ///< the first of these states that is wanted
  bool isPart = false;     ///< as many states from there on as are best rendered together; else all
  std::vector<std::uint8_t*> out;            ///< memory of the pictures; empty: they get their own
  std::vector<std::array<int, 2>> outSizes;  ///< width and height of each
  std::optional<int> frame;    ///< of a light field in time, for states without a time
  std::optional<double> time;  ///< seconds, as `frame`
};

/// The values of one view before rounding, which are rendered when they are asked for. It keeps no
/// light field in memory but a small numpy array's: another one is opened again if it was closed.
class UnroundedView {
 public:
  UnroundedView(std::shared_ptr<const SceneOrigin> origin, CameraState state, bool isIdeal,
                const std::shared_ptr<ViewRenderers>& renderers);

  /// Returns the values, 3·width·height floats. Throws InputError (a file has changed since the
  /// view was rendered), Cancelled.
  [[nodiscard]] PictureMemory render(const Progress& progress) const;
  /// Returns width and height.
  [[nodiscard]] std::array<int, 2> res() const { return m_state.camera.res; }

 private:
  std::shared_ptr<const SceneOrigin> m_origin;
  std::weak_ptr<ViewRenderers> m_renderers;
  CameraState m_state;
  bool m_isIdeal;
};

/// A view's picture.
struct RenderedView {
  std::string state;
  std::optional<double> focus;  ///< of a focus stack, metres
  std::array<int, 2> res{};
  PictureMemory rgb;   ///< 3·width·height bytes; empty if the request gave memory
  PictureMemory seen;  ///< width·height of 0 or 1
  std::shared_ptr<UnroundedView> unrounded;  ///< null for a streamed light field
  PictureMemory values;                      ///< floats, where they cannot be made later
  Viewing viewing;
};

struct RenderedViews {
  std::vector<RenderedView> views;
  std::vector<std::string> inputs;  ///< the files of the light field
};

class SessionViews {
 public:
  SessionViews();

  /// Renders views; many small ones side by side. Throws InputError, Cancelled.
  RenderedViews render(const ViewRequest& request, const Progress& progress);

 private:
  const Session& parsed(const Document& document);
  std::shared_ptr<Content> ownContent(const Session& session, const Progress& progress);
  std::shared_ptr<const OpenScene> sceneOf(const Session& session,
                                           const std::shared_ptr<Content>& content, int frame,
                                           const Progress& progress);

  std::shared_ptr<ViewRenderers> m_renderers;
  Document m_document;  ///< of the parsed session
  std::optional<Session> m_session;
  std::shared_ptr<const OpenScene> m_scene;
};

}  // namespace hogelscope
