// SPDX-License-Identifier: BSD-3-Clause
// The page shown while no session is open: start commands, samples and recent files. It scrolls, so
// that it fits a small screen.
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
  /// Creates buttons that trigger actions of `ui`.
  explicit HomePage(const Ui::MainWindow& ui, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// A sample or a recent file has been chosen.
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
