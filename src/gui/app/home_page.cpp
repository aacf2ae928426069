// SPDX-License-Identifier: BSD-3-Clause
#include "gui/app/home_page.h"

#include <QAbstractButton>
#include <QAction>
#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>

#include "gui/files/recent_files.h"
#include "gui/session/library_menu.h"
#include "gui/widgets/colours.h"
#include "ui_home_page.h"

namespace hogelscope {

namespace {

/// Paints a picture that fills `area`, cut at its longer side.
void paintFilling(QPainter& painter, const QRect& area, const QImage& image) {
  if (image.isNull()) return;
  const QSize part = QSize(area.size()).scaled(image.size(), Qt::KeepAspectRatio);
  QRect from({}, part);
  from.moveCenter(image.rect().center());
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(area, image, from);
}

/// A picture with a title and a line below it.
class Card : public QAbstractButton {
 public:
  Card(const QString& title, QString line, const QString& picture, bool isLarge)
      : m_line(std::move(line)), m_picture(picture), m_isLarge(isLarge) {
    setText(title);
    setAccessibleDescription(m_line);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
  }
  [[nodiscard]] QSize sizeHint() const override {
    return m_isLarge ? QSize(scaled(440), scaled(280 + footHeight))
                     : QSize(scaled(220), scaled(108 + footHeight));
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Tokens& t = tokens();
    const int foot = scaled(footHeight);
    QPainterPath frame;
    frame.addRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);
    painter.setClipPath(frame);
    painter.fillRect(rect(), underMouse() ? t.hover : t.raised);
    paintFilling(painter, rect().adjusted(0, 0, 0, -foot), m_picture);
    painter.setClipping(false);
    const QRect texts(scaled(12), height() - foot, width() - scaled(24), foot);
    writeLine(painter, texts.adjusted(0, scaled(6), 0, 0), Qt::AlignTop, text(),
              textFont(TextSize::title, QFont::DemiBold), t.text);
    writeLine(painter, texts.adjusted(0, 0, 0, -scaled(8)), Qt::AlignBottom, m_line,
              textFont(TextSize::base), t.text2);
    painter.setPen(hasFocus() ? QPen(t.focus, 2) : QPen(t.strongLine, 1));
    painter.drawPath(frame);
  }

 private:
  static constexpr int footHeight = 52;

  QString m_line;
  QImage m_picture;
  bool m_isLarge;
};

/// A row of a list: an icon or a picture, a title with a note, and a key or a date at the right.
class Row : public QAbstractButton {
 public:
  Row(const QString& title, QString note, QString right, bool isKey)
      : m_note(std::move(note)), m_right(std::move(right)), m_isKey(isKey) {
    setText(title);
    setAccessibleDescription(m_note);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  }
  void setPicture(const QString& file) { m_picture = QImage(file); }
  [[nodiscard]] QSize sizeHint() const override { return {scaled(320), scaled(m_isKey ? 36 : 48)}; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Tokens& t = tokens();
    if (underMouse() || hasFocus()) {
      painter.setPen(hasFocus() ? QPen(t.focus, 2) : QPen(t.raised, 1));
      painter.setBrush(t.raised);
      painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
    }
    int left = scaled(12);
    if (m_isKey) {
      const int size = scaled(16);
      icon().paint(&painter, left, (height() - size) / 2, size, size);
      left += scaled(26);
    } else {
      const QRect place(left, scaled(4), scaled(56), height() - scaled(8));
      painter.fillRect(place, t.field);
      paintFilling(painter, place, m_picture);
      left += scaled(68);
    }
    const QRect all(left, 0, paintRight(painter) - left, height());
    const QRect title = writeLine(painter, m_isKey ? all : all.adjusted(0, scaled(4), 0, 0),
                                  m_isKey ? Qt::AlignVCenter : Qt::AlignTop, text(),
                                  textFont(TextSize::base, QFont::Medium), t.text, Qt::ElideMiddle);
    const QRect notes = m_isKey ? all.adjusted(title.width() + scaled(12), 0, 0, 0)
                                : all.adjusted(0, 0, 0, -scaled(6));
    writeLine(painter, notes, m_isKey ? Qt::AlignVCenter : Qt::AlignBottom, m_note,
              textFont(TextSize::caption), t.text2, Qt::ElideMiddle);
  }

