// SPDX-License-Identifier: BSD-3-Clause
// Help ▸ Manual: the built-in manual with its contents and a search field.
#pragma once

#include <QTextBrowser>

class QLabel;
class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace hogelscope {

/// A page that scales images down to its own width.
class ManualPage : public QTextBrowser {
  Q_OBJECT

 public:
  using QTextBrowser::QTextBrowser;
  QVariant loadResource(int type, const QUrl& name) override;
};

/// A separate window that closes with its parent.
class ManualWindow : public QWidget {
  Q_OBJECT

 public:
  explicit ManualWindow(QWidget* parent);

 private:
  void addKeys();
  void layOutTables();
  void listHeadings();
  void goTo(const QTreeWidgetItem* heading);
  void find(QTextDocument::FindFlags flags);

  QTreeWidget* m_contents;
  ManualPage* m_page;
  QLineEdit* m_search;
  QLabel* m_note;
};

}  // namespace hogelscope
