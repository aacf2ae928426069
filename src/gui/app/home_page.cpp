// SPDX-License-Identifier: BSD-3-Clause
#include "gui/app/home_page.h"

#include <QAbstractButton>
#include <QAction>
#include <QCoreApplication>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>

#include "gui/files/recent_files.h"
#include "gui/widgets/colours.h"

namespace hogelscope {

namespace {

/// Returns the installed sample, or the one in the source tree; empty if there is none.
QString sampleFile(const QString& name) {
  const QString program = QCoreApplication::applicationDirPath();
  for (const QString& file : {program + "/../share/hogelscope/samples/" + name + ".hogelscope",
                              program + "/../../../data/" + name + ".json"})
    if (QFileInfo::exists(file)) return QFileInfo(file).canonicalFilePath();
  return {};
}

QLabel* label(const QString& text, TextSize size, QFont::Weight weight = QFont::Normal) {
  auto* made = new QLabel(text);
  made->setFont(textFont(size, weight));
  return made;
}

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
  Card(const QString& title, QString line, const QString& picture, const QSize& size)
      : m_line(std::move(line)), m_picture(picture), m_size(size) {
    setText(title);
    setAccessibleDescription(m_line);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
  }
  [[nodiscard]] QSize sizeHint() const override {
    return {scaled(m_size.width()), scaled(m_size.height() + footHeight)};
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
    painter.setPen(t.text);
    painter.setFont(textFont(TextSize::title, QFont::DemiBold));
    painter.drawText(texts.adjusted(0, scaled(6), 0, 0), Qt::AlignTop, text());
    painter.setPen(t.text2);
    painter.setFont(textFont(TextSize::base));
    painter.drawText(texts.adjusted(0, 0, 0, -scaled(8)), Qt::AlignBottom,
                     painter.fontMetrics().elidedText(m_line, Qt::ElideRight, texts.width()));
    painter.setPen(hasFocus() ? QPen(t.focus, 2) : QPen(t.strongLine, 1));
    painter.drawPath(frame);
  }

 private:
  static constexpr int footHeight = 52;

  QString m_line;
  QImage m_picture;
  QSize m_size;  ///< of the picture
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
    const int right = paintRight(painter);
    painter.setPen(t.text);
    painter.setFont(textFont(TextSize::base, QFont::Medium));
    const QRect all(left, 0, right - left, height());
    const QRect titles = m_isKey ? all : all.adjusted(0, scaled(4), 0, 0);
    const auto side = m_isKey ? Qt::AlignVCenter : Qt::AlignTop;
    painter.drawText(titles, side,
                     painter.fontMetrics().elidedText(text(), Qt::ElideMiddle, all.width()));
    const int end = m_isKey ? painter.fontMetrics().horizontalAdvance(text()) + scaled(12) : 0;
    painter.setPen(t.text2);
    painter.setFont(textFont(TextSize::caption));
    painter.drawText(all.adjusted(end, 0, 0, m_isKey ? 0 : -scaled(6)),
                     m_isKey ? Qt::AlignVCenter : Qt::AlignBottom,
                     painter.fontMetrics().elidedText(m_note, Qt::ElideMiddle, all.width() - end));
  }

 private:
  /// Paints the key in a frame, or the date. Returns where it begins.
  int paintRight(QPainter& painter) const {
    const Tokens& t = tokens();
    painter.setFont(textFont(TextSize::caption));
    painter.setPen(t.text3);
    const int textWidth = painter.fontMetrics().horizontalAdvance(m_right);
    const QRect place(width() - textWidth - scaled(20), (height() - scaled(20)) / 2,
                      textWidth + scaled(10), scaled(20));
    painter.drawText(place, Qt::AlignCenter, m_right);
    if (m_isKey && !m_right.isEmpty()) {
      painter.setPen(t.strongLine);
      painter.setBrush(Qt::NoBrush);
      painter.drawRoundedRect(QRectF(place).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    }
    return place.left() - scaled(8);
  }

  QString m_note;
  QString m_right;
  bool m_isKey;
  QImage m_picture;
};

QString keyOf(const QAction* action) {
  return action->shortcut().toString(QKeySequence::NativeText);
}

/// Returns a time in short: with the hour today, else the day.
QString dayOf(const QDateTime& when) {
  const qint64 days = when.date().daysTo(QDate::currentDate());
  if (days == 0) return HomePage::tr("today %1").arg(when.toString("HH:mm"));
  return days == 1 ? HomePage::tr("yesterday") : QLocale().toString(when.date(), "d MMM");
}

}  // namespace