 private:
  /// Paints the key in a frame, or the date. Returns where it begins.
  int paintRight(QPainter& painter) const {
    const Tokens& t = tokens();
    const QRect written =
        writeLine(painter, rect().adjusted(0, 0, -scaled(15), 0), Qt::AlignVCenter | Qt::AlignRight,
                  m_right, textFont(TextSize::caption), t.text3);
    const QRectF frame(written.left() - scaled(5), (height() - scaled(20)) / 2,
                       written.width() + scaled(10), scaled(20));
    if (m_isKey && !m_right.isEmpty()) {
      painter.setPen(t.strongLine);
      painter.setBrush(Qt::NoBrush);
      painter.drawRoundedRect(frame.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    }
    return int(frame.left()) - scaled(8);
  }

  QString m_note;
  QString m_right;
  bool m_isKey;
  QImage m_picture;
};

QString keyOf(const QAction* action) {
  return action->shortcut().toString(QKeySequence::NativeText);
}

/// Makes the button trigger a command.
QAbstractButton* commandButton(const QAction* action, QAbstractButton* button) {
  button->setToolTip(action->toolTip());
  QObject::connect(button, &QAbstractButton::clicked, action, &QAction::trigger);
  return button;
}

/// Returns a time in short: with the hour today, else the day.
QString dayOf(const QDateTime& when) {
  const qint64 days = when.date().daysTo(QDate::currentDate());
  if (days == 0) return HomePage::tr("today %1").arg(when.toString("HH:mm"));
  return days == 1 ? HomePage::tr("yesterday") : QLocale().toString(when.date(), "d MMM");
}

}  // namespace

HomePage::HomePage(QWidget* parent) : QScrollArea(parent), m_ui(std::make_unique<Ui::HomePage>()) {
  m_ui->setupUi(this);
  m_ui->page->setMaximumWidth(scaled(1000));  // even in a large window
  const int side = scaled(44);
  m_ui->sign->setPixmap(QIcon(":/desktop/io.github.hogelscope.Hogelscope.svg").pixmap(side, side));
  addSample("room", tr("The room"), tr("A live scene on a 0.5 m display: drag the eye"), 0, 0, 2);
  addSample("table1", tr("Table I"), tr("Six cameras of the paper"), 0, 1);
  addSample("arc", tr("Arc of nine eyes"), tr("One room, walked past"), 0, 2);
  addSample("as_built", tr("As built"), tr("Turned, uneven lenses"), 1, 1);
  addSample("displays/looking_glass_portrait_sheet", tr("Lens sheet"),
            tr("A slanted sheet over sub-pixels"), 1, 2);
}

HomePage::~HomePage() = default;

/// A sample of two rows is large.
void HomePage::addSample(const QString& name, const QString& title, const QString& line, int row,
                         int column, int rows) {
  const QString file = sampleFile(name);
  if (file.isEmpty()) return;
  const QString id = name.section('/', -1);
  auto* card = new Card(title, line, ":/home/" + id + ".png", rows > 1);
  card->setObjectName(id + "Sample");
  m_ui->samplesLayout->addWidget(fileButton(file, card), row, column, rows, 1);
}

void HomePage::addCommands(const QWidget& window) {
  struct Begin {
    const char* command;
    const char* image;
    QString note = {};
  };
  for (const Begin& begin :
       {Begin{"openLightFieldAction", "picture", tr("hogels, quilt, lenslets, mesh")},
        Begin{"openFolderAction", "folder", tr("sub-aperture pictures")},
        Begin{"openAction", "open"},
        Begin{"newAction", "new", tr("a display around a test scene")}}) {
    const auto* action = window.findChild<QAction*>(begin.command);
    auto* row = new Row(action->text().remove('&'), begin.note, keyOf(action), true);
    row->setIcon(icon(begin.image));
    row->setObjectName(action->objectName() + "Button");
    m_ui->rowsLayout->addWidget(commandButton(action, row));
  }
  for (const char* command : {"manualAction", "keysAction", "darkColours", "lightColours"}) {
    const auto* action = window.findChild<QAction*>(command);
    auto* button = new QToolButton;
    button->setText(action->text().remove('&') + "  " + keyOf(action));
    m_ui->linksLayout->addWidget(commandButton(action, button));
  }
  m_ui->linksLayout->addStretch();
}

QWidget* HomePage::fileButton(const QString& file, QAbstractButton* button) {
  button->setToolTip(file);
  connect(button, &QAbstractButton::clicked, this, [this, file] { Q_EMIT chosen(file); });
  return button;
}

void HomePage::showEvent(QShowEvent* event) {
  fillRecent();
  if (auto* room = findChild<QWidget*>("roomSample")) room->setFocus();  // a key opens it
  QScrollArea::showEvent(event);
}

void HomePage::fillRecent() {
  while (QLayoutItem* item = m_ui->recentLayout->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  constexpr int most = 4;  // the menu lists all of them
  for (const RecentFile& recent : RecentFiles::list()) {
    if (m_ui->recentLayout->count() == most) break;
    const QFileInfo info(recent.file);
    const QString note = recent.what.isEmpty() ? info.path() : recent.what + " · " + info.path();
    auto* row = new Row(info.fileName(), note, dayOf(recent.when), false);
    row->setPicture(recent.thumbnail);
    row->setObjectName("recentSession");
    m_ui->recentLayout->addWidget(fileButton(recent.file, row));
  }
  if (m_ui->recentLayout->count() == 0) m_ui->recentLayout->addWidget(new QLabel(tr("None yet")));
}

}  // namespace hogelscope
