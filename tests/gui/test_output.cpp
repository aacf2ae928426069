// SPDX-License-Identifier: BSD-3-Clause
// Writes what the real window shows: views, scene, plots, animations; and reads the files back.
#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkDataArray.h>
#include <vtkGLTFReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStandardPaths>
#include <QToolButton>
#include <cmath>
#include <map>
#include <opencv2/videoio.hpp>
#include <set>

#include "core/cameras/camera_path.h"
#include "core/engine/scaled_view.h"
#include "gui/docks/plot_saver.h"
#include "gui/docks/tradeoff_widget.h"
#include "gui/files/content_optimiser.h"
#include "gui/files/light_field_output.h"
#include "gui/scene/scene_output.h"
#include "gui/view/comparison.h"
#include "gui/view/image_widget.h"
#include "gui/view/view_output.h"
#include "gui/widgets/task_widgets.h"
#include "io/opening/session_around.h"
#include "optimise/optimise_run.h"
#include "tests/core/rendered.h"
#include "tests/gui/scene_test.h"
#include "tests/gui/shown_image.h"
#include "tests/io/any_images.h"
#include "vtk/scene_export.h"
#include "web/page_files.h"

using namespace hogelscope;

namespace {

/// Accepts the next dialogs: sizes after `prepare` has changed them, files with `file`.
class Answers : public QObject {
 public:
  Answers(std::function<void(QDialog*)> prepare, const QString& file) {
    connect(&m_timer, &QTimer::timeout, this, [this, prepare, file] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr || !dialog->isVisible()) return;
      if (auto* files = qobject_cast<QFileDialog*>(dialog); files != nullptr) {
        m_timer.stop();
        proposed = files->findChild<QLineEdit*>("fileNameEdit")->text();
        files->findChild<QLineEdit*>("fileNameEdit")->setText(file);
      } else {
        prepare(dialog);
      }
      dialog->QDialog::accept();
    });
    m_timer.start(20);
  }
  QString proposed;  ///< the file's name

 private:
  QTimer m_timer;
};

Image readImage(const QString& file) {
  const PictureSpec spec = specOf(file);
  Image image(spec.width, spec.height);
  image.rgb = valuesOf<unsigned char>(file);
  return image;
}

QByteArray contentsOf(const QString& name) {
  QFile file(name);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Red, green and blue of a pixel.
std::array<float, 3> pixel(const std::vector<float>& rgb, int width, int x, int y) {
  const std::size_t at = 3 * (std::size_t(y) * std::size_t(width) + std::size_t(x));
  return {rgb[at], rgb[at + 1], rgb[at + 2]};
}

/// Of two by two pixels; none where one of them is black.
std::optional<std::array<float, 3>> mean(const std::vector<float>& rgb, int width, int x, int y) {
  std::array<float, 3> sum{};
  for (const int down : {0, 1}) {
    for (const int across : {0, 1}) {
      const auto [r, g, b] = pixel(rgb, width, 2 * x + across, 2 * y + down);
      if (r + g + b == 0) return std::nullopt;
      sum = {sum[0] + r / 4, sum[1] + g / 4, sum[2] + b / 4};
    }
  }
  return sum;
}

}  // namespace

class TestOutput : public SceneTest {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void cleanup() { m_window.reset(); }
  void aViewOfDoubleSizeSeesTheSameField();
  void formatsHoldWhatTheyCan();
  void viewsAreAskedFor();
  void theExactPictureIsSavedUnlessAsShown();
  void viewsThatCannotBeWritten();
  void sceneOfDoubleSize();
  void sceneForFigures();
  void sceneInOtherFormats();
  void sceneAsVtp();
  void sceneAsGltf();
  void aMeshStandsInTheWorld();
  void scenesThatCannotBeWritten();
  void aSceneEndsWithItsSession();
  void nothingIsLeftByAClosedWindow();
  void plots();
  void anAnimationIsAllStates();
  void anAnimationIsStopped();
  void aVideo();
  void videosThatCannotBeWritten();
  void otherPaths();
  void lightFields();
  void lightFieldsForAUnit();
  void lightFieldsAreOptimised();
  void longOutputIsStopped();
  void lightFieldsAreAskedFor();
  void pagesAreShared();
  void theDialogSaysWhatIsWrong();
  void withoutFfmpeg();

 private:
  [[nodiscard]] ViewOutput* views() const { return m_window->findChild<ViewOutput*>(); }
  [[nodiscard]] SceneOutput* scenes() const { return m_window->findChild<SceneOutput*>(); }
  [[nodiscard]] QString path(const QString& name) const { return m_folder.filePath(name); }
  /// What the window says when a file is written or not.
  template <class Output, class Begin>
  QString said(Output* output, Begin begin) {
    // Taken at once: a picture that is rendered meanwhile has its own message.
    QString said;
    const QObject context;
    const auto take = [&] { said = message(); };
    connect(output, &Output::done, &context, take);
    connect(output, &Output::failed, &context, take);
    begin();
    (void)QTest::qWaitFor([&] { return !said.isEmpty(); }, patience);
    return said;
  }
  QString savedView(const QString& file, const QSize& size) {
    return said(views(), [&] {
      views()->saveView(file, resized(m_model->current(), {size.width(), size.height()}));
    });
  }
  QString savedScene(const QString& file, const QSize& size) {
    return said(scenes(), [&] { scenes()->savePicture(file, size); });
  }
  QString exported(const QString& file) {
    return said(scenes(), [&] { scenes()->exportTo(file); });
  }
  QString animated(const QString& folder, double scale, const QString& ffmpeg,
                   const CameraPath& way = {}) {
    return said(views(), [&] { views()->saveAnimation(way, folder, scale, ffmpeg, 5); });
  }
  [[nodiscard]] QString leftIn(const QString& folder) const {
    return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).join(' ');
  }
};

