// SPDX-License-Identifier: BSD-3-Clause
// Light fields in time in the real window: the bar below the view, its keys, frames of states with
// a time, edits while it plays.
#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTableView>

#include "gui/docks/report_dock.h"
#include "gui/files/light_field_output.h"
#include "gui/view/frame_bar.h"
#include "gui/view/image_commands.h"
#include "gui/view/image_widget.h"
#include "io/documents/session_file.h"
#include "io/scene/view_source.h"
#include "report/report_reader.h"
#include "tests/core/rendered.h"
#include "tests/gui/shown_image.h"
#include "tests/gui/window_test.h"

using namespace hogelscope;

namespace {

constexpr int frames = 6;

/// Writes f.json, of frames scene.0.png …, which move to the right. State b has a time.
void writeFrames() {
  for (int k = 0; k < frames; ++k)
    writeImageFile(QString("scene.%1.png").arg(k), 64, 64, [k](int x, int y, int channel) {
      return float(((x + 9 * k) * 5 + y * 3 + channel * 40) % 200 + 20) / 255;
    });
  const QByteArray state = R"("eye": [0, 0, 0.7], "res": [40, 30])";
  writeFile("f.json", text({.display = R"({"hogels": [16, 16], "directions": [4, 4]})",
                            .lightField = R"({"file": "scene.{T}.png", "fps": 20})",
                            .cameras = R"([{"name": "a", )" + state +
                                       R"(}, {"name": "b", "time": 0.21, )" + state + "}]"}));
}

/// Writes t.0.png …, frames to compare with them.
void writeOthers() {
  for (int k = 0; k < frames; ++k)
    writeImageFile(QString("t.%1.png").arg(k), 64, 64, [k](int x, int y, int channel) {
      return float(((x + 9 * k) * 5 + y * 3 + channel * 40 + (x * 31 + k) % 7) % 200 + 20) / 255;
    });
}

/// Writes m.json, of a card that an animation moves to the right in half a second, 8 frames/s.
void writeMoving() {
  const std::vector<float> numbers{-0.05F, -0.05F, 0, 0.05F, -0.05F, 0, 0, 0.05F, 0,  // the card
                                   0,      0.5F,                                      // times
                                   -0.1F,  0,      0, 0.1F,  0,      0};              // places
  const QByteArray bytes(reinterpret_cast<const char*>(numbers.data()),
                         qsizetype(numbers.size() * sizeof(float)));
  writeFile("moving.gltf", R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "buffers": [{"byteLength": 68, "uri": "data:application/octet-stream;base64,)" +
                               bytes.toBase64() + R"("}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36},
                    {"buffer": 0, "byteOffset": 36, "byteLength": 8},
                    {"buffer": 0, "byteOffset": 44, "byteLength": 24}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                  {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR"},
                  {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}],
    "animations": [{"name": "slide", "samplers": [{"input": 1, "output": 2}],
                    "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}]})");
  writeFile("m.json", text({.display = R"({"hogels": [40, 40], "directions": [8, 8]})",
                            .lightField = R"({"layout": "live", "source": "mesh", "fps": 8,
                                "mesh": {"file": "moving.gltf", "animation": "slide"}})"}));
}

}  // namespace

class TestFrames : public WindowTest {
  Q_OBJECT

 private:
  ImageWidget* view() const { return child<ImageWidget>("pictureView"); }
  FrameBar* bar() const { return child<FrameBar>("frameBar"); }
  QString words() const { return child<QLabel>("frameText")->text(); }
  /// The picture of the current state at a frame, from the frame's file alone.
  Image imageAt(int frame) const { return imageOf("scene." + std::to_string(frame) + ".png"); }
  Image otherAt(int frame) const { return imageOf("t." + std::to_string(frame) + ".png"); }
  Image imageOf(const std::string& file) const {
    Session session = m_model->session();
    session.lightField.file = file;
    return rendered(loadViewSource(session, {}).job(m_model->current()));
  }
  /// The picture of the current state at a frame of an animation.
  Image movedAt(int frame) const {
    const Session& session = m_model->session();
    const auto file = openLightField(session.lightField, session.display);
    file->select(frame);
    return rendered(loadViewSource(session, *file, {}).job(m_model->current()));
  }
  void expectFrame(int frame) const {
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), imageAt(frame)), patience);
    QCOMPARE(bar()->frame(), frame);
    QVERIFY2(words().startsWith(QString("frame %1 of 0 … 5   ").arg(frame)), qPrintable(words()));
  }

