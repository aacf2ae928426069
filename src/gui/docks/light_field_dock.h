// SPDX-License-Identifier: BSD-3-Clause
// The light field dock: the file and how it is laid out, what it holds, and how views sample it.
#pragma once

#include <QWidget>
#include <optional>

#include "io/scene/scene.h"

class QLabel;

namespace hogelscope {

class SessionModel;

class LightFieldDock : public QWidget {
  Q_OBJECT

 public:
  explicit LightFieldDock(SessionModel* model, QWidget* parent = nullptr);

  /// What is in memory; none while it is read or where it cannot be read.
  void setScene(const std::optional<Scene>& scene);
  /// Another file or folder for the session. Its layout becomes one that such a thing can have.
  void choose(const QString& file);

 private:
  void askFile();
  void askFolder();

  SessionModel* m_model;
  QLabel* m_contents;
};

}  // namespace hogelscope
