// SPDX-License-Identifier: BSD-3-Clause
// The inspector in the real window: what stands behind a pixel, why one is black, and picks that go
// both ways between picture and scene.
#include <QAction>
#include <QDockWidget>

#include "core/optics/pixel_inspection.h"
#include "gui/docks/parameter_drawings.h"
#include "gui/view/image_widget.h"
#include "gui/widgets/colours.h"
#include "tests/gui/scene_test.h"
#include "tests/gui/shown_image.h"

using namespace hogelscope;

class TestInspector : public SceneTest {
  Q_OBJECT

 private:
  ImageWidget* view() const { return child<ImageWidget>("pictureView"); }
  ImageWidget* hogel() const { return child<ImageWidget>("inspectorHogel"); }
  QString said(const char* name) const { return child<QLabel>(name)->text(); }
  QString verdict() const { return said("inspectorVerdict"); }
  QImage swatch() const {
    for (const QLabel* label : child<QWidget>("inspector")->findChildren<QLabel*>())
      if (!label->pixmap(Qt::ReturnByValue).isNull())
        return label->pixmap(Qt::ReturnByValue).toImage();
    return {};
  }
  /// The widget's place of a pixel.
  QPoint placeOf(const QPoint& pixel) const {
    const double zoom = std::min(view()->width() / 120.0, view()->height() / 120.0);
    const QPointF corner(view()->width() / 2.0 - 60 * zoom, view()->height() / 2.0 - 60 * zoom);
    return (corner + (QPointF(pixel) + QPointF(0.5, 0.5)) * zoom).toPoint();
  }
  void point(const QPoint& pixel) {
    const QPointF at = placeOf(pixel);
    QMouseEvent move(QEvent::MouseMove, at, view()->mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                     Qt::NoModifier);
    QApplication::sendEvent(view(), &move);
  }
  void leave() {
    QEvent away(QEvent::Leave);
    QApplication::sendEvent(view(), &away);
  }
  void pick(const QPoint& pixel) {
    QTest::mouseClick(view(), Qt::LeftButton, {}, placeOf(pixel));
    leave();
  }
  void show(std::size_t state) {
    child<QComboBox>("stateBox")->setCurrentIndex(int(state));
    QTRY_VERIFY_WITH_TIMEOUT(!view()->image().isNull() && message().contains(" ms"), patience);
  }