 private Q_SLOTS:
  void init() {
    start();
    writeFrames();
  }
  void cleanup() { m_window.reset(); }

  void theBarIsThereOnlyForFrames() {
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms"), patience);
    QVERIFY(!bar()->isVisible());
    QVERIFY(!child<QAction>("playFramesAction")->isEnabled());
    open("f.json");
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), patience);
    QVERIFY(child<QAction>("playFramesAction")->isEnabled());
    expectFrame(0);
    open("s.json");
    QTRY_VERIFY_WITH_TIMEOUT(!bar()->isVisible(), patience);
    QVERIFY(!child<QAction>("playFramesAction")->isEnabled());
  }

  void keysStep() {
    open("f.json");
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), patience);
    key(Qt::Key_Period);
    expectFrame(1);
    key(Qt::Key_Period);
    expectFrame(2);
    key(Qt::Key_Comma);
    expectFrame(1);
    for (int k = 0; k < 3; ++k) key(Qt::Key_Comma);
    expectFrame(0);
    QVERIFY(!m_model->isModified());
  }

  void theSliderScrubs() {
    open("f.json");
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), patience);
    auto* slider = child<QSlider>("frameSlider");
    QCOMPARE(slider->maximum(), frames - 1);
    for (const int frame : {5, 2, 4}) {
      slider->setValue(frame);
      expectFrame(frame);
    }
    QVERIFY2(words().contains("0.20 s"), qPrintable(words()));
  }

  void aStateWithATimeShowsItsFrame() {
    open("f.json");
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), patience);
    m_model->setCurrentIndex(1);
    expectFrame(4);
  }

  /// Nothing waits for the clock: the frames that are due are shown in turn, again and again.
  void itPlaysInALoop() {
    open("f.json");
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), patience);
    QList<int> seen;
    connect(bar(), &FrameBar::frameAsked, this, [&](int frame) { seen << frame; });
    key(Qt::Key_Space, Qt::ControlModifier | Qt::AltModifier);
    QVERIFY(bar()->isPlaying());
    QTRY_VERIFY_WITH_TIMEOUT(seen.size() > 12, patience);
    QVERIFY2(words().contains(" pictures/s, "), qPrintable(words()));
    QVERIFY(seen.mid(0, 12).contains(5));
    QVERIFY(seen.indexOf(0) > 0);
    key(Qt::Key_Space, Qt::ControlModifier | Qt::AltModifier);
    QVERIFY(!bar()->isPlaying());
    expectFrame(bar()->frame());
  }

  void itEndsWithoutALoop() {
    open("f.json");
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), patience);
    child<QAction>("loopFramesAction")->setChecked(false);
    child<QAction>("playFramesAction")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!bar()->isPlaying(), patience);
    expectFrame(5);
    m_window->grab().save(QCoreApplication::applicationDirPath() + "/frames.png");
  }

  void editsWhileItPlaysTakeTheNextFrame() {
    open("f.json");
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), patience);
    child<QAction>("playFramesAction")->trigger();
    CameraState state = m_model->current();
    state.camera.eye.x = 0.1;
    m_model->setCurrent(state);
    QVERIFY(bar()->isPlaying());
    QTest::qWait(120);
    child<QAction>("playFramesAction")->trigger();
    expectFrame(bar()->frame());
    child<QAction>("undoAction")->trigger();
    expectFrame(bar()->frame());
  }

  /// What is exported is the frame that is shown.
  void theFrameThatIsShownIsExported() {
    open("f.json");
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), patience);
    auto* output = m_window->findChild<LightFieldOutput*>();
    QSignalSpy done(output, &LightFieldOutput::done);
    child<QSlider>("frameSlider")->setValue(4);
    expectFrame(4);
    output->save(ExportLayout::hogels, "exported.png");
    QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, patience);
    QCOMPARE(done[0][0].toString(), QString("Saved frame 4 as exported.png"));
    QVERIFY(equals(view()->image(), imageOf("exported.png")));
    open("s.json");
    QTRY_VERIFY_WITH_TIMEOUT(!bar()->isVisible(), patience);
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms"), patience);
    output->save(ExportLayout::hogels, "still.png");
    QTRY_COMPARE_WITH_TIMEOUT(done.size(), 2, patience);
    QCOMPARE(done[1][0].toString(), QString("Saved still.png"));
  }

  /// Both light fields show the same frame.
  void whatIsComparedGoesAlong() {
    writeOthers();
    open("f.json");
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), patience);
    key(Qt::Key_Period);
    expectFrame(1);
    QVERIFY(m_window->findChild<ImageCommands*>()->compareWith("t.{T}.png"));
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->otherImage(), otherAt(1)), patience);
    QVERIFY(equals(view()->image(), imageAt(1)));
    child<QSlider>("frameSlider")->setValue(4);
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->otherImage(), otherAt(4)), patience);
    QVERIFY(equals(view()->image(), imageAt(4)));
  }

  /// Its rows are the states at their frames; a row that is chosen shows both.
  void aReportHasAllFrames() {
    writeOthers();
    open("f.json");
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), patience);
    auto* dock = child<ReportDock>("reportPanel");
    dock->setFolder("made");
    dock->addTest("t.{T}.png");
    child<QPushButton>("makeReportButton")->click();
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists("made/report.csv"), patience);
    const StoredReport stored = readReport("made", MetricSet());
    QCOMPARE(stored.rows.size(), std::size_t(frames + 1));  // b has a time
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("makeReportButton")->isEnabled(), patience);
    auto* table = child<QTableView>("reportTable");
    QCOMPARE(table->model()->rowCount(), frames + 1);
    for (int row = 0; row < table->model()->rowCount(); ++row)
      if (table->model()->index(row, 0).data() == "a, frame 3") table->selectRow(row);
    QTRY_COMPARE_WITH_TIMEOUT(bar()->frame(), 3, patience);
    expectFrame(3);
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->otherImage(), otherAt(3)), patience);
    m_window->grab().save(QCoreApplication::applicationDirPath() + "/frames_report.png");
  }

  /// An edit keeps the frame; at rest there are none.
  void anAnimationHasFrames() {
    writeMoving();
    open("m.json");
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), patience);
    QVERIFY2(words().startsWith("frame 0 of 0 … 4   "), qPrintable(words()));
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), movedAt(0)), patience);
    key(Qt::Key_Period);
    key(Qt::Key_Period);
    key(Qt::Key_Period);
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), movedAt(3)), patience);
    QVERIFY(!(movedAt(3) == movedAt(0)));

    Session content = m_model->session();
    content.lightField.content.set("position", std::vector<double>{0, 0.03, 0});
    m_model->setContent(content);
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), movedAt(3)), patience);
    QCOMPARE(bar()->frame(), 3);
    m_window->grab().save(QCoreApplication::applicationDirPath() + "/frames_animation.png");
    child<QAction>("playFramesAction")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(bar()->frame(), 1, patience);
    child<QAction>("playFramesAction")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), movedAt(bar()->frame())), patience);

    content.lightField.content.set("animation", std::string());
    m_model->setContent(content);
    QTRY_VERIFY_WITH_TIMEOUT(!bar()->isVisible(), patience);
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), movedAt(0)), patience);
  }

  void aFrameThatIsDamagedIsALine() {
    writeFile("scene.3.png", "no picture");  // before it may be read ahead
    open("f.json");
    QTRY_VERIFY_WITH_TIMEOUT(bar()->isVisible(), patience);
    child<QSlider>("frameSlider")->setValue(3);
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("scene.3.png"), patience);
    child<QSlider>("frameSlider")->setValue(1);
    expectFrame(1);
  }
};

int main(int argc, char** argv) {
  return runWindowTest<TestFrames>(argc, argv);
}

#include "test_frames.moc"
