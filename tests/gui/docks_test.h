// SPDX-License-Identifier: BSD-3-Clause
// What tests of the docks share: the sample session with small images, and its list of states.
#pragma once

#include <QListWidget>

#include "gui/view/image_widget.h"
#include "io/documents/session_file.h"
#include "tests/gui/window_test.h"

inline const QString sampleFile = QStringLiteral(HOGELSCOPE_SOURCE_DIR "/data/table1.json");

class DocksTest : public WindowTest {
 protected:
  /// The reference renders its images quickly.
  void openSmall() {
    const QString file = m_folder.filePath("small.json");
    hogelscope::saveSession(file.toStdString(), hogelscope::loadSession(sampleFile.toStdString(),
                                                                        {"camera.res=[90,80]"}));
    open(file);
  }
  [[nodiscard]] const QImage& view() const {
    return child<hogelscope::ImageWidget>("pictureView")->image();
  }
  [[nodiscard]] QListWidget* list() const { return child<QListWidget>("stateList"); }
  [[nodiscard]] QStringList names() const {
    QStringList result;
    for (int row = 0; row < list()->count(); ++row) result << list()->item(row)->text();
    return result;
  }
};