void TestOutput::init() {
  startSmall();
  QVERIFY(QDir(path("out")).removeRecursively());
  QVERIFY(QDir().mkpath(path("out")));
}

/// Two by two rays in a pixel are those of the four pixels in its place; of a calibrated camera
/// with a lens, whose axis is not in the middle.
void TestOutput::aViewOfDoubleSizeSeesTheSameField() {
  CameraState state = m_model->current();
  QVERIFY(state.distortion.k1 != 0);
  state.intrinsics = {130, 120, 55, 63};
  m_model->setCurrent(state);
  const QString file = path("out/double.exr");
  QVERIFY(savedView(file, {240, 240}).contains("Saved " + file));
  QCOMPARE(specOf(file).width, 240);
  QCOMPARE(specOf(file).height, 240);
  const std::vector<float> found = valuesOf<float>(file);
  RenderJob job = m_loaded.job(state);
  job.sampling.tolerance = 0;
  job.sampling.samplesPerPixel = 2;
  const FloatImage expected = Renderer(serialRows).renderFloat(job);
  int compared = 0;
  int equal = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 120; ++x) {
      const auto four = mean(found, 240, x, y);
      if (!four) continue;
      const auto one = pixel(expected.rgb, 120, x, y);
      ++compared;
      bool isEqual = true;
      for (const std::size_t c : {0, 1, 2}) isEqual &= std::abs((*four)[c] - one[c] / 255) < 1e-4;
      equal += isEqual ? 1 : 0;
    }
  }
  QVERIFY2(compared > 5000, qPrintable(QString::number(compared)));
  QVERIFY2(equal > 0.98 * compared, qPrintable(QString("%1 of %2").arg(equal).arg(compared)));
}

/// In the session's own size they are the pictures of --render.
void TestOutput::formatsHoldWhatTheyCan() {
  const RenderJob job = m_loaded.job(m_model->current());
  const Image expected = rendered(job);
  const FloatImage whole = Renderer(serialRows).renderFloat(job);
  const QSize size(120, 120);
  QVERIFY(savedView(path("out/a.png"), size).contains("Saved"));
  QCOMPARE(specOf(path("out/a.png")).type, PictureType::UInt8);
  QCOMPARE(valuesOf<unsigned char>(path("out/a.png")), expected.rgb);
  QVERIFY(savedView(path("out/a.tif"), size).contains("Saved"));
  QCOMPARE(specOf(path("out/a.tif")).type, PictureType::UInt16);
  QVERIFY(savedView(path("out/a.exr"), size).contains("Saved"));
  QCOMPARE(specOf(path("out/a.exr")).type, PictureType::Float);
  const auto deep = valuesOf<unsigned short>(path("out/a.tif"));
  const auto floats = valuesOf<float>(path("out/a.exr"));
  QCOMPARE(floats.size(), whole.rgb.size());
  int unequal = 0;
  for (std::size_t k = 0; k < floats.size(); ++k) {
    if (std::abs(floats[k] - whole.rgb[k] / 255) > 1e-6) ++unequal;
    if (std::abs(double(deep[k]) / 65535 - double(whole.rgb[k]) / 255) > 1e-5) ++unequal;
  }
  QCOMPARE(unequal, 0);
}

void TestOutput::viewsAreAskedFor() {
  const QString file = path("out/asked.tif");
  const Answers answers(
      [](QDialog* dialog) {
        auto* width = dialog->findChild<QSpinBox*>("widthBox");
        QCOMPARE(width->value(), 120);
        width->setValue(60);
      },
      file);
  QSignalSpy done(views(), &ViewOutput::done);
  QVERIFY(child<QAction>("saveViewAction")->isEnabled());
  key(Qt::Key_E, Qt::ControlModifier | Qt::AltModifier);
  QCOMPARE(answers.proposed, QString::fromStdString(m_model->current().camera.name) + ".png");
  QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, patience);
  QCOMPARE(specOf(file).width, 60);
  QCOMPARE(specOf(file).height, 60);
}

/// With a gain the shown picture is another one, and its name says so.
void TestOutput::theExactPictureIsSavedUnlessAsShown() {
  auto* view = child<ImageWidget>("pictureView");
  QTRY_VERIFY_WITH_TIMEOUT(!view->image().isNull() && view->notice().isEmpty(), patience);
  view->setGain(2);
  const QString name = QString::fromStdString(m_model->current().camera.name);
  for (const bool isShown : {false, true}) {
    const QString file = path(isShown ? "out/shown.png" : "out/exact.png");
    const Answers answers(
        [isShown](QDialog* dialog) {
          for (auto* button : dialog->findChildren<QPushButton*>())
            if (button->text().contains(isShown ? "As shown" : "Exact, 120 × 120 px"))
              button->click();
        },
        file);
    child<QAction>("savePictureAction")->trigger();
    QCOMPARE(answers.proposed, name + (isShown ? " (× 2).png" : ".png"));
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(file), patience);
  }
  QTRY_COMPARE_WITH_TIMEOUT(QImage(path("out/exact.png")).size(), QSize(120, 120), patience);
  const auto colours = [](const QImage& image) {
    return image.convertToFormat(QImage::Format_RGB888);
  };
  QCOMPARE(colours(QImage(path("out/exact.png"))), colours(view->image()));
  QVERIFY(colours(QImage(path("out/shown.png"))) != colours(view->image()));
}

