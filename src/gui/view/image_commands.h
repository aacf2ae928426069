// SPDX-License-Identifier: BSD-3-Clause
// The Picture menu: how the simulated view is shown, what it is compared with, saving and copying.
#pragma once

#include <QObject>

#include "gui/view/comparison.h"

namespace Ui {
class MainWindow;
}

namespace hogelscope {

class ComparisonCommands;
class ReadingBar;
class SessionModel;
class ViewOutput;
struct RenderedView;

class ImageCommands : public QObject {
  Q_OBJECT

 public:
  ImageCommands(const Ui::MainWindow& ui, SessionModel* model, QObject* parent);

  /// The session's own light field; none while it is read.
  void setScene(const std::optional<Scene>& own);
  /// What is to be rendered beside the session's own light field.
  [[nodiscard]] std::optional<Scene> other() const;
  void show(const RenderedView& view);
  /// Why the image is not what it should be. Until the next one is shown this stands on it, and
  /// it can neither be saved nor copied.
  void showNotice(const QString& why);
  /// The same, without the image: it is of another session.
  void drop(const QString& why);
  /// Begins to read; what goes wrong is told by failed(), now or later.
  bool compareWith(const QString& file);
  /// The image as it is shown, if it is right; format by extension.
  bool saveImage(const QString& file);

 Q_SIGNALS:
  void otherChanged();  ///< what other() says
  /// With another light field's file; "": with none.
  void compared(const QString& file);
  void done(const QString& line);
  void failed(const QString& line);

 private:
  [[nodiscard]] bool isRight() const;
  void stopComparing();
  void stopReading();
  void showComparison();
  void copy();
  void askFile();
  void askFolder();
  void askImage();

  const Ui::MainWindow& m_ui;
  SessionModel* m_model;
  Comparison* m_comparison;
  ComparisonCommands* m_comparing;
  ViewOutput* m_output;
  ReadingBar* m_bar;
};

}  // namespace hogelscope
