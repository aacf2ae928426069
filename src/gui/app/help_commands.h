// SPDX-License-Identifier: BSD-3-Clause
// The Help menu: the manual in a window of its own, and the About box.
#pragma once

#include <QTextBrowser>
#include <QTextDocument>
#include <memory>
#include <vector>

class QMenu;

namespace Ui {
class ManualWindow;
}

namespace hogelscope {

/// Shows images no wider than itself.
class ManualPage : public QTextBrowser {
  Q_OBJECT

 public:
  using QTextBrowser::QTextBrowser;
  QVariant loadResource(int type, const QUrl& name) override;
};

/// A window of its own, which closes with its parent. Its chapters are the pages that the first
/// page, manual.md, links to, in that order.
class ManualWindow : public QWidget {
  Q_OBJECT

 public:
  explicit ManualWindow(QWidget* parent);
  ~ManualWindow() override;

  /// Shows a chapter, such as "12-view.md#comparing".
  void showChapter(const QString& name);

 private:
  struct Chapter {
    QUrl url;
    std::unique_ptr<QTextDocument> text;  ///< never laid out: for its headings and the search
  };

  void addKeys();
  void readChapters();
  void listHeadings(const Chapter& chapter);
  void showPage(const QUrl& url);
  void layOutTables();
  void scrollTo(const QString& anchor);
  void selectHeading(const QUrl& url);
  [[nodiscard]] std::size_t shownChapter() const;
  void search(const QString& words);
  void find(QTextDocument::FindFlags flags);

  std::unique_ptr<Ui::ManualWindow> m_ui;
  std::vector<Chapter> m_chapters;
};

/// Fills the Help menu: the manual, which opens at the chapter of the window's workspace, and the
/// About box. Both open over `window`.
void addHelp(QMenu* menu, QWidget* window);

}  // namespace hogelscope
