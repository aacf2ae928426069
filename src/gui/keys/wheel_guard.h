// SPDX-License-Identifier: BSD-3-Clause
// Keeps the wheel, which scrolls a dock, from changing the field that happens to be under it.
#pragma once

#include <QObject>

namespace hogelscope {

/// Spin boxes, sliders and boxes of choices take the wheel only while they have the focus, which
/// the wheel does not give them; else it goes on to what is around them. Watches the whole
/// application.
class WheelGuard : public QObject {
  Q_OBJECT

 public:
  explicit WheelGuard(QObject* parent);

  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace hogelscope
