// SPDX-License-Identifier: BSD-3-Clause
// View ▸ Colours: the system's, light or dark; kept in the settings.
#pragma once

#include <QObject>

class QMenu;

namespace hogelscope {

/// Qt 6.4 has no colour schemes of its own: a scheme is a palette of the Fusion style.
class Colours : public QObject {
  Q_OBJECT

 public:
  /// Fills the menu and applies what was chosen last.
  Colours(QMenu* menu, QObject* parent);

 private:
  enum class Scheme { system, light, dark };
  void apply(Scheme scheme);
};

}  // namespace hogelscope