/// One line that names the file, which is not there then.
void TestOutput::viewsThatCannotBeWritten() {
  const QSize size(120, 120);
  QVERIFY(savedView(path("missing/a.png"), size).contains("missing: cannot be written"));
  QVERIFY(savedView("/proc/a.png", size).contains("/proc: cannot be written"));
  QVERIFY(savedView(path("out/a.abc"), size).contains("no picture format has the extension"));
  const QByteArray before = contentsOf(path("scene.png"));
  QVERIFY(savedView(path("scene.png"), size).contains("which is read: choose another name"));
  QVERIFY(contentsOf(path("scene.png")) == before);
  CameraState state = m_model->current();
  state.camera.lookat = state.camera.eye;
  m_model->setCurrent(state);
  QVERIFY(savedView(path("out/a.png"), size).contains("lookat"));
  QCOMPARE(leftIn(path("out")), QString());
  QVERIFY(child<QAction>("saveViewAction")->isEnabled());
}

/// The same picture, finer, and the window is as it was.
void TestOutput::sceneOfDoubleSize() {
  press(Qt::Key_F5);
  QTRY_COMPARE_WITH_TIMEOUT(scene().panel().gridLines(), 0, patience);
  QImage before, last;
  do {  // until nothing is drawn any more
    before = drawn();
    QTest::qWait(300);
    last = drawn();
  } while (last != before);
  const QSize size = 2 * before.size();
  const QString file = path("out/scene.png");
  QVERIFY(savedScene(file, size).contains("Saved " + file));
  const QImage picture(file);
  QCOMPARE(picture.size(), size);
  const QImage small =
      picture.scaled(before.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  int near = 0;
  for (int y = 0; y < small.height(); ++y)
    for (int x = 0; x < small.width(); ++x)
      near += distance(small.pixelColor(x, y), before.pixelColor(x, y)) < 60 ? 1 : 0;
  const double share = double(near) / (small.width() * small.height());
  QVERIFY2(share > 0.95, qPrintable(QString::number(share)));
  // The current state's frustum, which is 3 px thick, lies on those of other states.
  const QColor orange = tokens().eye;
  const double thick = double(count(picture, orange)) / count(before, orange);
  QVERIFY2(thick > 2.5 && thick < 6, qPrintable(QString::number(thick)));
  QTest::qWait(100);
  const QImage after = drawn();
  QCOMPARE(after.size(), before.size());
  QVERIFY(std::abs(count(after, orange) - count(before, orange)) < 20);
}

/// Corners are background, and what is in the scene stands before it, in the light scheme's ink.
void TestOutput::sceneForFigures() {
  press(Qt::Key_F5);
  QTest::qWait(200);
  const QColor shown = drawn().pixelColor(2, 2);
  const auto saved = [this](const QString& name, SceneBackground background) {
    return said(scenes(), [&] { scenes()->savePicture(path(name), {600, 400}, background); });
  };
  QVERIFY(saved("out/white.png", SceneBackground::white).contains("Saved"));
  const QImage white(path("out/white.png"));
  QCOMPARE(white.pixelColor(2, 2), QColor(Qt::white));
  QVERIFY(!white.hasAlphaChannel());
  QVERIFY(count(white, lightTokens().eye) > 50);
  for (const char* name : {"out/clear.png", "out/clear.tif"}) {
    QVERIFY(saved(name, SceneBackground::transparent).contains("Saved"));
    QCOMPARE(specOf(path(name)).channels, 4);
    const auto values = valuesOf<unsigned char>(path(name));
    QCOMPARE(values[4 * (2 * 600 + 2) + 3], 0);
    QCOMPARE(values[4 * (200 * 600 + 300) + 3], 255);  // the panel
    // Half covered pixels have the colour of what covers them, not one mixed with black.
    int edges = 0;
    for (std::size_t at = 0; at < values.size(); at += 4) {
      const int alpha = values[at + 3];
      if (alpha <= 60 || alpha >= 160) continue;
      const QColor colour(values[at], values[at + 1], values[at + 2]);
      if (distance(colour, lightTokens().axes[1]) < 30) ++edges;
    }
    QVERIFY2(edges > 10, qPrintable(QString::number(edges)));
  }
  QVERIFY(saved("out/clear.jpg", SceneBackground::transparent).contains("transparent"));
  QVERIFY(!QFileInfo::exists(path("out/clear.jpg")));
  QTest::qWait(100);
  QCOMPARE(drawn().pixelColor(2, 2), shown);
}

void TestOutput::sceneInOtherFormats() {
  for (const char* name : {"out/s.tif", "out/s.exr", "out/s.jpg"}) {
    QVERIFY(savedScene(path(name), {300, 200}).contains("Saved"));
    QCOMPARE(specOf(path(name)).width, 300);
    QCOMPARE(specOf(path(name)).height, 200);
    const auto values = valuesOf<float>(path(name));
    QVERIFY(*std::max_element(values.begin(), values.end()) > 0.5F);
  }
}

void TestOutput::sceneAsVtp() {
  const QString file = path("out/scene.vtp");
  QVERIFY(exported(file).contains("Saved " + file));
  const vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.toUtf8().constData());
  reader->Update();
  vtkPolyData* all = reader->GetOutput();
  vtkDataArray* parts = all->GetCellData()->GetArray("Part");
  vtkDataArray* states = all->GetCellData()->GetArray("State");
  QVERIFY(parts != nullptr && states != nullptr);
  QVERIFY(all->GetPointData()->GetArray("Colour") != nullptr);
  std::map<int, int> cells;
  std::set<int> seen;
  Vec3 least{1e9, 1e9, 1e9};
  Vec3 most = -1.0 * least;
  for (vtkIdType k = 0; k < all->GetNumberOfCells(); ++k) {
    ++cells[int(parts->GetTuple1(k))];
    seen.insert(int(states->GetTuple1(k)));
    QCOMPARE(states->GetTuple1(k) >= 0, parts->GetTuple1(k) == 2);
    if (parts->GetTuple1(k) != 0) continue;
    std::array<double, 6> box{};
    all->GetCellBounds(k, box.data());
    least = {box[0], box[2], box[4]};
    most = {box[1], box[3], box[5]};
  }
  QCOMPARE(cells[0], 1);
  QCOMPARE(cells[1], 2 * 129);
  QCOMPARE(cells[2], 10 * int(m_session.cameras.size()));
  QCOMPARE(seen.size(), m_session.cameras.size() + 1);
  QVERIFY(isNear(least, {-0.25, -0.25, 0}, 1e-6));
  QVERIFY(isNear(most, {0.25, 0.25, 0}, 1e-6));
  QVERIFY(std::abs(all->GetBounds()[5] - m_session.cameras[0].camera.eye.z) < 1e-3);
}

