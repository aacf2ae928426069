// SPDX-License-Identifier: BSD-3-Clause
// The page shown while no session is open: samples as pictures, commands that begin a session and
// recent files. It scrolls, so that it fits a small screen.
#pragma once

#include <QScrollArea>

class QAbstractButton;
class QAction;
class QHBoxLayout;
class QVBoxLayout;

namespace hogelscope {

class HomePage : public QScrollArea {
  Q_OBJECT

 public:
  /// Creates rows that trigger the commands that begin a session.
  explicit HomePage(const QList<QAction*>& begins, QWidget* parent = nullptr);

  /// Adds links to commands below the page.
  void addLinks(const QList<QAction*>& actions);

 Q_SIGNALS:
  /// A sample or a recent file has been chosen.
  void chosen(const QString& file);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QLayout* makeHead();
  QLayout* makeSamples();
  QLayout* makeBegins(const QList<QAction*>& begins);
  QLayout* makeRecent();
  void fillRecent();
  QWidget* fileButton(const QString& file, QAbstractButton* button);

  QVBoxLayout* m_recent = nullptr;
  QHBoxLayout* m_links = nullptr;
};

}  // namespace hogelscope
