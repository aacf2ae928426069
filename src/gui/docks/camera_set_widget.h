// SPDX-License-Identifier: BSD-3-Clause
// The camera set dock, which adds many states to the session at once.
#pragma once

#include <QWidget>
#include <vector>

#include "core/cameras/camera_set.h"

class QComboBox;
class QPushButton;

namespace hogelscope {

class SessionModel;

class CameraSetWidget : public QWidget {
  Q_OBJECT

 public:
  explicit CameraSetWidget(QWidget* parent = nullptr);

  void setModel(SessionModel* model);
  /// Adds states of a distribution (JSON) or a viewer's trace (CSV). Returns true if they were
  /// added.
  bool addFromFile(const QString& file);

 Q_SIGNALS:
  void failed(const QString& line);
  /// Passes the states that would be added; empty if the widget is hidden or they have been added.
  void previewChanged(const std::vector<hogelscope::CameraState>& states);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  template <class Params>
  QWidget* form(Params& params);
  QWidget* makeTemplates();
  void showTemplates();
  [[nodiscard]] QString currentText() const;
  [[nodiscard]] CameraSet currentSet() const;
  void showPreview();
  void setPreview(const std::vector<CameraState>& states);
  void askFile();
  bool add(const std::function<CameraSet()>& set);

  CameraSetParams m_params;
  CameraRegionParams m_region;
  SessionModel* m_model = nullptr;
  std::vector<CameraState> m_preview;  ///< as last emitted
  QComboBox* m_templates;              ///< the current state, then all states by name
  QPushButton* m_addButton;
  QPushButton* m_fileButton;
};

}  // namespace hogelscope