/// A panel with its picture, and frusta and cameras at the eyes.
void TestOutput::sceneAsGltf() {
  const QString file = path("out/scene.gltf");
  QVERIFY(exported(file).contains("Saved " + file));
  QCOMPARE(leftIn(path("out")), QString("scene.gltf"));  // buffers and picture are inside
  const QJsonObject root = QJsonDocument::fromJson(contentsOf(file)).object();
  QCOMPARE(root["asset"]["version"].toString(), QString("2.0"));
  QCOMPARE(root["meshes"].toArray().size(), 3);
  QCOMPARE(root["images"].toArray().size(), 1);
  QCOMPARE(root["cameras"].toArray().size(), qsizetype(m_session.cameras.size()));
  const CameraState& state = m_session.cameras[3];
  const QJsonObject node = root["nodes"].toArray()[3 + 3].toObject();
  QCOMPARE(node["name"].toString().toStdString(), state.camera.name);
  const QJsonObject lens = root["cameras"].toArray()[3].toObject()["perspective"].toObject();
  QVERIFY(std::abs(lens["yfov"].toDouble() - radians(state.camera.fov)) < 1e-9);
  QCOMPARE(lens["aspectRatio"].toDouble(), 1.0);
  const auto column = [matrix = node["matrix"].toArray()](int k) {
    return Vec3{matrix[4 * k].toDouble(), matrix[4 * k + 1].toDouble(),
                matrix[4 * k + 2].toDouble()};
  };
  QCOMPARE(node["matrix"].toArray()[15].toDouble(), 1.0);
  QVERIFY(isNear(column(3), state.camera.eye, 1e-9));
  QVERIFY(isNear(-1.0 * column(2), normalise(state.camera.lookat - state.camera.eye), 1e-9));
  QVERIFY(column(1).y > 0.5);
  QVERIFY(isNear(cross(column(0), column(1)), column(2), 1e-9));
  const vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(file.toUtf8().constData());
  reader->Update();
  const vtkNew<vtkAppendPolyData> all;
  const vtkSmartPointer<vtkCompositeDataIterator> each = vtk::TakeSmartPointer(
      vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0))->NewIterator());
  for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
    all->AddInputData(vtkPolyData::SafeDownCast(each->GetCurrentDataObject()));
  all->Update();
  QCOMPARE(all->GetOutput()->GetNumberOfPolys(), 2);
  QCOMPARE(all->GetOutput()->GetNumberOfLines(),
           2 * 129 + 10 * vtkIdType(m_session.cameras.size()));
  double farthest = 0;
  for (const QJsonValue& accessor : root["accessors"].toArray())
    if (accessor["type"].toString() == "VEC3" && accessor["max"].isArray())
      farthest = std::max(farthest, accessor["max"][2].toDouble());
  QVERIFY(std::abs(farthest - m_session.cameras[0].camera.eye.z) < 1e-3);
}

