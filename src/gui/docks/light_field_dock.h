// SPDX-License-Identifier: BSD-3-Clause
// The light field dock: the file and its layout, or a live scene and its parameters; its contents.
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "io/scene/view_source.h"

class QCheckBox;
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

  /// Sets the light field in memory; none while it is read or if it cannot be read.
  void setSource(const std::optional<ViewSource>& source);
  /// Sets another file or folder for the session. The layout changes to one that the file can have.
  /// A mesh is set after it has been read, with a display that fits it.
  void choose(const QString& file);

 Q_SIGNALS:
  /// A source or a mesh has been rejected; the session is unchanged.
  void failed(const QString& line);
  /// Content that makes up for the display's leakage is asked for.
  void optimiseAsked();

 private:
  ParameterForm* form(void (*visit)(ParameterVisitor&, LightFieldParams&));
  void showForms();
  void setWeave(bool isAnother);
  void chooseMesh(const QString& file);
  void chooseViews(const LightFieldParams& views);
  void askFile();
  void askFolder();

  SessionModel* m_model;
  QLabel* m_contents;
  ParameterForm* m_file = nullptr;
  QCheckBox* m_hasWeave;                  ///< LightFieldParams::calibration is given
  ParameterForm* m_weave = nullptr;       ///< its figures
  Task* m_task;                           ///< reads a mesh or the order of views
  std::array<QWidget*, 2> m_liveForms{};  ///< the content's own parameters, and the common ones
};

}  // namespace hogelscope
