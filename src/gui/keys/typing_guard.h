// SPDX-License-Identifier: BSD-3-Clause
// Keeps single-key shortcuts out of fields, and lets undo through where a field has nothing to
// undo.
#pragma once

#include <QObject>

namespace hogelscope {

/// Line edits and spin boxes keep printable keys to themselves; boxes of choices do not, and line
/// edits keep Ctrl+Z even where nothing was typed. Watches the whole application.
class TypingGuard : public QObject {
  Q_OBJECT

 public:
  explicit TypingGuard(QObject* parent);

  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace hogelscope
