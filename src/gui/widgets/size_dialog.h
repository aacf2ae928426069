// SPDX-License-Identifier: BSD-3-Clause
// Asks how many pixels a picture is to have.
#pragma once

#include <QDialog>

class QFormLayout;
class QSpinBox;

namespace hogelscope {

class SizeDialog : public QDialog {
  Q_OBJECT

 public:
  /// The shape is that of `proposed`.
  SizeDialog(const QString& title, const QSize& proposed, QWidget* parent);

  /// At least one pixel each way.
  [[nodiscard]] QSize size() const;

 protected:
  /// For further rows.
  [[nodiscard]] QFormLayout* form() const { return m_form; }

 private:
  QSize m_proposed;
  QFormLayout* m_form;
  QSpinBox* m_width;
};

}  // namespace hogelscope
