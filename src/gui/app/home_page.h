// SPDX-License-Identifier: BSD-3-Clause
// The page shown while no session is open: start commands, samples and recent files. It scrolls, so
// that it fits a small screen.
#pragma once

#include <QScrollArea>

class QAction;
class QVBoxLayout;

namespace hogelscope {

class HomePage : public QScrollArea {
  Q_OBJECT

 public:
  /// Creates buttons that trigger the commands that begin a session.
  explicit HomePage(const QList<QAction*>& begins, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// A sample or a recent file has been chosen.
  void chosen(const QString& file);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* makeActions(const QList<QAction*>& begins);
  QWidget* makeFiles();
  void fillRecent();
  QWidget* fileButton(const QString& file, const QString& text, const QString& description);

  QVBoxLayout* m_recent = nullptr;
};

}  // namespace hogelscope
