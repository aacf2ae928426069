// SPDX-License-Identifier: BSD-3-Clause
// Forms after other sessions: each sample is opened after every other, and all rows that a session
// has are there, below each other, in their full height.
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>

#include "gui/widgets/parameter_form.h"
#include "tests/gui/docks_test.h"

using namespace hogelscope;

namespace {

const QStringList sections{"lightField", "display",    "twin", "camera",
                           "eyes",       "distortion", "psf",  "sampling"};

/// The place of a row's editors in the form.
QRect placeOf(const ParameterForm::Row& row, const ParameterForm& form) {
  const QWidget* whole = row.editor;
  while (whole->parentWidget() != &form) whole = whole->parentWidget();
  return whole->geometry();
}

}  // namespace

class TestFormRows : public DocksTest {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    writeSamples();
    writeSheets();
    showWindow({1280, 800});
    for (const QString& section : sections) openSection(section);
  }
  void cleanupTestCase() { m_window.reset(); }

  void everySampleAfterEveryOther() {
    for (const QString& first : m_samples)
      for (const QString& second : m_samples) {
        if (first == second) continue;
        open(m_folder.filePath(first));
        open(m_folder.filePath(second));
        QVERIFY2(message().contains(" ms"), qPrintable(message()));
        (void)QTest::qWaitFor([this] { return fault().isEmpty(); }, 2000);
        QVERIFY2(fault().isEmpty(), qPrintable(first + ", then " + second + ": " + fault()));
      }
  }

 private:
  void writeSamples() {
    QVERIFY(QDir::setCurrent(m_folder.path()));
    writeSmallSession();
    writeFile("live.json", R"({"hogelscope": 1,
      "display": {"hogels": [16, 16], "directions": [4, 4]},
      "lightField": {"layout": "live", "source": "scene"},
      "cameras": [{"name": "a", "eye": [0, 0, 0.7], "res": [40, 30],
                   "distortion": {"model": "rational", "k4": 0.1},
                   "psf": {"windowSize": 1}}]})");
    m_samples << "s.json"
              << "live.json";
  }
  void writeSheets() {
    QImage quilt(32, 12, QImage::Format_RGB32);
    quilt.fill(Qt::gray);
    QVERIFY(quilt.save("q_qs8x6a1.5.png"));
    const QByteArray sheet = R"("kind": "sheet", "calibration": {"pitch": 5, "slope": -6,
      "center": 0.1, "dpi": 50, "panel": [180, 120], "cone": 40})";
    const auto write = [](const char* name, const QByteArray& display, const QByteArray& light) {
      writeFile(name, R"({"hogelscope": 1, "display": {)" + display + R"(}, "lightField": {)" +
                          light + R"(},
        "cameras": [{"name": "a", "eye": [0, 0, 0.5], "fov": 20, "res": [40, 30],
                     "psf": {"windowSize": 1}}]})");
    };
    const QByteArray quilts = R"("layout": "quilt", "file": "q_qs8x6a1.5.png")";
    write("sheet.json", sheet, quilts);
    write("quilt.json", R"("size": [0.2, 0.1])", quilts);
    write("live_sheet.json", sheet + R"(, "hogels": [40, 30], "directions": [8, 1])",
          R"("layout": "live", "source": "scene")");
    m_samples << "sheet.json"
              << "quilt.json"
              << "live_sheet.json";
  }

  /// Returns what is wrong with the rows of all forms; "" if nothing is.
  [[nodiscard]] QString fault() const {
    for (const ParameterForm* form : m_window->findChildren<ParameterForm*>()) {
      if (!form->isVisible()) continue;
      int bottom = 0;
      for (const ParameterForm::Row& row : form->rows()) {
        const QRect place = placeOf(row, *form);
        const QString name = form->objectName() + ", " + row.label;
        if (place.top() < bottom) return name + " lies on the row above";
        if (place.height() < row.editor->minimumSizeHint().height()) return name + " is cut";
        bottom = place.bottom();
        if (bottom >= form->height()) return name + " is outside";
      }
    }
    return {};
  }

  QStringList m_samples;
};

int main(int argc, char** argv) {
  return runWindowTest<TestFormRows>(argc, argv);
}

#include "test_form_rows.moc"
