// SPDX-License-Identifier: BSD-3-Clause
#include "gui/app/help_commands.h"

#include <QAbstractTextDocumentLayout>
#include <QAction>
#include <QScrollBar>
#include <QShortcut>
#include <QTextBlock>
#include <QTextLayout>
#include <QTextTable>
#include <QTreeWidgetItemIterator>
#include <algorithm>

#include "gui/widgets/command.h"
#include "gui/widgets/dialogs.h"
#include "ui_manual_window.h"

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

const QUrl firstPage("qrc:/manual/manual.md");

/// Calls `take` with each heading of a text.
template <class Take>
void forHeadings(const QTextDocument& text, const Take& take) {
  for (QTextBlock block = text.begin(); block.isValid(); block = block.next())
    if (block.blockFormat().headingLevel() > 0) take(block);
}

/// The name of a heading in links, as hosts of Markdown make it: where-the-error-comes-from.
QString anchorOf(const QString& heading) {
  QString anchor;
  for (const QChar letter : heading.toLower()) {
    if (letter.isLetterOrNumber() || letter == '-' || letter == '_') anchor += letter;
    if (letter == ' ') anchor += '-';
  }
  return anchor;
}

/// Returns the chapter of the window's workspace; "" for View, in which people begin.
QString chapterFor(const QWidget& window) {
  for (const auto& [workspace, chapter] : {std::pair("layoutCompareAction", "12-view.md#comparing"),
                                           std::pair("layoutDesignAction", "16-measuring.md"),
                                           std::pair("layoutMeasureAction", "10-accuracy.md"),
                                           std::pair("layoutReportAction", "09-reports.md")})
    if (const auto* action = window.findChild<QAction*>(workspace); action && action->isChecked())
      return chapter;
  return {};
}

}  // namespace

ManualWindow::ManualWindow(QWidget* parent)
    : QWidget(parent, Qt::Window), m_ui(std::make_unique<Ui::ManualWindow>()) {
  m_ui->setupUi(this);
  m_ui->splitter->setSizes({260, 820});
  m_ui->splitter->setStretchFactor(1, 1);
  connect(m_ui->manualPage, &QTextBrowser::sourceChanged, this, &ManualWindow::showPage);
  connect(m_ui->manualContents, &QTreeWidget::currentItemChanged, this,
          [this](const QTreeWidgetItem* item) {
            if (item != nullptr) m_ui->manualPage->setSource(item->data(0, Qt::UserRole).toUrl());
          });
  addKeys();
  m_ui->manualPage->document()->setDocumentMargin(12);
  // Always, since images are as wide as the rest.
  m_ui->manualPage->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  readChapters();
  m_ui->manualPage->setSource(firstPage);
}

ManualWindow::~ManualWindow() = default;

void ManualWindow::addKeys() {
  const auto key = [this](const QKeySequence& keys, auto action) {
    connect(new QShortcut(keys, this), &QShortcut::activated, this, action);
  };
  key(QKeySequence::Find, [this] {
    m_ui->manualSearch->setFocus();
    m_ui->manualSearch->selectAll();
  });
  key(Qt::Key_F3, [this] { find({}); });
  key(Qt::SHIFT | Qt::Key_F3, [this] { find(QTextDocument::FindBackward); });
  key(Qt::Key_Escape, [this] { close(); });
  connect(m_ui->manualSearch, &QLineEdit::returnPressed, this, [this] { find({}); });
  connect(m_ui->manualSearch, &QLineEdit::textEdited, this, &ManualWindow::search);
}

void ManualWindow::readChapters() {
  const auto read = [this](const QUrl& url) {
    auto text = std::make_unique<QTextDocument>();
    const QVariant page = m_ui->manualPage->loadResource(QTextDocument::MarkdownResource, url);
    text->setMarkdown(QString::fromUtf8(page.toByteArray()));
    m_chapters.push_back({url, std::move(text)});
  };
  read(firstPage);
  const QTextDocument& contents = *m_chapters.front().text;
  for (QTextBlock block = contents.begin(); block.isValid(); block = block.next())
    for (const QTextLayout::FormatRange& range : block.textFormats())
      if (range.format.isAnchor()) read(firstPage.resolved(QUrl(range.format.anchorHref())));
  const QSignalBlocker quiet(m_ui->manualContents);
  for (const Chapter& chapter : m_chapters) listHeadings(chapter);
}

/// One branch of the contents: a chapter's title, and below it its sections.
void ManualWindow::listHeadings(const Chapter& chapter) {
  QTreeWidgetItem* title = nullptr;
  forHeadings(*chapter.text, [&](const QTextBlock& block) {
    QUrl place = chapter.url;
    if (title != nullptr) place.setFragment(anchorOf(block.text()));
    auto* item =
        title != nullptr ? new QTreeWidgetItem(title) : new QTreeWidgetItem(m_ui->manualContents);
    item->setText(0, block.text());
    item->setData(0, Qt::UserRole, place);
    if (title == nullptr) title = item;
  });
}