/// It comes in the display's frame.
void TestOutput::aMeshStandsInTheWorld() {
  plugin::Triangles triangle;
  triangle.points = {0.1F, 0, 0, 0, 0.2F, 0, 0, 0, 0.3F};
  triangle.corners = {0, 1, 2};
  triangle.colours = {10, 20, 30, 40, 50, 60, 70, 80, 90};
  SceneParts parts{m_loaded.display, {}, toVtkMesh(triangle), nullptr};
  parts.display.position = {1, 2, 3};
  parts.display.orientation = {0, 90, 0};  // its x is the world's -z, its z the world's x
  exportScene(path("out/mesh.vtp").toStdString(), parts);
  const vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path("out/mesh.vtp").toUtf8().constData());
  reader->Update();
  vtkPolyData* all = reader->GetOutput();
  const vtkIdType first = all->GetNumberOfPoints() - 3;
  const auto point = [all](vtkIdType k) {
    const double* p = all->GetPoint(k);
    return Vec3{p[0], p[1], p[2]};
  };
  QVERIFY(isNear(point(first), {1, 2, 2.9}, 1e-6));
  QVERIFY(isNear(point(first + 1), {1, 2.2, 3}, 1e-6));
  QVERIFY(isNear(point(first + 2), {1.3, 2, 3}, 1e-6));
  vtkDataArray* colours = all->GetPointData()->GetArray("Colour");
  QCOMPARE(colours->GetComponent(first + 1, 0), 40.0);
  // Of the cells polygons come last: the panel, then the mesh.
  QCOMPARE(all->GetCellData()->GetArray("Part")->GetTuple1(all->GetNumberOfCells() - 1), 3.0);
  exportScene(path("out/mesh.gltf").toStdString(), parts);
  const QJsonObject root = QJsonDocument::fromJson(contentsOf(path("out/mesh.gltf"))).object();
  QCOMPARE(root["nodes"].toArray().last().toObject()["name"].toString(), QString("mesh"));
  QVERIFY(!root.contains("cameras"));
}

void TestOutput::scenesThatCannotBeWritten() {
  QVERIFY(exported(path("out/a.obj")).contains("a.obj: cannot be written: a scene's extension is"));
  QVERIFY(exported(path("missing/a.vtp")).contains("missing"));
  QVERIFY(savedScene(path("missing/a.png"), {30, 20}).contains("missing"));
  QVERIFY(savedScene(path("out/huge.png"), {200000, 20}).contains("OpenGL ends at"));
  QCOMPARE(leftIn(path("out")), QString());
  QVERIFY(child<QAction>("saveSceneAction")->isEnabled());
}

/// It would be of another scene.
void TestOutput::aSceneEndsWithItsSession() {
  QSignalSpy done(scenes(), &SceneOutput::done);
  QSignalSpy failed(scenes(), &SceneOutput::failed);
  scenes()->savePicture(path("out/a.png"), {3000, 3000});
  QVERIFY(child<ReadingBar>("sceneOutputBar")->isVisible());
  QVERIFY(!child<QAction>("saveSceneAction")->isEnabled());
  open(m_session);
  QCOMPARE(done.size(), 0);
  QCOMPARE(failed.size(), 1);
  QVERIFY(failed[0][0].toString().contains("a.png: not written: another session opens"));
  QCOMPARE(leftIn(path("out")), QString());
  QVERIFY(!child<ReadingBar>("sceneOutputBar")->isVisible());
  QVERIFY(child<QAction>("saveSceneAction")->isEnabled());
}

/// Closing the window stops what is written.
void TestOutput::nothingIsLeftByAClosedWindow() {
  views()->saveAnimation({}, path("out/frames"), 30, {}, 10);
  QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path("out/frames")), patience);
  m_window.reset();
  QCOMPARE(leftIn(path("out/frames")), QString());
}

void TestOutput::plots() {
  const auto saver = [this](const char* plot) {
    return child<QWidget>(plot)->findChild<PlotSaver*>();
  };
  const auto save = [this](QWidget* plot, const QString& file) {
    const Answers answers([](QDialog*) {}, file);
    plot->actions().first()->trigger();
    QVERIFY(message().contains("Saved " + file));
  };
  CameraState state = m_model->current();
  state.distortion = {};
  state.distortion.k1 = 0.296;
  state.distortion.k2 = -1.035;  // folds within the picture
  m_model->setCurrent(state);
  QTRY_VERIFY_WITH_TIMEOUT(child<QWidget>("lensView")->isEnabled(), patience);
  save(child<QWidget>("lensView"), path("out/lens.svg"));
  const QString lens = QString::fromUtf8(contentsOf(path("out/lens.svg")));
  QVERIFY(lens.contains("<title>Lens</title>") && lens.contains("<polyline"));
  QVERIFY(lens.contains("#c82828"));  // the fold
  save(child<QWidget>("kernelView"), path("out/kernel.png"));
  QCOMPARE(QImage(path("out/kernel.png")).size(), QSize(800, 848));
  auto* chart = child<TradeoffChartWidget>("tradeoffChart");
  QVERIFY(!chart->actions().first()->isEnabled());
  TradeoffRow row;
  row.method = "a method";
  setTimes(row, {3});
  row.rmse = 0.5;
  chart->setChart(TradeoffChart({row}, "Error"));
  save(chart, path("out/chart.svg"));
  QVERIFY(contentsOf(path("out/chart.svg")).contains("a method"));
  saver("lensView")->save(path("out/lens.pdf"));
  QVERIFY(message().contains("a plot's extension is .svg or .png, not \".pdf\""));
  saver("lensView")->save(path("missing/lens.svg"));
  QVERIFY(message().contains("missing"));
  QVERIFY(!QFile::exists(path("out/lens.pdf")));
}

