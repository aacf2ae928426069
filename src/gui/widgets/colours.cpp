// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/colours.h"

#include <QActionGroup>
#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QProxyStyle>
#include <QSettings>
#include <QSvgRenderer>
#include <algorithm>
#include <cmath>

#include "gui/widgets/command.h"

namespace hogelscope {

namespace {

enum class Scheme { system, light, dark };

const Tokens dark{
    .window = 0x222428,
    .canvas = 0x18191b,
    .field = 0x191a1d,
    .raised = 0x2d3035,
    .hover = 0x34373d,
    .line = 0x33363b,
    .strongLine = 0x484c53,
    .text = 0xe6e8eb,
    .text2 = 0xa4a9b2,
    .text3 = 0x8a909a,
    .focus = 0x4c9bff,
    .primary = 0x2872d4,
    .selection = 0x263f63,
    .selectionText = 0xe6e8eb,
    .eye = 0xff9d2e,
    .good = 0x3fb895,
    .amber = 0xe5c04b,
    .error = 0xff6f61,
    .axes = {0xf0776c, 0x6fc276, 0x5aa5ff},
    .series = {0x56b4e9, 0xe69f00, 0x2fb890, 0xcc79a7},
    .grid = 0x2a2c30,
};

const Tokens light{
    .window = 0xf4f5f6,
    .canvas = 0xdcdee1,
    .field = 0xffffff,
    .raised = 0xe9ebed,
    .hover = 0xdfe2e5,
    .line = 0xd4d7db,
    .strongLine = 0xb4b9c0,
    .text = 0x1c1f23,
    .text2 = 0x565c65,
    .text3 = 0x6a7079,
    .focus = 0x0b66d8,
    .primary = 0x0b66d8,
    .selection = 0xcfe2fb,
    .selectionText = 0x1c1f23,
    .eye = 0xb85f00,
    .good = 0x0b7f5f,
    .amber = 0x8f6a00,
    .error = 0xc62f22,
    .axes = {0xc0392b, 0x2e7d32, 0x1d5fc4},
    .series = {0x0072b2, 0xc46f00, 0x007f5f, 0xa8457f},
    .grid = 0xe4e6e9,
};

const Tokens* current = &dark;
int textScale = 100;  ///< percent

QPalette paletteOf(const Tokens& t) {
  QPalette palette(t.raised, t.window);
  using Role = QPalette::ColorRole;
  for (const auto& [role, colour] :
       {std::pair(QPalette::Window, t.window), std::pair(QPalette::Base, t.field),
        std::pair(QPalette::AlternateBase, t.window), std::pair(QPalette::Button, t.raised),
        std::pair(QPalette::ToolTipBase, t.raised), std::pair(QPalette::Midlight, t.hover),
        std::pair(QPalette::Mid, t.line), std::pair(QPalette::Dark, t.strongLine),
        std::pair(QPalette::PlaceholderText, t.text3), std::pair(QPalette::Link, t.focus),
        std::pair(QPalette::LinkVisited, t.focus), std::pair(QPalette::Highlight, t.selection),
        std::pair(QPalette::HighlightedText, t.selectionText)})
    palette.setColor(role, colour);
  for (const Role role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
    palette.setColor(role, t.text);
    palette.setColor(QPalette::Disabled, role, t.text3);
  }
  return palette;
}

/// Returns the style sheet, whose @names are replaced by the tokens.
QString styleSheetOf(const Tokens& t) {
  QFile file(":/style/window.qss");
  if (!file.open(QIODevice::ReadOnly)) return {};
  QString sheet = QString::fromUtf8(file.readAll());
  for (const auto& [name, colour] :
       {std::pair("@window", t.window), std::pair("@canvas", t.canvas),
        std::pair("@field", t.field), std::pair("@raised", t.raised), std::pair("@hover", t.hover),
        std::pair("@line", t.line), std::pair("@strongLine", t.strongLine),
        std::pair("@text2", t.text2), std::pair("@text3", t.text3), std::pair("@text", t.text),
        std::pair("@focus", t.focus), std::pair("@primary", t.primary),
        std::pair("@selectionText", t.selectionText), std::pair("@selection", t.selection)})
    sheet.replace(QString(name) + ';', colour.name() + ';');
  for (const int pixels : {4, 8, 11, 12, 13, 15, 16, 22, 34})
    sheet.replace(QString("@%1px").arg(pixels), QString("%1px").arg(scaled(pixels)));
  return sheet;
}

bool isDark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128;
}

/// Paints an SVG whose lines are `currentColor`.
class SvgIcon : public QIconEngine {
 public:
  explicit SvgIcon(const QString& file) : m_file(file) {
    QFile source(file);
    if (source.open(QIODevice::ReadOnly)) m_svg = source.readAll();
  }

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const QSize pixels = rect.size() * painter->device()->devicePixelRatio();
    painter->drawPixmap(rect, pixmap(pixels, mode, state));
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State /*state*/) override {
    const Tokens& t = tokens();
    const QColor ink = mode == QIcon::Disabled ? t.text3 : mode == QIcon::Active ? t.text : t.text2;
    const QString key =
        QString("%1 %2 %3 %4").arg(m_file, ink.name()).arg(size.width()).arg(size.height());
    QPixmap pixmap;
    if (QPixmapCache::find(key, &pixmap)) return pixmap;
    pixmap = QPixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    QSvgRenderer(QByteArray(m_svg).replace("currentColor", ink.name().toLatin1()))
        .render(&painter, QRectF({}, size));
    QPixmapCache::insert(key, pixmap);
    return pixmap;
  }
  [[nodiscard]] QIconEngine* clone() const override { return new SvgIcon(m_file); }
  bool isNull() override { return m_svg.isEmpty(); }