 private Q_SLOTS:
  void init() {
    startSmall();
    QTest::keyClick(m_window.get(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(child<QWidget>("inspector")->isVisible());
  }
  void cleanup() { m_window.reset(); }

  void showsWhatStandsBehindAPixel() {
    QVERIFY2(verdict().startsWith("Point at a pixel"), qPrintable(verdict()));
    QVERIFY(!hogel()->isVisible());
    const QPoint pixel(70, 80);
    pick(pixel);
    const RenderJob job = m_loaded.job(m_session.cameras[0]);
    const PixelTrace traced = pixelTrace(job, pixel.x(), pixel.y());
    QCOMPARE(verdict(), QString("Sees the display."));
    QVERIFY2(said("inspectorValues").startsWith("Pixel (70, 80): sees the display"),
             qPrintable(said("inspectorValues")));
    QVERIFY(said("inspectorValues").contains(QString::number(traced.slopes.y, 'f', 4)));
    QVERIFY(said("inspectorValues").contains("ray from (0.0000, 0.0000, 0.5590) m to"));
    const auto* around = child<ImageWidget>("inspectorNeighbours");
    QCOMPARE(around->image(), view()->image());
    QCOMPARE(around->viewport().centre, QPointF(70.5, 80.5));
    QCOMPARE(around->markedPixels(), QRegion(70, 80, 1, 1));
    const Hit place = *traced.place;
    QCOMPARE(said("inspectorHogelTitle"),
             QString("Hogel %1, %2").arg(int(place.i)).arg(int(place.j)));
    QVERIFY(equals(hogel()->image(), hogelImage(*job.lightField, int(place.i), int(place.j))));
    QCOMPARE(hogel()->markedPixels(), QRegion(int(place.u), int(place.v), 1, 1));
    const QRect window(int(place.u) - 2, int(place.v) - 2, 5, 5);
    QCOMPARE(hogel()->region(), window & QRect(0, 0, 6, 6));
    QCOMPARE(child<KernelWidget>("inspectorWeights")->weights(),
             psfKernelAt(job.state.psf, job.lightField->size(), int(place.u), int(place.v)));
    QTest::qWait(50);
    m_window->grab().save(QCoreApplication::applicationDirPath() + "/inspector.png");
    // The picture's mark and the scene's ray stay, and go together.
    QCOMPARE(view()->markedPixels(), QRegion(70, 80, 1, 1));
    QVERIFY(scene().picked().hasRay());
    press(Qt::Key_Escape);
    QVERIFY(view()->markedPixels().isEmpty() && !scene().picked().hasRay());
    QVERIFY2(verdict().startsWith("Point at a pixel"), qPrintable(verdict()));
  }

  void followsThePointerAndGoesBack() {
    pick({70, 80});
    const QString picked = said("inspectorValues");
    point({50, 40});
    QVERIFY(said("inspectorValues").startsWith("Pixel (50, 40)"));
    QCOMPARE(view()->markedPixels(), QRegion(70, 80, 1, 1));
    leave();
    QCOMPARE(said("inspectorValues"), picked);
    edit("eye.1", 0.05);  // an edit moves the ray
    QVERIFY(said("inspectorValues") != picked);
    QVERIFY(said("inspectorValues").startsWith("Pixel (70, 80)"));
  }

  /// Each with words and a pattern of its own.
  void saysWhyAPixelIsBlack() {
    const auto black = [&](const QPoint& pixel, const QString& why) {
      point(pixel);
      QVERIFY2(verdict().startsWith(why), qPrintable(verdict()));
    };
    show(1);
    black({0, 0}, "Black, no ray: the lens folds");
    QVERIFY(count(swatch(), tokens().series[3]) > 50);
    show(3);
    black({0, 0}, "Black, outside the panel: its ray passes beside it");
    QVERIFY(!hogel()->isVisible());
    QVERIFY(count(swatch(), tokens().series[0]) > 50);
    show(0);
    m_model->edit("narrow", [](Session& session) { session.display.fov = {4, 4}; });
    black({80, 60}, "Black, outside the viewing zone: the hogel lights 4° × 4°, and direction u ");
    QVERIFY(count(swatch(), tokens().series[1]) > 50);
    QVERIFY(hogel()->isVisible() && hogel()->markedPixels().isEmpty());
  }

  void darkContentIsNoMissingRay() {
    Session session = m_session;
    session.lightField.file = m_folder.filePath("dark.png").toStdString();
    QImage dark(768, 768, QImage::Format_RGB888);
    dark.fill(Qt::black);
    QVERIFY(dark.save(m_folder.filePath("dark.png")));
    open(session);
    point({60, 60});
    QVERIFY2(verdict().startsWith("Black, dark content: it sees the display"),
             qPrintable(verdict()));
    QVERIFY(hogel()->isVisible() && !hogel()->markedPixels().isEmpty());
    QCOMPARE(count(swatch(), Qt::black), 30 * 30);  // but for its frame
  }

  void aHogelMarksThePixelsThatSeeIt() {
    press(Qt::Key_F5);
    const QPoint picked(100, 20);
    const Vec2 middle =
        hogelscope::Display(m_loaded.display).position(picked.x() + 0.5, picked.y() + 0.5);
    click(onScreen({middle.x, middle.y, 0}));
    const auto isRight = [&] {  // near it, since a trace takes milliseconds
      const RenderJob job = *controller()->job();
      const QRegion& marked = view()->markedPixels();
      const QRect box = marked.boundingRect().adjusted(-1, -1, 1, 1) & QRect(0, 0, 120, 120);
      for (int y = box.top(); y <= box.bottom(); ++y)
        for (int x = box.left(); x <= box.right(); ++x) {
          const PixelTrace traced = pixelTrace(job, x, y);
          const bool isSeer = traced.end == RayEnd::seen && int(traced.place->i) == picked.x() &&
                              int(traced.place->j) == picked.y();
          if (isSeer != marked.contains(QPoint(x, y))) return false;
        }
      return !marked.isEmpty();
    };
    QTRY_VERIFY_WITH_TIMEOUT(!view()->markedPixels().isEmpty(), patience);
    QVERIFY(isRight());
    const QString name = QString("Hogel i %1, j %2 at x ").arg(picked.x()).arg(picked.y());
    QVERIFY2(verdict().startsWith(name), qPrintable(verdict()));
    QVERIFY(equals(hogel()->image(), hogelImage(*m_loaded.lightField, picked.x(), picked.y())));
    // An edit moves them.
    const QRegion before = view()->markedPixels();
    edit("eye.1", 0.2);
    QTRY_VERIFY_WITH_TIMEOUT(view()->markedPixels() != before, patience);
    QTRY_VERIFY_WITH_TIMEOUT(isRight(), patience);
    press(Qt::Key_Escape);
    QVERIFY(view()->markedPixels().isEmpty());
  }
};

int main(int argc, char** argv) {
  return runWindowTest<TestInspector>(argc, argv);
}
#include "test_inspector.moc"
