// SPDX-License-Identifier: BSD-3-Clause
// The menu View ▸ Colours: system, light or dark; saved in the settings. The icons, which follow
// the colours.
#pragma once

#include <QObject>

class QMenu;

namespace hogelscope {

/// Sets the colour scheme as a palette of the Fusion style, because Qt 6.4 has no colour schemes.
class Colours : public QObject {
  Q_OBJECT

 public:
  /// Fills the menu and applies the scheme that was chosen last.
  Colours(QMenu* menu, QObject* parent);

 private:
  enum class Scheme { system, light, dark };
  void apply(Scheme scheme);
};

/// Sets the icons of the tool bar's actions, which `window` has, and of the application.
void addIcons(const QObject& window);

}  // namespace hogelscope
