// SPDX-License-Identifier: BSD-3-Clause
// The one place that stops the user with a box: each function shows one and waits for its answer.
#pragma once

#include <QDateTime>
#include <QString>

class QWidget;

namespace hogelscope {

enum class Unsaved { save, discard, cancel };
/// Before edits of `name` would be lost. Escape is cancel.
Unsaved askUnsaved(QWidget* window, const QString& name);

enum class Recovery { recover, discard, later };
/// After a program ended without asking, with edits of `document` as of `time`. Escape is later.
Recovery askRecovery(QWidget* window, const QString& document, const QDateTime& time);

void showAbout(QWidget* window);

}  // namespace hogelscope
