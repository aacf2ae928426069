// SPDX-License-Identifier: BSD-3-Clause
// Common parts of the docks' tests: the sample session with small images, and its list of states.
#pragma once

#include <QListView>

#include "gui/view/image_widget.h"
#include "io/documents/session_file.h"
#include "tests/gui/pattern_file.h"
#include "tests/gui/window_test.h"

inline const QString sampleFile = QStringLiteral(HOGELSCOPE_SOURCE_DIR "/data/table1.json");

class DocksTest : public WindowTest {
 protected:
  /// Opens the session with few directions and small images, for fast reading and rendering.
  void openSmall() {
    const QString file = m_folder.filePath("small.json");
    hogelscope::Session session = hogelscope::loadSession(
        sampleFile.toStdString(), {"display.directions=[5,5]", "camera.res=[90,80]"});
    session.lightField.file = m_folder.filePath("small.png").toStdString();
    if (!QFileInfo::exists(m_folder.filePath("small.png")))
      writePattern("scene", session.display, session.lightField.file);
    hogelscope::saveSession(file.toStdString(), session);
    open(file);
  }
  [[nodiscard]] const QImage& view() const {
    return child<hogelscope::ImageWidget>("pictureView")->image();
  }
  [[nodiscard]] QListView* list() const { return child<QListView>("stateList"); }
  /// The index of a row that is shown.
  [[nodiscard]] QModelIndex at(int row) const { return list()->model()->index(row, 0); }
  [[nodiscard]] int count() const { return list()->model()->rowCount(); }
  [[nodiscard]] int currentRow() const { return list()->currentIndex().row(); }
  [[nodiscard]] QStringList names() const {
    QStringList result;
    for (int row = 0; row < count(); ++row) result << at(row).data().toString();
    return result;
  }
};
