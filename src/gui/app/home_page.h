// SPDX-License-Identifier: BSD-3-Clause
// What the window shows while no session is open: ways to begin, the samples, what was open last.
// It scrolls, so that it asks for no larger window than a small screen has.
#pragma once

#include <QScrollArea>

class QVBoxLayout;

namespace Ui {
class MainWindow;
}

namespace hogelscope {

class HomePage : public QScrollArea {
  Q_OBJECT

 public:
  /// Its buttons are actions of `ui`.
  explicit HomePage(const Ui::MainWindow& ui, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// A sample, or a file that was open before.
  void chosen(const QString& file);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* makeActions(const Ui::MainWindow& ui);
  QWidget* makeFiles();
  void fillRecent();
  QWidget* fileButton(const QString& file, const QString& text, const QString& description);

  QVBoxLayout* m_recent = nullptr;
};

}  // namespace hogelscope
