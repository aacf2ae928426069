// SPDX-License-Identifier: BSD-3-Clause
// The camera set dock: many states for the session at once.
#pragma once

#include <QWidget>

#include "core/cameras/camera_set.h"

class QLabel;
class QPushButton;

namespace hogelscope {

class SessionModel;

class CameraSetWidget : public QWidget {
  Q_OBJECT

 public:
  explicit CameraSetWidget(QWidget* parent = nullptr);

  void setModel(SessionModel* model);
  /// A user's distribution (JSON) or a viewer's trace (CSV). True if its states were added.
  bool addFromFile(const QString& file);

 Q_SIGNALS:
  void failed(const QString& line);

 private:
  void askFile();
  bool add(const std::function<CameraSet()>& set);

  CameraSetParams m_params;
  CameraRegionParams m_region;
  SessionModel* m_model = nullptr;
  QPushButton* m_addButton;
  QPushButton* m_fileButton;
};

}  // namespace hogelscope
