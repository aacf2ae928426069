// SPDX-License-Identifier: BSD-3-Clause
// Forms after other sessions: each sample is opened after every other, and all rows that a session
// has are there, below each other, in their full height.
#include <QAbstractSpinBox>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTextDocumentFragment>
#include <QToolButton>

#include "gui/widgets/elided_label.h"
#include "gui/widgets/parameter_form.h"
#include "gui/widgets/scrub_field.h"
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

  /// No text is cut, in every workspace, at several sizes of window and text.
  void everyTextHasRoom_data() {
    QTest::addColumn<QSize>("size");
    QTest::addColumn<int>("larger");
    QTest::addColumn<QString>("colours");
    QTest::newRow("1280×800") << QSize(1280, 800) << 0 << "darkColours";
    QTest::newRow("1600×900, light") << QSize(1600, 900) << 0 << "lightColours";
    QTest::newRow("2560×1440") << QSize(2560, 1440) << 0 << "darkColours";
    QTest::newRow("1600×900, text +3") << QSize(1600, 900) << 3 << "darkColours";
  }
  void everyTextHasRoom();

 private:
  void writeSamples() {
    QVERIFY(QDir::setCurrent(m_folder.path()));
    writeSmallSession();
    writeFile("live.json", R"({"hogelscope": 1,
      "display": {"hogels": [16, 16], "directions": [4, 4]},
      "lightField": {"layout": "live", "source": "scene"},
      "cameras": [{"name": "a", "eye": [-0.1464, -0.1454, 0.5805], "lookat": [-0.38195, 0, 0],
                   "up": [0.0123, 0.976, -0.176], "res": [40, 30],
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

  /// Returns the visible texts that have too little room.
  [[nodiscard]] QStringList cutTexts() const {
    QStringList cut;
    for (const QWidget* widget : m_window->findChildren<QWidget*>()) {
      if (!widget->isVisible() || widget->visibleRegion().isEmpty()) continue;
      const bool isField = qobject_cast<const QAbstractSpinBox*>(widget) != nullptr;
      if (!hasRoom(widget) ||
          (isField && widget->visibleRegion().boundingRect().width() < widget->width()))
        cut << nameOf(*widget);
    }
    return cut;
  }
  static QString nameOf(const QWidget& widget) {
    const auto* label = qobject_cast<const QLabel*>(&widget);
    const auto* button = qobject_cast<const QAbstractButton*>(&widget);
    const QString text = label ? label->text() : button ? button->text() : widget.accessibleName();
    return QString("%1 \"%2\" in %3 px")
        .arg(widget.objectName(), QTextDocumentFragment::fromHtml(text).toPlainText())
        .arg(widget.width());
  }
  /// Whether a button shows its icon alone.
  static bool isPicture(const QAbstractButton* button) {
    const auto* tool = qobject_cast<const QToolButton*>(button);
    return tool != nullptr && tool->toolButtonStyle() == Qt::ToolButtonIconOnly;
  }
  static bool hasRoom(const QWidget* widget) {
    if (const auto* box = dynamic_cast<const RealField*>(widget)) return box->isWideEnough();
    if (const auto* box = dynamic_cast<const WholeField*>(widget)) return box->isWideEnough();
    if (const auto* label = qobject_cast<const QLabel*>(widget)) {
      if (dynamic_cast<const ElidedLabel*>(label) != nullptr || label->text().isEmpty())
        return true;
      if (label->wordWrap() || label->hasHeightForWidth())
        return label->heightForWidth(label->width()) <= label->height();
      return label->sizeHint().width() <= label->width();
    }
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    const bool isOfQt = button != nullptr && (qobject_cast<const QPushButton*>(button) ||
                                              qobject_cast<const QToolButton*>(button) ||
                                              qobject_cast<const QCheckBox*>(button));
    return !isOfQt || button->text().isEmpty() || button->sizeHint().width() <= button->width() ||
           isPicture(button);
  }

  QStringList m_samples;
};

void TestFormRows::everyTextHasRoom() {
  QFETCH(QSize, size);
  QFETCH(int, larger);
  QFETCH(QString, colours);
  m_window->resize(size);
  child<QAction>(colours.toLatin1().data())->trigger();
  for (int k = 0; k < larger; ++k) child<QAction>("largerTextAction")->trigger();
  QStringList cut;
  for (const QString& sample : m_samples) {
    open(m_folder.filePath(sample));
    for (const char* workspace : {"layoutViewAction", "layoutCompareAction", "layoutDesignAction",
                                  "layoutMeasureAction", "layoutReportAction"}) {
      child<QAction>(workspace)->trigger();
      // The window is laid out in several steps, which take as long as they take.
      QTest::qWait(100);
      (void)QTest::qWaitFor([this] { return cutTexts().isEmpty(); }, 3000);
      for (const QString& text : cutTexts()) cut << sample + ", " + workspace + ": " + text;
    }
  }
  child<QAction>("normalTextAction")->trigger();
  child<QAction>("layoutViewAction")->trigger();
  QVERIFY2(cut.isEmpty(), qPrintable(cut.join('\n')));
}

int main(int argc, char** argv) {
  return runWindowTest<TestFormRows>(argc, argv);
}

#include "test_form_rows.moc"
