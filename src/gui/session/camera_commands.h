// SPDX-License-Identifier: BSD-3-Clause
// The Camera menu: moves and rotates the current state's camera, changes its leakage, switches lens
// and leakage off and on, and selects other states.
#pragma once

#include <QMenu>
#include <QObject>
#include <functional>
#include <map>
#include <vector>

#include "core/optics/camera.h"
#include "core/optics/session.h"

namespace hogelscope {

class SessionModel;

class CameraCommands : public QObject {
  Q_OBJECT

 public:
  CameraCommands(QMenu* menu, SessionModel* model, QObject* parent);

 Q_SIGNALS:
  void failed(const QString& line);

 private:
  struct MotionCommand;
  /// Values before they were switched off, by the states' names.
  template <class Value>
  using Kept = std::map<std::string, Value>;

  static std::vector<MotionCommand> motions();
  template <class Action>
  void add(QMenu* menu, const QString& name, const QString& title, const QString& help,
           const QKeySequence& key, Action action);
  void addMotions(QMenu* menu, int factor);
  void addPsfSteps();
  void addSwitches();
  void addStates();
  void edit(const QString& name, const std::function<void(CameraState&)>& action);
  void facePanel();
  void stepSigma(int steps);
  void stepWindow(int steps);
  /// Toggles between `off` and the kept value.
  template <class Value>
  void toggle(const QString& part, Value& (*in)(CameraState&), const Value& off, Kept<Value>& kept);

  QMenu* m_menu;
  SessionModel* m_model;
  Kept<DistortionParams> m_lenses;
  Kept<int> m_windows;
};

}  // namespace hogelscope
