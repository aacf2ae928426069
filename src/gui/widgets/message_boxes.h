// SPDX-License-Identifier: BSD-3-Clause
// The program's modal message boxes. Each function shows one and waits for its answer.
#pragma once

#include <QDateTime>
#include <QString>

class QWidget;

namespace hogelscope {

enum class Unsaved { save, discard, cancel };
/// Asks before edits of `name` would be lost. Escape cancels.
Unsaved askUnsaved(QWidget* window, const QString& name);

enum class Recovery { recover, discard, later };
/// Asks about edits of `document`, dated `time`, that a crash left behind. Escape means later.
Recovery askRecovery(QWidget* window, const QString& document, const QDateTime& time);

void showAbout(QWidget* window);

}  // namespace hogelscope
