// SPDX-License-Identifier: BSD-3-Clause
#include "gui/app/colours.h"

#include <QActionGroup>
#include <QApplication>
#include <QIcon>
#include <QMenu>
#include <QPalette>
#include <QSettings>

#include "ui_main_window.h"

namespace hogelscope {

namespace {

/// The base colours of a scheme. Qt derives the shades from them; `alternate` is every second row.
struct Shades {
  QColor window, text, base, alternate, button, link, highlight;
};

QPalette paletteOf(const Shades& shades) {
  QPalette palette(shades.button, shades.window);
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
    palette.setColor(role, shades.text);
  palette.setColor(QPalette::Base, shades.base);
  palette.setColor(QPalette::AlternateBase, shades.alternate);
  palette.setColor(QPalette::ToolTipBase, shades.alternate);
  palette.setColor(QPalette::Link, shades.link);
  palette.setColor(QPalette::LinkVisited, shades.link);
  palette.setColor(QPalette::Highlight, shades.highlight);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::PlaceholderText, QColor(128, 128, 128));
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, QColor(128, 128, 128));
  return palette;
}

QPalette lightPalette() {
  return paletteOf({{239, 239, 239},
                    Qt::black,
                    Qt::white,
                    {247, 247, 247},
                    {239, 239, 239},
                    {0, 87, 174},
                    {48, 140, 198}});
}

QPalette darkPalette() {
  return paletteOf({{45, 47, 51},
                    {230, 230, 230},
                    {30, 31, 34},
                    {39, 41, 45},
                    {58, 61, 66},
                    {120, 180, 255},
                    {38, 108, 166}});
}

}  // namespace

Colours::Colours(QMenu* menu, QObject* parent) : QObject(parent) {
  const auto last = Scheme(QSettings().value("colours", 0).toInt());
  auto* group = new QActionGroup(this);
  const auto add = [&](const QString& title, const QString& tip, Scheme scheme) {
    QAction* action = menu->addAction(title);
    action->setToolTip(tip);
    action->setCheckable(true);
    action->setChecked(scheme == last);
    action->setShortcut(Qt::CTRL | Qt::ALT | Qt::Key(Qt::Key_7 + int(scheme)));
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, scheme] {
      QSettings().setValue("colours", int(scheme));
      apply(scheme);
    });
    return action;
  };
  menu->setToolTipsVisible(true);
  add(tr("&System"), tr("As the desktop's other programs"), Scheme::system)
      ->setObjectName("systemColours");
  add(tr("&Light"), tr("Dark text on a light window"), Scheme::light)
      ->setObjectName("lightColours");
  add(tr("&Dark"), tr("Light text on a dark window"), Scheme::dark)->setObjectName("darkColours");
  apply(last);
}

void Colours::apply(Scheme scheme) {
  if (scheme != Scheme::system) QApplication::setStyle("Fusion");
  if (scheme == Scheme::light) return QApplication::setPalette(lightPalette());
  if (scheme == Scheme::dark) return QApplication::setPalette(darkPalette());
  QApplication::setPalette(QPalette());
}

void addIcons(const Ui::MainWindow& ui) {
  QApplication::setWindowIcon(QIcon(":/icons/io.github.hogelscope.Hogelscope.svg"));
  for (const auto& [action, name] :
       {std::pair(ui.newAction, "new"), std::pair(ui.openAction, "open"),
        std::pair(ui.saveAction, "save"), std::pair(ui.fitAction, "fit"),
        std::pair(ui.savePictureAction, "save_picture"), std::pair(ui.copyPictureAction, "copy")})
    action->setIcon(QIcon(QString(":/icons/%1.svg").arg(name)));
}

}  // namespace hogelscope