HomePage::HomePage(const QList<QAction*>& begins, QWidget* parent) : QScrollArea(parent) {
  setObjectName("homePage");
  auto* page = new QWidget;
  page->setMaximumWidth(scaled(1000));  // even in a large window
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(scaled(24), scaled(24), scaled(24), scaled(12));
  layout->setSpacing(scaled(16));
  layout->addStretch(1);
  layout->addLayout(makeHead());
  layout->addWidget(label(tr("Start with a sample"), TextSize::base, QFont::DemiBold));
  layout->addLayout(makeSamples());
  auto* lists = new QHBoxLayout;
  lists->setSpacing(scaled(32));
  lists->addLayout(makeBegins(begins), 1);
  lists->addLayout(makeRecent(), 1);
  layout->addLayout(lists);
  m_links = new QHBoxLayout;
  layout->addLayout(m_links);
  layout->addStretch(2);
  auto* around = new QWidget;
  around->setObjectName("homeGround");
  auto* sides = new QHBoxLayout(around);
  sides->addWidget(page);
  setWidget(around);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
}

QLayout* HomePage::makeHead() {
  auto* sign = new QLabel;
  const int side = scaled(44);
  sign->setPixmap(QIcon(":/desktop/io.github.hogelscope.Hogelscope.svg").pixmap(side, side));
  auto* texts = new QVBoxLayout;
  texts->setSpacing(0);
  texts->addWidget(label(tr("Hogelscope"), TextSize::large, QFont::DemiBold));
  texts->addWidget(
      label(tr("What an eye sees on a display that does not exist yet"), TextSize::base));
  auto* head = new QHBoxLayout;
  head->setSpacing(scaled(16));
  head->addWidget(sign);
  head->addLayout(texts, 1);
  return head;
}

QLayout* HomePage::makeSamples() {
  auto* row = new QHBoxLayout;
  row->setSpacing(scaled(12));
  struct Sample {
    QString name, title, line;
    QSize size;
  };
  for (const Sample& sample :
       {Sample{"room",
               tr("The room"),
               tr("A live scene on a 0.5 m display: drag the eye"),
               {440, 280}},
        Sample{"table1", tr("Table I"), tr("The paper's display, six cameras"), {440, 280}}}) {
    const QString file = sampleFile(sample.name);
    if (file.isEmpty()) continue;
    auto* card = new Card(sample.title, sample.line, ":/home/" + sample.name + ".png", sample.size);
    card->setObjectName(sample.name + "Sample");
    row->addWidget(fileButton(file, card), sample.size.width());
  }
  return row;
}

QLayout* HomePage::makeBegins(const QList<QAction*>& begins) {
  auto* layout = new QVBoxLayout;
  layout->setSpacing(scaled(2));
  layout->addWidget(label(tr("Open"), TextSize::base, QFont::DemiBold));
  const QHash<QString, QPair<const char*, QString>> looks{
      {"openLightFieldAction", {"picture", tr("hogels, quilt, lenslets, mesh")}},
      {"openFolderAction", {"folder", tr("sub-aperture pictures")}},
      {"openAction", {"open", {}}},
      {"newAction", {"new", tr("a display around a test scene")}}};
  for (QAction* action : begins) {
    const auto& [image, note] = looks[action->objectName()];
    auto* row = new Row(action->text().remove('&'), note, keyOf(action), true);
    row->setIcon(icon(image));
    row->setObjectName(action->objectName() + "Button");
    row->setToolTip(action->toolTip());
    connect(row, &QAbstractButton::clicked, action, &QAction::trigger);
    layout->addWidget(row);
  }
  auto* drop = label(tr("or drop any of these anywhere"), TextSize::base);
  drop->setObjectName("dropHint");
  drop->setAlignment(Qt::AlignCenter);
  drop->setFixedHeight(scaled(36));
  layout->addWidget(drop);
  layout->addStretch();
  return layout;
}

QLayout* HomePage::makeRecent() {
  auto* layout = new QVBoxLayout;
  layout->setSpacing(scaled(2));
  layout->addWidget(label(tr("Recent"), TextSize::base, QFont::DemiBold));
  m_recent = new QVBoxLayout;
  m_recent->setSpacing(0);
  layout->addLayout(m_recent);
  layout->addStretch();
  return layout;
}

void HomePage::addLinks(const QList<QAction*>& actions) {
  for (QAction* action : actions) {
    auto* button = new QToolButton;
    button->setText(action->text().remove('&') + "  " + keyOf(action));
    button->setToolTip(action->toolTip());
    connect(button, &QToolButton::clicked, action, &QAction::trigger);
    m_links->addWidget(button);
  }
  m_links->addStretch();
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
  while (QLayoutItem* item = m_recent->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  constexpr int most = 4;  // the menu lists all of them
  for (const RecentFile& recent : RecentFiles::list()) {
    if (m_recent->count() == most) break;
    const QFileInfo info(recent.file);
    const QString note = recent.what.isEmpty() ? info.path() : recent.what + " · " + info.path();
    auto* row = new Row(info.fileName(), note, dayOf(recent.when), false);
    row->setPicture(recent.thumbnail);
    row->setObjectName("recentSession");
    m_recent->addWidget(fileButton(recent.file, row));
  }
  if (m_recent->count() == 0) m_recent->addWidget(label(tr("None yet"), TextSize::base));
}

}  // namespace hogelscope
