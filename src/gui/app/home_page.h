// SPDX-License-Identifier: BSD-3-Clause
// The page shown while no session is open: samples as pictures, commands that begin a session and
// recent files. It scrolls, so that it fits a small screen.
#pragma once

#include <QScrollArea>
#include <memory>

class QAbstractButton;

namespace Ui {
class HomePage;
}

namespace hogelscope {

class HomePage : public QScrollArea {
  Q_OBJECT

 public:
  explicit HomePage(QWidget* parent = nullptr);
  ~HomePage() override;

  /// Adds rows and links for commands of a window, once it has all of them and their keys.
  void addCommands(const QWidget& window);

 Q_SIGNALS:
  /// A sample or a recent file has been chosen.
  void chosen(const QString& file);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void addSample(const QString& name, const QString& title, const QString& line, int row,
                 int column, int rows = 1);
  void fillRecent();
  QWidget* fileButton(const QString& file, QAbstractButton* button);

  std::unique_ptr<Ui::HomePage> m_ui;
};

}  // namespace hogelscope
