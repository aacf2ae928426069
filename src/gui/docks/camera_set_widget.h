// SPDX-License-Identifier: BSD-3-Clause
// The camera set dock, which adds many states to the session at once.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "core/cameras/camera_set.h"

namespace Ui {
class CameraSetWidget;
}

namespace hogelscope {

class SessionModel;

class CameraSetWidget : public QWidget {
  Q_OBJECT

 public:
  explicit CameraSetWidget(QWidget* parent = nullptr);
  ~CameraSetWidget() override;

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
  void showTemplates();
  [[nodiscard]] QString currentText() const;
  [[nodiscard]] CameraSet currentSet() const;
  void showPreview();
  void setPreview(const std::vector<CameraState>& states);
  void askFile();
  bool add(const std::function<CameraSet()>& set);

  std::unique_ptr<Ui::CameraSetWidget> m_ui;  ///< templateBox: the current state, then all by name
  CameraSetParams m_params;
  CameraRegionParams m_region;
  SessionModel* m_model = nullptr;
  std::vector<CameraState> m_preview;  ///< as last emitted
};

}  // namespace hogelscope
