// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/section.h"

#include <QAbstractButton>
#include <QDockWidget>
#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QScrollArea>
#include <QToolButton>

#include "gui/widgets/colours.h"

namespace hogelscope {

namespace {

/// The header of a section: a chevron, the title, and while the section is closed its accessible
/// description, which is a summary.
class SectionHeader : public QAbstractButton {
 public:
  explicit SectionHeader(const QString& title) {
    setText(title);
    setCheckable(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  }

  [[nodiscard]] QSize sizeHint() const override { return {scaled(240), scaled(28)}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {80, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    const Tokens& t = tokens();
    painter.fillRect(rect(), underMouse() ? t.hover : t.window);
    painter.fillRect(0, 0, width(), 1, t.line);
    const int size = scaled(16);
    const QRect chevron(scaled(8), (height() - size) / 2, size, size);
    hogelscope::icon(isChecked() ? "expanded" : "collapsed").paint(&painter, chevron);
    const int left = chevron.right() + scaled(6);
    const QRect title =
        writeLine(painter, rect().adjusted(left, 0, 0, 0), Qt::AlignVCenter, text(),
                  textFont(TextSize::base, QFont::DemiBold), isEnabled() ? t.text : t.text3);
    if (!isChecked())
      writeLine(painter, rect().adjusted(title.right() + scaled(12), 0, -scaled(36), 0),
                Qt::AlignVCenter | Qt::AlignRight, accessibleDescription(),
                textFont(TextSize::caption), t.text3, Qt::ElideMiddle);
    if (hasFocus()) {
      painter.setPen(QPen(t.focus, 2));
      painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
  }
};

}  // namespace

Section::Section(QWidget* content, QDockWidget* dock, QWidget* parent)
    : QWidget(parent),
      m_content(content),
      m_dock(dock),
      m_header(new SectionHeader(dock->windowTitle())),
      m_layout(new QVBoxLayout(this)),
      m_area(new QScrollArea) {
  const QString name = QString(dock->objectName()).remove("Dock");
  content->setObjectName(name + "Area");
  m_header->setObjectName(name + "Header");
  m_header->setToolTip(tr("Opens or closes this section (Space)"));
  auto* out = new QToolButton;
  out->setObjectName(name + "OutButton");
  out->setIcon(icon("undock"));
  out->setToolTip(tr("Takes this section out as a dock of its own; closing the dock puts it back"));
  out->setFocusPolicy(Qt::TabFocus);
  auto* row = new QHBoxLayout(m_header);
  row->setContentsMargins(0, 0, scaled(4), 0);
  row->addStretch();
  row->addWidget(out);
  m_layout->setContentsMargins(0, 0, 0, 0);
  m_layout->setSpacing(0);
  m_layout->addWidget(m_header);
  m_layout->addWidget(content);
  m_area->setWidgetResizable(true);
  m_dock->setWidget(m_area);
  m_dock->hide();
  m_dock->installEventFilter(this);
  connect(m_header, &QAbstractButton::toggled, this, [this](bool isOpen) {
    if (!isOut()) m_content->setVisible(isOpen);
    Q_EMIT toggled();
  });
  connect(out, &QToolButton::clicked, this, [this] {
    m_dock->setFloating(true);
    m_dock->show();
  });
  content->hide();
}

void Section::setSummary(const QString& summary) {
  if (summary == m_header->accessibleDescription()) return;
  m_header->setAccessibleDescription(summary);
  m_header->update();
}

bool Section::isOpen() const {
  return m_header->isChecked();
}

void Section::setOpen(bool isOpen) {
  m_header->setChecked(isOpen);
}

bool Section::isOut() const {
  return m_area->widget() == m_content;
}

/// Moves the content into the dock when it is shown and back when it is hidden, also by a restored
/// layout; not when another tab covers it.
bool Section::eventFilter(QObject* /*watched*/, QEvent* event) {
  if (event->type() == QEvent::ShowToParent) move(true);
  if (event->type() == QEvent::HideToParent) move(false);
  return false;
}

void Section::move(bool isOut) {
  if (isOut == this->isOut()) return;
  if (isOut) {
    m_layout->removeWidget(m_content);
    m_area->setWidget(m_content);
    m_content->show();
  } else {
    m_layout->addWidget(m_area->takeWidget());
    m_content->setVisible(isOpen());
  }
  setVisible(!isOut);
  Q_EMIT toggled();
}

}  // namespace hogelscope
