// SPDX-License-Identifier: BSD-3-Clause
// Drives the real window over a store that the memory allowed cannot hold.
#include <QComboBox>
#include <QLabel>
#include <QSpinBox>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QtTest>

#include "core/engine/fast_simulation.h"
#include "gui/docks/light_field_dock.h"
#include "gui/view/image_widget.h"
#include "gui/view/view_worker.h"
#include "io/documents/session_file.h"
#include "io/store/store_writer.h"
#include "tests/core/rendered.h"
#include "tests/gui/patience.h"
#include "tests/gui/shown_image.h"
#include "tests/gui/window_files.h"
#include "tests/io/documents.h"

using namespace hogelscope;

class TestStoreView : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;
  QString m_session;
  ViewSource m_whole;
  std::vector<CameraState> m_states;
  std::vector<RenderedView> m_views;  ///< all that came to the window
  std::unique_ptr<MainWindow> m_window;

  ImageWidget* view() const { return m_window->findChild<ImageWidget*>("pictureView"); }
  bool shows(const CameraState& state) const {
    return equals(view()->image(), rendered(m_whole.job(state)));
  }

 private Q_SLOTS:
  void initTestCase();
  void init();
  void cleanup() { m_window.reset(); }
  void cleanupTestCase() { allowMemory(0); }
  void theWholeImageFollowsTheOverview();
  void followsTheEye();
  void aPixelIsTraced();
  void aDamagedBlockIsTold();
};

/// The sample's states over its light field as a store.
void TestStoreView::initTestCase() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
  Session session = loadSession(HOGELSCOPE_SOURCE_DIR "/data/table1.json");
  m_whole = loadViewSource(session, {});
  m_states = session.cameras;
  const auto file = openLightField(session.lightField, session.display);
  pack(*file, planPack(session.lightField, *file, session.display, 100000000), "store.tif", 0, {});
  session.lightField = lightFieldOf("store.tif");
  saveSession("s.json", session);
  allowMemory(4000000);
}

void TestStoreView::init() {
  m_views.clear();
  m_window = std::make_unique<MainWindow>();
  m_window->show();
  QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), patience));
  activate(m_window.get());
  connect(m_window->findChild<ViewWorker*>(), &ViewWorker::rendered, this,
          [this](const RenderedView& rendered) { m_views.push_back(rendered); });
  QVERIFY(files(*m_window).open("s.json"));
}

void TestStoreView::theWholeImageFollowsTheOverview() {
  QTRY_VERIFY_WITH_TIMEOUT(shows(m_states[0]), patience);
  QVERIFY(m_views.size() >= 2);
  QVERIFY(m_views.front().isOverview && !m_views.back().isOverview);
  QVERIFY(!equals(m_views.front().image, rendered(m_whole.job(m_states[0]))));
  const auto* dock = m_window->findChild<LightFieldDock*>();
  bool isSaid = false;
  for (const QLabel* label : dock->findChildren<QLabel*>())
    isSaid = isSaid || label->text().contains("in a store, of which each view reads what it needs");
  QVERIFY(isSaid);
}

/// Keys move the camera: something is shown for each, and the whole image in the end.
void TestStoreView::followsTheEye() {
  QTRY_VERIFY_WITH_TIMEOUT(shows(m_states[0]), patience);
  m_views.clear();
  QAction* right = m_window->findChild<QAction*>("strafeRightAction");
  QVERIFY(right != nullptr);
  for (int k = 0; k < 5; ++k) {
    right->trigger();
    const std::size_t before = m_views.size();
    QTRY_VERIFY_WITH_TIMEOUT(m_views.size() > before, patience);
  }
  QTRY_VERIFY_WITH_TIMEOUT(!m_views.back().isOverview, patience);
  QVERIFY(!shows(m_states[0]));
  m_window->findChild<QComboBox*>("stateBox")->setCurrentIndex(3);
  QTRY_VERIFY_WITH_TIMEOUT(shows(m_states[3]), patience);
}

void TestStoreView::aPixelIsTraced() {
  QTRY_VERIFY_WITH_TIMEOUT(shows(m_states[0]), patience);
  Q_EMIT view()->pixelPicked(300, 300);
  const QString text = m_window->findChild<QLabel*>("sceneReadout")->text();
  QVERIFY2(text.contains("Pixel (300, 300): sees the display"), qPrintable(text));
  const QRgb shown = view()->image().pixel(300, 300);
  QVERIFY2(text.contains(QString("colour %1").arg(qRed(shown) / 10)), qPrintable(text));
}

void TestStoreView::aDamagedBlockIsTold() {
  m_window.reset();
  QByteArray bytes = contentOf("store.tif");
  for (qsizetype at = bytes.size() / 4; at < bytes.size() / 2; at += 1500) bytes[at] ^= '\x55';
  writeFile("damaged.tif", bytes);
  writeFile("s2.json", contentOf("s.json").replace("store.tif", "damaged.tif"));
  m_window = std::make_unique<MainWindow>();
  m_window->show();
  QVERIFY(files(*m_window).open("s2.json"));
  const auto line = [this] { return m_window->statusBar()->currentMessage(); };
  QTRY_VERIFY2_WITH_TIMEOUT(line().contains("damaged.tif: "), qPrintable(line()), patience);
  QVERIFY2(line().contains("is damaged"), qPrintable(line()));
}

QTEST_MAIN(TestStoreView)
#include "test_store_view.moc"