 private:
  QString m_file;
  QByteArray m_svg;
};

/// Fusion with our icons on the title bars of docks, whose own are black.
class Style : public QProxyStyle {
 public:
  Style() : QProxyStyle("Fusion") {}

  [[nodiscard]] QIcon standardIcon(StandardPixmap which, const QStyleOption* option,
                                   const QWidget* widget) const override {
    if (which == SP_TitleBarCloseButton) return hogelscope::icon("close");
    if (which == SP_TitleBarNormalButton) return hogelscope::icon("undock");
    return QProxyStyle::standardIcon(which, option, widget);
  }
  [[nodiscard]] int styleHint(StyleHint which, const QStyleOption* option, const QWidget* widget,
                              QStyleHintReturn* more) const override {
    if (which == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
    return QProxyStyle::styleHint(which, option, widget, more);
  }
};

/// The style sheet is of the windows, not of the application: Qt styles each widget of an
/// application's sheet once for each of its ancestors.
void apply() {
  QApplication::setFont(textFont(TextSize::base));
  QApplication::setPalette(paletteOf(*current));
  const QString sheet = styleSheetOf(*current);
  for (QWidget* window : QApplication::topLevelWidgets())
    if (window->parentWidget() == nullptr) window->setStyleSheet(sheet);
}

/// Also applies the saved scheme.
void addSchemes(QMenu* menu) {
  const auto saved = Scheme(QSettings().value("colours", int(Scheme::dark)).toInt());
  const auto use = [isSystemDark = isDark(QApplication::palette())](Scheme scheme) {
    const bool becomesDark = scheme == Scheme::system ? isSystemDark : scheme == Scheme::dark;
    current = becomesDark ? &dark : &light;
    apply();
  };
  auto* group = new QActionGroup(menu);
  const auto add = [&](const char* name, const QString& title, const QString& help, Scheme scheme) {
    const QKeyCombination key = Qt::CTRL | Qt::ALT | Qt::Key(Qt::Key_7 + int(scheme));
    QAction* action = addCommand(menu, {name, title, help, key}, menu, [use, scheme] {
      QSettings().setValue("colours", int(scheme));
      use(scheme);
    });
    action->setCheckable(true);
    action->setChecked(scheme == saved);
    group->addAction(action);
  };
  add("systemColours", QObject::tr("&System"),
      QObject::tr("Light or dark, as the desktop's other programs"), Scheme::system);
  add("lightColours", QObject::tr("&Light"), QObject::tr("Dark text on a light window"),
      Scheme::light);
  add("darkColours", QObject::tr("&Dark"), QObject::tr("Light text on a dark window"),
      Scheme::dark);
  use(saved);
}

void addSizes(QMenu* menu) {
  const auto use = [](int scale) {
    textScale = std::clamp(scale, 80, 200);
    QSettings().setValue("textScale", textScale);
    apply();
  };
  constexpr int step = 10;  // percent
  addCommand(
      menu,
      {"largerTextAction", QObject::tr("&Larger"),
       QObject::tr("Makes all text of the window larger"), Qt::CTRL | Qt::ALT | Qt::Key_Plus},
      menu, [use] { use(textScale + step); });
  addCommand(
      menu,
      {"smallerTextAction", QObject::tr("&Smaller"),
       QObject::tr("Makes all text of the window smaller"), Qt::CTRL | Qt::ALT | Qt::Key_Minus},
      menu, [use] { use(textScale - step); });
  addCommand(
      menu,
      {"normalTextAction", QObject::tr("&Normal"),
       QObject::tr("Gives all text of the window its normal size"), Qt::CTRL | Qt::ALT | Qt::Key_0},
      menu, [use] { use(100); });
}

}  // namespace

const Tokens& tokens() {
  return *current;
}

const Tokens& lightTokens() {
  return light;
}

int scaled(int pixels) {
  return int(std::lround(pixels * textScale / 100.0));
}

QFont textFont(TextSize size, QFont::Weight weight) {
  QFont font = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
  font.setPixelSize(scaled(int(size)));
  font.setWeight(weight);
  return font;
}

QRect writeLine(QPainter& painter, const QRect& place, Qt::Alignment side, const QString& text,
                const QFont& font, const QColor& ink, Qt::TextElideMode cut) {
  painter.setFont(font);
  painter.setPen(ink);
  QRect used(side.testFlag(Qt::AlignRight) ? place.topRight() : place.topLeft(), QSize(0, 0));
  painter.drawText(place, int(side), painter.fontMetrics().elidedText(text, cut, place.width()),
                   &used);
  return used;
}

QIcon icon(const QString& name) {
  return QIcon(new SvgIcon(QString(":/icons/%1.svg").arg(name)));
}

void addLook(QMenu* colours, QMenu* sizes) {
  textScale = std::clamp(QSettings().value("textScale", 100).toInt(), 80, 200);
  addSizes(sizes);
  QApplication::setStyle(new Style);
  addSchemes(colours);
}

}  // namespace hogelscope
