// SPDX-License-Identifier: BSD-3-Clause
// Event filters for fields: typing keeps its keys, and the wheel edits only a field that has
// focus. The field of a part of the window that had the focus last.
#pragma once

class QObject;
class QWidget;

namespace hogelscope {

/// Filters the events of the whole application while `owner` exists. Line edits and spin boxes keep
/// printable keys by themselves, but combo boxes do not, and line edits keep Ctrl+Z even with
/// nothing to undo. Spin boxes and combo boxes use the wheel only while they have the focus, which
/// the wheel does not give them; otherwise it scrolls their surroundings. A form's numbers never
/// use it.
void guardFields(QObject* owner);

/// Moves the focus into `part`: to the field that had it last, else to its first one. Does nothing
/// in a part without fields.
void focusLastField(QWidget* part);

}  // namespace hogelscope
