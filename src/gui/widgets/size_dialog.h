// SPDX-License-Identifier: BSD-3-Clause
// Dialog of the size of an image in pixels.
#pragma once

#include <QDialog>

class QFormLayout;
class QSpinBox;

namespace hogelscope {

class SizeDialog : public QDialog {
  Q_OBJECT

 public:
  /// Keeps the aspect ratio of `proposed`.
  SizeDialog(const QString& title, const QSize& proposed, QWidget* parent);

  /// Returns the size, at least one pixel each way.
  [[nodiscard]] QSize size() const;

 protected:
  /// The layout, for further rows.
  [[nodiscard]] QFormLayout* form() const { return m_form; }

 private:
  QSize m_proposed;
  QFormLayout* m_form;
  QSpinBox* m_width;
};

}  // namespace hogelscope
