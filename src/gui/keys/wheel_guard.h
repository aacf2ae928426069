// SPDX-License-Identifier: BSD-3-Clause
// Keeps the wheel, which scrolls a dock, from changing the field under the pointer.
#pragma once

#include <QObject>

namespace hogelscope {

/// Filters the wheel events of the whole application. Spin boxes, sliders and combo boxes use the
/// wheel only while they have the focus, which the wheel does not give them; otherwise it scrolls
/// their surroundings.
class WheelGuard : public QObject {
  Q_OBJECT

 public:
  explicit WheelGuard(QObject* parent);

  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace hogelscope
