// SPDX-License-Identifier: BSD-3-Clause
// Tests that the rendering thread leaves what takes minutes for a newer request.
#include "gui/view/picture_rate.h"
#include "gui/view/view_worker.h"

#include <QSignalSpy>
#include <QTest>

#include "io/documents/session_file.h"
#include "tests/gui/patience.h"

using namespace hogelscope;

namespace {

/// Of 16384² pixels, which take long, hardly any has a ray: they lie beyond a fold, nearly a double
/// one.
CameraState throughHardLens(CameraState state) {
  state.camera.res = {16384, 16384};
  state.camera.fov = 120;
  state.distortion = {3.2161829187638151, -7.6176025310617304, 2.658602461864341e-06,
                      -2.4475628344116428e-05, 4.5926169078102079};
  return state;
}

CameraState plain(CameraState state) {
  state.camera.res = {64, 48};
  state.distortion = {};
  return state;
}

}  // namespace

class TestViewWorker : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    m_session = loadSession(HOGELSCOPE_SOURCE_DIR "/tests/data/table1.json");
    m_session.cameras.resize(1);
    m_source = loadViewSource(m_session, {});
  }

  void picturesOfTheLastSecond() {
    using namespace std::chrono_literals;
    PictureRate rate;
    const PictureRate::Clock::time_point start;
    for (int k = 0; k < 20; ++k) QCOMPARE(rate.shown(start + k * 100ms), std::min(k + 1, 10));
    QCOMPARE(rate.shown(start + 10s), 1);
  }

  void leavesTheRaysOfAHardLens() {
    ViewWorker worker;
    QSignalSpy loaded(&worker, &ViewWorker::loaded);
    QSignalSpy rendered(&worker, &ViewWorker::rendered);
    worker.load(m_session);
    QVERIFY(loaded.wait(patience));
    worker.render(request(throughHardLens(m_session.cameras[0])));
    QTest::qWait(300);  // now it is at work
    QCOMPARE(rendered.size(), 0);
    worker.render(request(plain(m_session.cameras[0])));
    QVERIFY(rendered.wait(patience));
    QCOMPARE(rendered[0][0].value<RenderedView>().image.size(), QSize(64, 48));
  }

  /// The image is made without the lens, by the paper's mapping; its drawing is not.
  void leavesTheDrawingOfAHardLens() {
    ViewWorker worker;
    QSignalSpy loaded(&worker, &ViewWorker::loaded);
    QSignalSpy rendered(&worker, &ViewWorker::rendered);
    QSignalSpy certified(&worker, &ViewWorker::certified);
    worker.load(m_session);
    QVERIFY(loaded.wait(patience));
    ViewRequest first = request(plain(m_session.cameras[0]));
    // One row that touches a fold so nearly that each of its points needs hundreds of steps.
    first.state.camera.res = {16384, 1};
    first.state.intrinsics = {1e3, 1e3, 20000, 0};
    first.state.distortion = {3.2161829187638151, -7.6176025310617304, 0.01,
                              -0.00011541482921920224, 4.5926169078102079};
    first.method = NamedMethod{"direct", Reconstruction::nearest, 1, LensMapping::direct, {}};
    worker.render(first);
    QVERIFY(rendered.wait(patience));
    QTest::qWait(100);  // now it is at the drawing
    worker.render(request(plain(m_session.cameras[0])));
    QTRY_VERIFY_WITH_TIMEOUT(certified.size() > 0, patience);
    QCOMPARE(certified.last()[0].value<CertifiedLens>().key.res, (std::array{64, 48}));
  }

  /// What takes too long for a moving hand comes with fewer samples of the pupil first, then with
  /// all.
  void aMovingPupilHasFewerSamples() {
    ViewWorker worker;
    QSignalSpy loaded(&worker, &ViewWorker::loaded);
    QSignalSpy rendered(&worker, &ViewWorker::rendered);
    worker.load(m_session);
    QVERIFY(loaded.wait(patience));
    CameraState state = plain(m_session.cameras[0]);
    state.camera.res = {1600, 1200};
    state.pupil = {0.05, 0.4, 1024};
    worker.render(request(state));
    QTRY_COMPARE_WITH_TIMEOUT(rendered.size(), 1, patience);
    const auto viewAt = [&](qsizetype k) { return rendered[k][0].value<RenderedView>(); };
    QCOMPARE(viewAt(0).samples, 0);
    state.pupil.focus = 0.5;
    worker.render(request(state));
    QTRY_COMPARE_WITH_TIMEOUT(rendered.size(), 3, patience);
    QVERIFY2(viewAt(1).samples >= 4 && viewAt(1).samples < 1024,
             qPrintable(QString::number(viewAt(1).samples)));
    QCOMPARE(viewAt(1).image.size(), QSize(1600, 1200));
    QVERIFY(viewAt(2).samples == 0 && viewAt(2).scale == 1);
    QVERIFY(viewAt(2).plan.contains("1024 samples of the pupil"));
  }

 private:
  [[nodiscard]] ViewRequest request(const CameraState& state) const {
    return {state, m_source, {}, {}};
  }

  Session m_session;
  ViewSource m_source;
};

QTEST_GUILESS_MAIN(TestViewWorker)
#include "test_view_worker.moc"
