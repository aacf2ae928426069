// SPDX-License-Identifier: BSD-3-Clause
// Renders the contents of the 3-D scene on its own thread: the panel as the scene's eye sees it,
// small views of all states, and the mesh of a live scene.
// The panel is rendered by a camera whose image plane is the panel itself (panelState), so nothing
// has to be reprojected.
#pragma once

#include <vtkNew.h>

#include <QObject>
#include <optional>
#include <vector>

#include "gui/widgets/latest_wins.h"
#include "io/scene/view_source.h"
#include "vtk/scene_data.h"
#include "vtk/vtkHogelViewFilter.h"

namespace hogelscope {

/// Emits its signals on the thread that the object lives in. No signal of an older scene arrives
/// after setScene().
class SceneWorker : public QObject {
  Q_OBJECT

 public:
  explicit SceneWorker(QObject* parent = nullptr);

  /// Sets the scene that is rendered; none stops rendering. The old scene's memory is released when
  /// the current rendering stops.
  void setSource(const std::optional<ViewSource>& scene);
  /// Renders the panel. The newest request wins, but a running one is finished, so that a turning
  /// scene keeps updating.
  void renderPanel(const CameraState& state);
  /// Renders the images of the states at the indices `wanted`, in that order. Unchanged ones are
  /// not rendered again. The newest request wins.
  void renderStates(const std::vector<CameraState>& states, std::vector<std::size_t> wanted);

 Q_SIGNALS:
  void panelRendered(const hogelscope::VtkImage& image);
  /// Emitted after each setScene(); null if the light field is not a mesh.
  void meshMade(const hogelscope::VtkMesh& mesh);
  void stateRendered(int index, const hogelscope::VtkImage& image);

 private:
  void serve(LatestWins::Lock& lock);
  bool switchScene();
  void makeMesh();
  void renderNextState();
  [[nodiscard]] std::optional<std::size_t> nextState() const;
  [[nodiscard]] bool hasWork() const;
  [[nodiscard]] bool mustStop();

  // The requests, which m_thread guards.
  std::optional<ViewSource> m_newScene;
  bool m_isSceneNew = false;
  int m_asked = 0;  ///< the number of the latest setScene()
  std::optional<CameraState> m_panel;
  std::vector<CameraState> m_states;
  std::vector<std::optional<CameraState>> m_done;  ///< as rendered last
  std::vector<std::size_t> m_wanted;               ///< indices of m_states

  std::optional<ViewSource> m_scene;  ///< used by the thread only, as is the next
  int m_number = 0;                   ///< the number of the setScene() that is served
  std::weak_ptr<const LightFieldSource> m_meshOf;
  VtkMesh m_mesh;
  vtkNew<vtkHogelViewFilter> m_filter;
  LatestWins m_thread;
};

}  // namespace hogelscope
