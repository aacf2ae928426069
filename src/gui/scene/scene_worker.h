// SPDX-License-Identifier: BSD-3-Clause
// Makes what the 3-D scene shows on a thread of its own: the panel as the scene's eye sees it,
// small views of all states, and the mesh of a live scene.
#pragma once

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <QObject>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "gui/scene/mesh_actors.h"
#include "io/scene/scene.h"

class vtkHogelViewFilter;

namespace hogelscope {

using VtkImage = vtkSmartPointer<vtkImageData>;

/// Its signals come from the thread that the object lives in, and none that belongs to an older
/// scene comes after setScene().
class SceneWorker : public QObject {
  Q_OBJECT

 public:
  /// Of the panel where it sends no light to the eye.
  static constexpr std::array<std::uint8_t, 3> panelColour{61, 71, 92};

  explicit SceneWorker(QObject* parent = nullptr);
  ~SceneWorker() override;

  /// What the images are of; without one none are made, and the old one's memory is given back
  /// at the next stop.
  void setScene(const std::optional<Scene>& scene);
  /// Newest wins, but what is under way is finished, so that a turning scene keeps changing.
  void renderPanel(const CameraState& state);
  /// What has been rendered already is not rendered again; `first` comes first.
  void renderStates(const std::vector<CameraState>& states, std::size_t first);

 Q_SIGNALS:
  void panelRendered(const hogelscope::VtkImage& image);
  /// After each setScene(); null where the light field is no mesh.
  void meshMade(const hogelscope::VtkMesh& mesh);
  void stateRendered(int index, const hogelscope::VtkImage& image);

 private:
  void run();
  bool switchScene();
  void makeMesh();
  void renderNextState(vtkHogelViewFilter& filter);
  [[nodiscard]] std::optional<std::size_t> nextState() const;
  [[nodiscard]] bool hasWork() const;
  [[nodiscard]] bool mustStop();

  std::mutex m_mutex;  ///< guards the next ones
  std::condition_variable m_wake;
  std::optional<Scene> m_newScene;
  bool m_isSceneNew = false;
  int m_asked = 0;  ///< the number of the latest setScene()
  std::optional<CameraState> m_panel;
  std::vector<CameraState> m_states;
  std::vector<std::optional<CameraState>> m_done;  ///< as it was rendered last
  std::size_t m_first = 0;
  bool m_ends = false;

  std::optional<Scene> m_scene;  ///< the thread's own, as the next
  int m_number = 0;              ///< of its setScene()
  std::weak_ptr<const LightFieldSource> m_meshOf;
  VtkMesh m_mesh;
  std::thread m_thread;
};

}  // namespace hogelscope