void TestOutput::anAnimationIsAllStates() {
  const QString folder = path("out/frames");
  QVERIFY(animated(folder, 0.5, {})
              .contains(QString("Saved %1 pictures in ").arg(m_session.cameras.size())));
  QCOMPARE(QDir(folder).entryList(QDir::Files).size(), qsizetype(m_session.cameras.size()));
  const QString last =
      folder + QString("/frame_%1.png").arg(m_session.cameras.size(), 4, 10, QChar('0'));
  QCOMPARE(specOf(last).width, 60);
  const Image own = readImage(folder + "/frame_0002.png");
  CameraState state = m_session.cameras[1];
  state.camera.res = {60, 60};  // a pinhole with a field of view sees the same then
  QVERIFY(!state.intrinsics.isGiven());
  const Image expected = rendered(m_loaded.job(state));
  int unequal = 0;
  for (std::size_t k = 0; k < own.rgb.size(); ++k) unequal += own.rgb[k] != expected.rgb[k] ? 1 : 0;
  QVERIFY2(unequal < 100, qPrintable(QString::number(unequal)));
  // Frames that are there stay.
  const QByteArray before = contentsOf(folder + "/frame_0001.png");
  QVERIFY(animated(folder, 1, {}).contains("frame_0001.png: is there already"));
  QVERIFY(contentsOf(folder + "/frame_0001.png") == before);
}

void TestOutput::anAnimationIsStopped() {
  const QString folder = path("out/stopped");
  QSignalSpy done(views(), &ViewOutput::done);
  views()->saveAnimation({}, folder, 30, {}, 10);
  auto* bar = child<ReadingBar>("outputBar");
  QVERIFY(bar->isVisible());
  QVERIFY(!child<QAction>("saveAnimationAction")->isEnabled());
  QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(folder), patience);  // and the window lives
  QTest::mouseClick(bar->findChild<QToolButton*>(), Qt::LeftButton);
  QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, patience);
  QVERIFY(message().contains("Stopped; nothing was written"));
  QCOMPARE(leftIn(folder), QString());
  QVERIFY(!bar->isVisible());
  QVERIFY(child<QAction>("saveAnimationAction")->isEnabled());
}

void TestOutput::aVideo() {
  const QString ffmpeg = QStandardPaths::findExecutable("ffmpeg");
  if (ffmpeg.isEmpty()) QSKIP("no ffmpeg in PATH");
  const QString folder = path("out/video");
  const double odd = 61.0 / 120;  // an odd side
  QVERIFY(animated(folder, odd, ffmpeg).contains("Saved"));
  cv::VideoCapture video((folder + "/animation.mp4").toStdString());
  QVERIFY(video.isOpened());
  QCOMPARE(int(video.get(cv::CAP_PROP_FRAME_COUNT)), int(m_session.cameras.size()));
  QCOMPARE(video.get(cv::CAP_PROP_FPS), 5.0);
  QCOMPARE(int(video.get(cv::CAP_PROP_FRAME_WIDTH)), 62);
  cv::Mat frame;
  QVERIFY(video.read(frame) && video.read(frame));
  const Image second = readImage(folder + "/frame_0002.png");
  double sum = 0;
  for (int y = 0; y < 61; ++y)
    for (int x = 0; x < 61; ++x)
      for (int c = 0; c < 3; ++c)
        sum += std::abs(frame.at<cv::Vec3b>(y, x)[2 - c] -
                        second.rgb[3 * std::size_t(61 * y + x) + std::size_t(c)]);
  QVERIFY2(sum / (3 * 61 * 61) < 12, qPrintable(QString::number(sum / (3 * 61 * 61))));
}

/// Nothing is left of the pictures either.
void TestOutput::videosThatCannotBeWritten() {
  const QString folder = path("out/none");
  QVERIFY(animated(folder, 1, "/bin/false").contains("animation.mp4: cannot be written: ffmpeg:"));
  QCOMPARE(leftIn(folder), QString());
  QVERIFY(animated(folder, 1, "/nowhere/ffmpeg").contains("/nowhere/ffmpeg: cannot be started"));
  QCOMPARE(leftIn(folder), QString());
  CameraState state = m_model->current();
  state.camera.res = {100, 50};
  m_model->setCurrent(state);
  QVERIFY(animated(folder, 1, "/bin/false").contains("differs from that of"));
  QVERIFY(animated("/proc/frames", 1, {}).contains("/proc: cannot be written"));
}

/// Their pictures are those of the states along the path.
void TestOutput::otherPaths() {
  const CameraPath between{PathKind::between, 3};
  QVERIFY(animated(path("out/between"), 1, {}, between).contains("Saved"));
  const std::size_t count = 4 * m_session.cameras.size() - 3;
  QCOMPARE(QDir(path("out/between")).entryList(QDir::Files).size(), qsizetype(count));
  const CameraPath orbit{PathKind::orbit, 4, 30};
  QVERIFY(animated(path("out/orbit"), 1, {}, orbit).contains("Saved 4 pictures"));
  CameraState eye = m_session.cameras[0];
  eye.pupil.diameter = 0.004;
  m_model->setCurrent(eye);
  const CameraPath focus{PathKind::focus, 3};
  QVERIFY(animated(path("out/focus"), 1, {}, focus).contains("Saved 3 pictures"));
  m_session.cameras[0] = eye;
  for (const auto& [way, name] :
       {std::pair(between, "between"), std::pair(orbit, "orbit"), std::pair(focus, "focus")}) {
    const CameraState state = statesAlong(way, m_session, 0)[2];
    const Image found = readImage(path(QString("out/%1/frame_0003.png").arg(name)));
    QVERIFY(found.rgb == rendered(m_loaded.job(state)).rgb);
  }
}

