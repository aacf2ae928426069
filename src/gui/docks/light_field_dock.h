// SPDX-License-Identifier: BSD-3-Clause
// The light field dock: the file and how it is laid out, or a live scene and its parameters; what
// it holds, and how views sample it.
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "io/scene/scene.h"

class QLabel;

namespace hogelscope {

class ParameterForm;
class ParameterVisitor;
class SessionModel;
class Task;

class LightFieldDock : public QWidget {
  Q_OBJECT

 public:
  explicit LightFieldDock(SessionModel* model, QWidget* parent = nullptr);

  /// What is in memory; none while it is read or where it cannot be read.
  void setScene(const std::optional<Scene>& scene);
  /// Another file or folder for the session. Its layout becomes one that such a thing can have; a
  /// mesh comes with a display that fits it, when it has been read.
  void choose(const QString& file);

 Q_SIGNALS:
  /// A source or a mesh cannot be used, and nothing changes.
  void failed(const QString& line);

 private:
  ParameterForm* form(void (*visit)(ParameterVisitor&, LightFieldParams&));
  void showForms();
  void chooseMesh(const QString& file);
  void chooseViews(const LightFieldParams& views);
  void askFile();
  void askFolder();

  SessionModel* m_model;
  QLabel* m_contents;
  Task* m_task;                           ///< reads a mesh
  std::array<QWidget*, 2> m_liveForms{};  ///< the content's own parameters, and all content's
};

}  // namespace hogelscope
