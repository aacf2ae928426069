// SPDX-License-Identifier: BSD-3-Clause
// Keeps single-key shortcuts out of fields, and lets undo through if a field has nothing to undo.
#pragma once

#include <QObject>

namespace hogelscope {

/// Filters the key events of the whole application. Line edits and spin boxes keep printable keys
/// by themselves, but combo boxes do not, and line edits keep Ctrl+Z even with nothing to undo.
class TypingGuard : public QObject {
  Q_OBJECT

 public:
  explicit TypingGuard(QObject* parent);

  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace hogelscope