/// The files are those of the functions of batch mode.
void TestOutput::lightFields() {
  auto* output = m_window->findChild<LightFieldOutput*>();
  const auto saved = [&](ExportLayout layout, const QString& name) {
    return said(output, [&] { output->save(layout, path("out/" + name)); });
  };
  for (const auto& [layout, name] :
       {std::pair(ExportLayout::hogels, "h.png"), std::pair(ExportLayout::mosaic, "m.png")}) {
    QVERIFY2(saved(layout, name).contains("Saved"), name);
    const auto content = contentToExport(m_session, layout, false);
    exportAs(layout, m_session, *content, path(QString("out/own_%1").arg(name)).toStdString(), {});
    QVERIFY(!contentsOf(path(QString("out/%1").arg(name))).isEmpty());
    QCOMPARE(contentsOf(path(QString("out/%1").arg(name))),
             contentsOf(path(QString("out/own_%1").arg(name))));
  }
  QVERIFY(saved(ExportLayout::views, "views").contains("Saved"));
  QVERIFY(saved(ExportLayout::pack, "store.tif").contains("Saved"));
  // What was written gives the same view.
  const Image wanted = rendered(m_loaded.job(m_session.cameras[0]));
  for (const char* name : {"h.png", "views", "store.tif"}) {
    const Session other =
        withLightField(m_session, path(QString("out/%1").arg(name)).toStdString());
    QVERIFY2(rendered(loadViewSource(other, {}).job(m_session.cameras[0])).rgb == wanted.rgb, name);
  }
  QVERIFY(saved(ExportLayout::quilt, "q.png").contains("a quilt has one row of directions"));
  QVERIFY(!QFileInfo::exists(path("out/q.png")));
  QVERIFY(saved(ExportLayout::hogels, "no/h.png").contains("no"));
  // No input is replaced.
  const QString input = QString::fromStdString(contentName(m_session.lightField));
  const QByteArray before = contentsOf(input);
  QVERIFY(said(output, [&] { output->save(ExportLayout::hogels, input); }).startsWith("Error"));
  QCOMPARE(contentsOf(input), before);
}

/// Through its unit the corrected content looks as the session's own does on the design.
void TestOutput::lightFieldsForAUnit() {
  Session built = m_session;
  built.twin.lensArray.offset = {built.display.size[0] / 100, 0};
  m_model->setContent(built);
  auto* output = m_window->findChild<LightFieldOutput*>();
  QVERIFY(said(output, [&] {
            output->save(ExportLayout::hogels, path("out/unit.png"), true);
          }).contains("Saved"));
  const auto content = contentToExport(built, ExportLayout::hogels, true);
  exportAs(ExportLayout::hogels, built, *content, path("out/own.png").toStdString(), {});
  QCOMPARE(contentsOf(path("out/unit.png")), contentsOf(path("out/own.png")));
}

/// The file is that of batch mode, and is compared with the session's own light field.
void TestOutput::lightFieldsAreOptimised() {
  CameraState state = m_model->current();
  state.psf = {0.67, 5};
  m_model->setCurrent(state);
  const Answers answers(
      [](QDialog* dialog) {
        auto* layouts = dialog->findChild<QComboBox*>("optimiseLayoutBox");
        QVERIFY(layouts != nullptr);
        QCOMPARE(layouts->count(), 3);
      },
      path("out/optimised.png"));
  QSignalSpy done(m_window->findChild<ContentOptimiser*>(), &ContentOptimiser::done);
  child<QPushButton>("optimiseButton")->click();
  QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, patience);
  QCOMPARE(answers.proposed, QString("optimised.png"));
  const QString line = done[0][0].toString();
  QVERIFY2(line.contains("held-out eyes") && line.contains("optimised.html"), qPrintable(line));
  const OptimiseRequest request{"own",
                                m_model->session(),
                                ExportLayout::hogels,
                                path("out/own_optimised.png").toStdString(),
                                {}};
  const auto content = optimisedContent(request.session, {});
  QVERIFY(optimise(request, *content, {}).has_value());
  QCOMPARE(contentsOf(path("out/optimised.png")), contentsOf(path("out/own_optimised.png")));
  auto* comparison = m_window->findChild<Comparison*>();
  QTRY_VERIFY_WITH_TIMEOUT(!comparison->isReading(), patience);
  QVERIFY2(comparison->name().contains("optimised"), qPrintable(comparison->name()));
}

/// The button beside the bar; no file is left behind.
void TestOutput::longOutputIsStopped() {
  Session large = m_session;
  LightFieldParams live;
  live.layout = Layout::live;
  large.lightField = withDefaults(m_session.lightField, live);
  large.display.hogels = {256, 256};
  large.display.directions = {80, 80};
  large.cameras[0].psf = {0.67, 5};
  m_model->setContent(large);
  m_model->setCurrent(large.cameras[0]);
  const auto stopped = [&](auto* output, const char* bar, const QString& name) {
    QSignalSpy done(output, &FileOutput::done);
    output->save(ExportLayout::hogels, path("out/" + name));
    QTRY_VERIFY_WITH_TIMEOUT(child<QWidget>(bar)->isVisible(), patience);
    QTest::qWait(300);
    child<QWidget>(bar)->findChild<QToolButton*>()->click();
    QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, patience);
    QVERIFY2(done[0][0].toString().contains("Stopped"), qPrintable(done[0][0].toString()));
    QVERIFY(!QFileInfo::exists(path("out/" + name)));
  };
  stopped(m_window->findChild<LightFieldOutput*>(), "exportBar", "stopped.png");
  stopped(m_window->findChild<ContentOptimiser*>(), "optimiseBar", "unsolved.png");
  QVERIFY(QDir(path("out")).entryList({"stopped*", "unsolved*"}).isEmpty());
}

