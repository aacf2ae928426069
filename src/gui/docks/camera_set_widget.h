// SPDX-License-Identifier: BSD-3-Clause
// The camera set dock: many states for the session at once.
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
  /// A user's distribution (JSON) or a viewer's trace (CSV). True if its states were added.
  bool addFromFile(const QString& file);

 Q_SIGNALS:
  void failed(const QString& line);
  /// The states that would be added; none where the widget is hidden, or they have been.
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
  std::vector<CameraState> m_preview;  ///< as it was told
  QComboBox* m_templates;              ///< the current state, then all by name
  QPushButton* m_addButton;
  QPushButton* m_fileButton;
};

}  // namespace hogelscope
