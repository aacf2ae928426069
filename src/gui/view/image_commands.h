// SPDX-License-Identifier: BSD-3-Clause
// The Picture menu: display and comparison of the simulated view, saving and copying.
#pragma once

#include <QObject>

#include "gui/view/comparison.h"
#include "picture/stereo_view.h"

class QAction;
class QMenu;
class QStatusBar;
class QVBoxLayout;

namespace hogelscope {

class ComparisonCommands;
class ImageWidget;
class ReadingBar;
class SessionModel;
class ViewOutput;
struct RenderedView;

class ImageCommands : public QObject {
  Q_OBJECT

 public:
  /// `around` is the layout that holds `view`.
  ImageCommands(QMenu* menu, ImageWidget* view, QVBoxLayout* around, QStatusBar* statusBar,
                SessionModel* model, QObject* parent);

  /// Sets the session's own light field; none while it is read.
  void setSource(const std::optional<ViewSource>& own);
  /// Returns the light field that is rendered for comparison.
  [[nodiscard]] std::optional<ViewSource> other() const;
  /// Shows frames as Comparison does.
  void showFrame(const std::shared_ptr<const LightFieldSource>& own,
                 const std::shared_ptr<const LightFieldSource>& other);
  /// Returns the session of the second light field, if it is another one.
  [[nodiscard]] const std::optional<Session>& otherSession() const;
  /// Returns whether the mask says why pixels are not seen.
  [[nodiscard]] bool asksWhy() const;
  /// Returns which eyes of a state with two are shown.
  [[nodiscard]] StereoView eyes() const;
  void show(const RenderedView& view);
  /// Shows on the image why it is outdated. Until the next image is shown, it can be neither saved
  /// nor copied.
  void showNotice(const QString& why, const QList<QAction*>& cures = {});
  /// Removes the image, which is of another session, and shows the notice.
  void drop(const QString& why);
  /// Starts reading. Errors are reported through failed(), now or later.
  bool compareWith(const QString& file);
  /// Shows the session's live content on another display, beside the one that it was on: one edit.
  void seeOn(const QString& name, const DisplayParams& display);
  /// Compares with another design, a session with a display of its own, by a wipe.
  void compareWithDesign(const QString& name, const Session& session);
  /// Saves the image as shown, unless it is outdated. The extension gives the format.
  bool saveImage(const QString& file);
  /// Returns what the picture that is shown has in place of the state's exact one in full size,
  /// such as "half size"; empty: it is that one.
  [[nodiscard]] QStringList deviations() const;
  /// Saves the two images that are compared side by side with the map of their error
  /// (comparisonSheet), unless they are outdated.
  bool saveFigure(const QString& file);

 Q_SIGNALS:
  void requestChanged();  ///< other(), asksWhy() or eyes() has changed
  /// Passes the file of the compared light field; "": none.
  void compared(const QString& file);
  void done(const QString& line);
  void failed(const QString& line);

 private:
  void addComparisons(QMenu* menu);
  void addCommands(QMenu* menu, QVBoxLayout* around, QStatusBar* statusBar);
  void addEyes(QMenu* menu);
  [[nodiscard]] bool isRight() const;
  void stopComparing();
  void stopReading();
  void showComparison();
  void copy();
  void askFile();
  void askFolder();
  void askImage();
  void remark(const RenderedView& view);
  [[nodiscard]] CameraState shownState() const;
  void askFigure();
  [[nodiscard]] QString ownName() const;
  template <class Write>
  bool save(const QString& file, const Write& write);

  QList<QAction*> m_ofAnyImage, m_ofRightImage;  ///< need an image; one that is up to date
  QAction *m_compareIdeal = nullptr, *m_compareDesigned = nullptr, *m_stop = nullptr,
          *m_mask = nullptr, *m_figure = nullptr;
  QMenu* m_library = nullptr;
  std::pair<QString, DisplayParams> m_named;  ///< the display that was chosen last, and its name
  QActionGroup* m_eyes;
  QStringList m_coarse;  ///< what makes the picture that is shown another one than the exact one
  ImageWidget* m_view;
  SessionModel* m_model;
  Comparison* m_comparison;
  ComparisonCommands* m_comparing = nullptr;
  ViewOutput* m_output = nullptr;
  ReadingBar* m_bar;
};

}  // namespace hogelscope