void TestOutput::lightFieldsAreAskedFor() {
  int asked = 0;
  const Answers answers(
      [&](QDialog* dialog) {
        auto* layouts = dialog->findChild<QComboBox*>("exportLayoutBox");
        auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        const auto help = [&] { return dialog->findChild<QLabel*>("exportHelp")->text(); };
        QVERIFY(dialog->findChild<QCheckBox*>("forTwinBox")->isHidden());
        QStringList titles;
        for (int k = 0; k < layouts->count(); ++k) titles << layouts->itemText(k);
        QCOMPARE(titles, QStringList({"Hogels", "Views", "Quilt", "Mosaic", "Store"}));
        layouts->setCurrentIndex(2);
        QVERIFY2(help().contains("one row of directions") && !ok->isEnabled(), qPrintable(help()));
        layouts->setCurrentIndex(3);
        QVERIFY(help().contains("top left tile") && ok->isEnabled());
        ++asked;
      },
      path("out/mosaic.png"));
  QSignalSpy done(m_window->findChild<LightFieldOutput*>(), &LightFieldOutput::done);
  child<QAction>("exportLightFieldAction")->trigger();
  QCOMPARE(asked, 1);
  QCOMPARE(answers.proposed, QString("mosaic.png"));
  QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, patience);
  QVERIFY(QFileInfo::exists(path("out/mosaic.png")));
}

/// The page is asked for with its size, and has the session's states.
void TestOutput::pagesAreShared() {
  if (pageEngine().empty()) QSKIP("this program was built without the engine for pages");
  const Answers answers([](QDialog*) {}, path("out/shared.html"));
  QSignalSpy done(m_window->findChild<LightFieldOutput*>(), &LightFieldOutput::done);
  child<QAction>("sharePageAction")->trigger();
  QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, patience);
  QCOMPARE(answers.proposed, QString("page.html"));
  const QByteArray page = contentsOf(path("out/shared.html"));
  for (const CameraState& state : m_model->session().cameras)
    QVERIFY(page.contains(QByteArray::fromStdString(state.camera.name)));
  QVERIFY(page.contains("data-exact=\"yes\"") && !page.contains(m_folder.path().toUtf8()));
}

/// What is wrong is said before anything is rendered, and keeps the dialog open.
void TestOutput::theDialogSaysWhatIsWrong() {
  const QString folder = path("out/new/one");
  writeFile(path("out/old/frame_0001.png"), "mine");
  CameraState state = m_model->current();
  state.camera.res = {60, 50};
  m_model->setCurrent(state);
  int asked = 0;
  const Answers answers(
      [&](QDialog* dialog) {
        auto* way = dialog->findChild<QComboBox*>("pathBox");
        auto* field = dialog->findChild<QLineEdit*>("folderField");
        auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        const auto problem = [&] { return dialog->findChild<QLabel*>("problemLabel")->text(); };
        dialog->findChild<QCheckBox*>("videoBox")->setChecked(false);
        QCOMPARE(problem(), QString("Choose a folder."));
        QVERIFY(!ok->isEnabled());
        field->setText(path("out/old"));
        QVERIFY(problem().contains("frame_0001.png: is there already") && !ok->isEnabled());
        field->setText("/proc/a/b");
        QVERIFY(problem().contains("/proc: cannot be written") && !ok->isEnabled());
        field->setText(folder);
        QVERIFY(problem().isEmpty() && ok->isEnabled());
        QCOMPARE(way->currentIndex(), int(PathKind::between));
        dialog->findChild<QSpinBox*>("countBox")->setValue(3);
        QVERIFY(problem().contains("differs from that of") && !ok->isEnabled());
        way->setCurrentIndex(int(PathKind::turntable));
        QVERIFY(problem().isEmpty() && ok->isEnabled());
        dialog->findChild<QSpinBox*>("countBox")->setValue(5);
        ++asked;
      },
      {});
  QSignalSpy done(views(), &ViewOutput::done);
  child<QAction>("saveAnimationAction")->trigger();
  QCOMPARE(asked, 1);
  QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, patience);
  QCOMPARE(QDir(folder).entryList(QDir::Files).size(), 5);
  QCOMPARE(contentsOf(path("out/old/frame_0001.png")), QByteArray("mine"));
}

void TestOutput::withoutFfmpeg() {
  const QByteArray programs = qgetenv("PATH");
  qputenv("PATH", path("out").toUtf8());
  bool isAsked = false;
  const QString folder = path("out/pictures");
  const Answers answers(
      [&](QDialog* dialog) {
        auto* video = dialog->findChild<QCheckBox*>("videoBox");
        QVERIFY(!video->isEnabled() && !video->isChecked());
        QVERIFY(video->text().contains("ffmpeg"));
        dialog->findChild<QSpinBox*>("widthBox")->setValue(30);
        dialog->findChild<QLineEdit*>("folderField")->setText(folder);
        isAsked = true;
      },
      folder);
  QSignalSpy done(views(), &ViewOutput::done);
  child<QAction>("saveAnimationAction")->trigger();
  qputenv("PATH", programs);
  QVERIFY(isAsked);
  QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, patience);
  QCOMPARE(QDir(folder).entryList(QDir::Files).size(), qsizetype(m_session.cameras.size()));
  QCOMPARE(specOf(folder + "/frame_0001.png").width, 30);
}

int main(int argc, char** argv) {
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  return runWindowTest<TestOutput>(argc, argv);
}
#include "test_output.moc"
