// SPDX-License-Identifier: BSD-3-Clause
// The window of Help ▸ Manual.
#include "gui/app/manual_window.h"

#include <QAbstractTextDocumentLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QShortcut>
#include <QSplitter>
#include <QTextBlock>
#include <QTextTable>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace hogelscope {

QVariant ManualPage::loadResource(int type, const QUrl& name) {
  QVariant resource = QTextBrowser::loadResource(type, name);
  if (type != QTextDocument::ImageResource) return resource;
  QImage image = QImage::fromData(resource.toByteArray());
  const auto widest =
      int((viewport()->width() - 2 * document()->documentMargin()) * devicePixelRatioF());
  if (image.width() > widest && widest > 0)
    image = image.scaledToWidth(widest, Qt::SmoothTransformation);
  image.setDevicePixelRatio(devicePixelRatioF());
  return image;
}

namespace {

QToolButton* button(const QString& text, const QString& tip) {
  auto* made = new QToolButton;
  made->setText(text);
  made->setToolTip(tip);
  return made;
}

}  // namespace

ManualWindow::ManualWindow(QWidget* parent)
    : QWidget(parent, Qt::Window),
      m_contents(new QTreeWidget),
      m_page(new ManualPage),
      m_search(new QLineEdit),
      m_note(new QLabel) {
  setWindowTitle(tr("Manual – Hogelscope"));
  resize(1080, 760);
  m_page->setObjectName("manualPage");
  m_contents->setObjectName("manualContents");
  m_contents->setHeaderHidden(true);
  m_search->setObjectName("manualSearch");
  m_search->setPlaceholderText(tr("Search (Ctrl+F)"));
  m_search->setToolTip(tr("Enter or F3 finds the next place, Shift+F3 the one before"));
  m_search->setClearButtonEnabled(true);
  m_note->setObjectName("manualNote");
  auto* back = button(tr("Back"), tr("To the page before (Alt+Left)"));
  auto* row = new QHBoxLayout;
  row->addWidget(back);
  row->addWidget(m_search, 1);
  row->addWidget(m_note);
  auto* splitter = new QSplitter;
  splitter->addWidget(m_contents);
  splitter->addWidget(m_page);
  splitter->setSizes({260, 820});
  splitter->setStretchFactor(1, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(row);
  layout->addWidget(splitter, 1);
  connect(back, &QToolButton::clicked, m_page, &QTextBrowser::backward);
  connect(m_page, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
  connect(m_page, &QTextBrowser::sourceChanged, this, &ManualWindow::layOutTables);
  connect(m_page, &QTextBrowser::sourceChanged, this, &ManualWindow::listHeadings);
  connect(m_contents, &QTreeWidget::currentItemChanged, this, &ManualWindow::goTo);
  back->setEnabled(false);
  addKeys();
  m_page->document()->setDocumentMargin(12);
  m_page->setSource(QUrl("qrc:/manual/manual.md"));
}

void ManualWindow::addKeys() {
  const auto key = [this](const QKeySequence& keys, auto action) {
    connect(new QShortcut(keys, this), &QShortcut::activated, this, action);
  };
  key(QKeySequence::Find, [this] {
    m_search->setFocus();
    m_search->selectAll();
  });
  key(Qt::Key_F3, [this] { find({}); });
  key(Qt::SHIFT | Qt::Key_F3, [this] { find(QTextDocument::FindBackward); });
  key(Qt::Key_Escape, [this] { close(); });
  connect(m_search, &QLineEdit::returnPressed, this, [this] { find({}); });
}

/// Formats the tables, because Markdown does not define their appearance.
void ManualWindow::layOutTables() {
  for (QTextFrame* frame : m_page->document()->rootFrame()->childFrames()) {
    auto* table = qobject_cast<QTextTable*>(frame);
    if (table == nullptr) continue;
    QTextTableFormat format = table->format();
    format.setBorderCollapse(true);
    format.setBorder(1);
    format.setBorderBrush(palette().color(QPalette::PlaceholderText));
    format.setCellPadding(4);
    format.setTopMargin(4);
    format.setBottomMargin(8);
    table->setFormat(format);
  }
}

/// Lists the chapters of the current page with their positions in the text.
void ManualWindow::listHeadings() {
  const QSignalBlocker quiet(m_contents);
  m_contents->clear();
  QTreeWidgetItem* chapter = nullptr;
  for (QTextBlock block = m_page->document()->begin(); block.isValid(); block = block.next()) {
    const int level = block.blockFormat().headingLevel();
    if (level == 0) continue;
    const bool isPart = level > 2 && chapter != nullptr;
    auto* item = isPart ? new QTreeWidgetItem(chapter) : new QTreeWidgetItem(m_contents);
    item->setText(0, block.text());
    item->setData(0, Qt::UserRole, block.position());
    if (!isPart) chapter = item;
  }
  m_contents->expandAll();
}

void ManualWindow::goTo(const QTreeWidgetItem* heading) {
  if (heading == nullptr) return;
  QTextCursor cursor(m_page->document());
  cursor.setPosition(heading->data(0, Qt::UserRole).toInt());
  m_page->setTextCursor(cursor);
  const QRectF place = m_page->document()->documentLayout()->blockBoundingRect(cursor.block());
  m_page->verticalScrollBar()->setValue(int(place.top()));
}

/// Finds the next match, and continues at the other end of the page.
void ManualWindow::find(QTextDocument::FindFlags flags) {
  m_note->clear();
  if (m_search->text().isEmpty() || m_page->find(m_search->text(), flags)) return;
  QTextCursor cursor = m_page->textCursor();
  cursor.movePosition(flags ? QTextCursor::End : QTextCursor::Start);
  m_page->setTextCursor(cursor);
  if (!m_page->find(m_search->text(), flags)) m_note->setText(tr("Not found"));
}

}  // namespace hogelscope