void ManualWindow::showPage(const QUrl& url) {
  layOutTables();  // Qt has read the page again, since the tables of the one before were edited
  (void)m_ui->manualPage->document()->size();  // lays out all of it: scroll bars reach its end
  if (url.hasFragment()) scrollTo(url.fragment());
  selectHeading(url);
}

/// Markdown says nothing about how tables look.
void ManualWindow::layOutTables() {
  for (QTextFrame* frame : m_ui->manualPage->document()->rootFrame()->childFrames()) {
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

/// Qt's Markdown has no anchors at headings.
void ManualWindow::scrollTo(const QString& anchor) {
  forHeadings(*m_ui->manualPage->document(), [&](const QTextBlock& block) {
    if (anchorOf(block.text()) != anchor) return;
    m_ui->manualPage->setTextCursor(QTextCursor(block));
    const QRectF place = m_ui->manualPage->document()->documentLayout()->blockBoundingRect(block);
    m_ui->manualPage->verticalScrollBar()->setValue(int(place.top()));
  });
}

void ManualWindow::selectHeading(const QUrl& url) {
  const QSignalBlocker quiet(m_ui->manualContents);
  for (QTreeWidgetItemIterator item(m_ui->manualContents); *item != nullptr; ++item)
    if ((*item)->data(0, Qt::UserRole).toUrl() == url) m_ui->manualContents->setCurrentItem(*item);
}

std::size_t ManualWindow::shownChapter() const {
  const QUrl url = m_ui->manualPage->source().adjusted(QUrl::RemoveFragment);
  const auto isShown = [&url](const Chapter& chapter) { return chapter.url == url; };
  return std::size_t(std::ranges::find_if(m_chapters, isShown) - m_chapters.begin());
}

void ManualWindow::showChapter(const QString& name) {
  m_ui->manualPage->setSource(firstPage.resolved(QUrl(name)));
}

/// Says how many places have the words, lists only chapters that do, and shows the first place.
void ManualWindow::search(const QString& words) {
  int places = 0, chapters = 0;
  for (std::size_t k = 0; k < m_chapters.size(); ++k) {
    int found = 0;
    for (QTextCursor at = m_chapters[k].text->find(words); !words.isEmpty() && !at.isNull();
         at = m_chapters[k].text->find(words, at))
      ++found;
    places += found;
    chapters += found > 0 ? 1 : 0;
    QTreeWidgetItem* chapter = m_ui->manualContents->topLevelItem(int(k));
    if (chapter != nullptr) chapter->setHidden(!words.isEmpty() && found == 0);
  }
  m_ui->manualPage->moveCursor(QTextCursor::Start);
  if (places > 0) find({});
  m_ui->manualNote->setText(words.isEmpty() ? QString()
                            : places > 0    ? tr("%1 places, %2 chapters").arg(places).arg(chapters)
                                            : tr("Not found"));
}

/// Goes on in the next chapters, the first after the last, and in the rest of its own at the end.
void ManualWindow::find(QTextDocument::FindFlags flags) {
  const QString words = m_ui->manualSearch->text();
  m_ui->manualNote->clear();
  if (words.isEmpty() || m_ui->manualPage->find(words, flags)) return;
  const std::size_t chapters = m_chapters.size();
  const std::size_t step = flags ? chapters - 1 : 1;
  std::size_t next = shownChapter() % chapters;
  for (std::size_t k = 0; k < chapters; ++k) {
    next = (next + step) % chapters;
    const Chapter& chapter = m_chapters[next];
    if (chapter.text->find(words).isNull()) continue;
    if (next != shownChapter()) m_ui->manualPage->setSource(chapter.url);
    QTextCursor cursor = m_ui->manualPage->textCursor();
    cursor.movePosition(flags ? QTextCursor::End : QTextCursor::Start);
    m_ui->manualPage->setTextCursor(cursor);
    m_ui->manualPage->find(words, flags);
    return;
  }
  m_ui->manualNote->setText(tr("Not found"));
}

void addHelp(QMenu* menu, QWidget* window) {
  addCommand(menu,
             {"manualAction", ManualWindow::tr("&Manual"),
              ManualWindow::tr("Shows the manual in a window of its own"), Qt::Key_F1},
             window, [window] {
               auto* manual = window->findChild<ManualWindow*>();
               if (manual == nullptr) manual = new ManualWindow(window);
               const QString chapter = chapterFor(*window);
               if (!manual->isVisible() && !chapter.isEmpty()) manual->showChapter(chapter);
               manual->show();
               manual->raise();
               manual->activateWindow();
             });
  menu->addSeparator();
  addCommand(menu,
             {"aboutAction", ManualWindow::tr("&About Hogelscope"),
              ManualWindow::tr("Name and version of the program"), Qt::CTRL | Qt::Key_F1},
             window, [window] { showAbout(window); });
}

}  // namespace hogelscope
