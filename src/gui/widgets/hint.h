// SPDX-License-Identifier: BSD-3-Clause
// A hint over a view, until the view is used for the first time.
#pragma once

#include <QLabel>

namespace hogelscope {

class Hint : public QLabel {
  Q_OBJECT

 public:
  /// Creates a hidden hint at the bottom of `view`. The first click into the view fades it out;
  /// settings remember that by its object name, `name`.
  Hint(const char* name, const QString& text, QWidget* view);

  /// Shows the hint unless its view has been used before.
  void offer();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
  void fade();
};

}  // namespace hogelscope
