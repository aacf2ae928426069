// SPDX-License-Identifier: BSD-3-Clause
#include "gui/app/colours.h"

#include <QActionGroup>
#include <QApplication>
#include <QIcon>
#include <QMenu>
#include <QPalette>
#include <QSettings>

#include "gui/widgets/command.h"

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
  const auto add = [&](const char* name, const QString& title, const QString& help, Scheme scheme) {
    const CommandText text{name, title, help,
                           Qt::CTRL | Qt::ALT | Qt::Key(Qt::Key_7 + int(scheme))};
    QAction* action = addCommand(menu, text, this, [this, scheme] {
      QSettings().setValue("colours", int(scheme));
      apply(scheme);
    });
    action->setCheckable(true);
    action->setChecked(scheme == last);
    group->addAction(action);
  };
  add("systemColours", tr("&System"), tr("As the desktop's other programs"), Scheme::system);
  add("lightColours", tr("&Light"), tr("Dark text on a light window"), Scheme::light);
  add("darkColours", tr("&Dark"), tr("Light text on a dark window"), Scheme::dark);
  apply(last);
}

void Colours::apply(Scheme scheme) {
  if (scheme != Scheme::system) QApplication::setStyle("Fusion");
  if (scheme == Scheme::light) return QApplication::setPalette(lightPalette());
  if (scheme == Scheme::dark) return QApplication::setPalette(darkPalette());
  QApplication::setPalette(QPalette());
}

void addIcons(const QObject& window) {
  QApplication::setWindowIcon(QIcon(":/icons/io.github.hogelscope.Hogelscope.svg"));
  for (const auto& [action, name] :
       {std::pair("newAction", "new"), std::pair("openAction", "open"),
        std::pair("saveAction", "save"), std::pair("fitAction", "fit"),
        std::pair("savePictureAction", "save_picture"), std::pair("copyPictureAction", "copy")})
    window.findChild<QAction*>(action)->setIcon(QIcon(QString(":/icons/%1.svg").arg(name)));
}

}  // namespace hogelscope
