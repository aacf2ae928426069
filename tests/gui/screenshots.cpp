// SPDX-License-Identifier: BSD-3-Clause
// Makes the manual's images of the window, so that they stay true: packaging/manual.sh.
// screenshots FOLDER WIDTHxHEIGHT TEST drives the real window on the sample session; TEST is a
// light field to compare with. screenshots FOLDER WIDTHxHEIGHT SESSION ACTION… opens a session,
// triggers the actions and makes one image, named by the size and the scale of the screen. An
// action may also be a button, or a slider, a list or a number with its value: designFov=400.
#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTableView>
#include <QTemporaryDir>
#include <QTimer>
#include <QtTest>

#include "gui/app/translations.h"
#include "gui/docks/report_dock.h"
#include "gui/files/opening_dialog.h"
#include "gui/keys/key_dialog.h"
#include "gui/scene/display_scene.h"
#include "gui/scene/scene_controller.h"
#include "gui/view/image_commands.h"
#include "gui/view/image_widget.h"
#include "io/documents/session_file.h"
#include "io/scene/light_field_export.h"
#include "io/scene/view_source.h"
#include "tests/gui/window_files.h"

using namespace hogelscope;

namespace {

constexpr int patience = 60000;
const QString sample = QStringLiteral(HOGELSCOPE_SOURCE_DIR "/data/table1.json");

class Shooting {
 public:
  Shooting(const QString& folder, const QSize& size, const QString& test)
      : m_folder(QDir(folder).absolutePath()), m_size(size), m_test(test) {}

  /// Makes one image of a session, after the actions.
  void one(const QString& session, const QStringList& actions) {
    show();
    files(m_window).open(session);
    wait([this] { return !view()->image().isNull(); });
    for (const QString& action : actions) {
      const QString name = action.section('=', 0, 0);
      if (auto* slider = m_window.findChild<QSlider*>(name))
        slider->setValue(action.section('=', 1).toInt());
      else if (auto* box = m_window.findChild<QComboBox*>(name))
        box->setCurrentText(action.section('=', 1));
      else if (auto* field = m_window.findChild<QDoubleSpinBox*>(name))
        field->setValue(action.section('=', 1).toDouble());
      else if (auto* button = m_window.findChild<QAbstractButton*>(name))
        button->click();
      else
        trigger(action.toLatin1());
      QTest::qWait(4000);
    }
    const double scale = m_window.devicePixelRatioF();
    shoot(QString("%1x%2").arg(scale * m_size.width()).arg(scale * m_size.height()));
  }

  void run() {
    show();
    QImage home = m_window.grab().toImage();
    home.save(m_folder + "/window_home.png");
    opening();
    files(m_window).open(sample);
    wait([this] { return !view()->image().isNull(); });
    shoot("sample");
    lens();
    compare();
    inspect();
    report();
    keys();
    light();
    speed();
    live();
    scene();
  }

 private:
  void show() {
    m_window.resize(m_size);
    m_window.show();
    m_window.activateWindow();
    QTest::qWait(300);
    m_window.resize(m_size);  // docks let it grow while they are laid out for the first time
    QTest::qWait(300);
  }
  template <class Condition>
  void wait(Condition condition) {
    if (!QTest::qWaitFor(condition, patience)) qFatal("waited in vain");
    QTest::qWait(1500);  // the scene and the full image follow
  }
  ImageWidget* view() const { return m_window.findChild<ImageWidget*>("pictureView"); }
  void trigger(const char* action) {
    m_window.findChild<QAction*>(action)->trigger();
    QTest::qWait(300);
  }
  /// Opens a section of the Properties dock, and closes the others.
  void open(const QString& section) {
    for (const char* other : {"lightField", "display", "camera", "distortion"})
      m_window.findChild<QAbstractButton*>(QString(other) + "Header")->setChecked(other == section);
    m_window.findChild<QAbstractButton*>(section + "Header")->setChecked(true);
    QTest::qWait(300);
  }
  void raise(const char* dock) {
    m_window.findChild<QDockWidget*>(dock)->show();
    m_window.findChild<QDockWidget*>(dock)->raise();
    QTest::qWait(300);
  }
  void shoot(const QString& name) { m_window.grab().save(m_folder + "/window_" + name + ".png"); }

  /// Views of the built-in scene, as a folder that nobody has described.
  void opening() {
    Session session = newSession();
    session.display.hogels = {256, 192};
    session.display.size = {0.5, 0.375};
    session.display.directions = {9, 9};
    session.display.fov = {30, 30};
    const QString views = m_temporary.filePath("views");
    exportViews(*openLightField(session.lightField, session.display), views.toStdString(), {});
    QTimer::singleShot(1000, &m_window, [views] {
      auto* chooser = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      chooser->findChild<QLineEdit*>("fileNameEdit")->setText(views + "/004_004.png");
      static_cast<QDialog*>(chooser)->accept();
    });
    m_window.findChild<QAction*>("openLightFieldAsAction")->trigger();
    const auto dialog = [this] { return m_window.findChild<OpeningDialog*>(); };
    const auto isReady = [&] {
      return dialog() != nullptr && dialog()->findChild<ImageWidget*>()->notice().isEmpty();
    };
    wait(isReady);
    dialog()->findChild<QComboBox*>("layout")->setCurrentIndex(int(Layout::views));
    wait(isReady);
    dialog()->grab().save(m_folder + "/window_opening.png");
    dialog()->reject();
  }

  /// The paper's Fig. 2: its lens folds within the image.
  void lens() {
    open("distortion");
    m_window.findChild<QComboBox*>("stateBox")->setCurrentIndex(1);
    wait([this] { return m_window.findChild<QLabel*>("certificateLabel")->text().contains("⚠"); });
    shoot("lens");
    m_window.findChild<QComboBox*>("stateBox")->setCurrentIndex(3);
    open("camera");
  }

  void compare() {
    m_window.findChild<ImageCommands*>()->compareWith(m_test);
    wait([this] { return !view()->otherImage().isNull(); });
    trigger("wipeAction");
    shoot("wipe");
    trigger("lumaErrorAction");
    trigger("histogramAction");
    view()->setRegion({200, 250, 160, 60});
    QTest::qWait(1500);
    shoot("error");
    view()->setRegion({});
    trigger("histogramAction");
    trigger("stopComparingAction");
  }

  void inspect() {
    raise("inspectorDock");
    Q_EMIT view()->pixelPicked(380, 420);
    QTest::qWait(500);
    shoot("inspector");
    trigger("sceneForgetAction");
    m_window.findChild<QDockWidget*>("inspectorDock")->close();
    open("camera");
  }

  void report() {
    trigger("layoutReportAction");
    auto* dock = m_window.findChild<ReportDock*>();
    dock->addTest(m_test);
    dock->setFolder(m_temporary.path() + "/report");
    QTest::mouseClick(m_window.findChild<QPushButton*>("makeReportButton"), Qt::LeftButton);
    wait([this] { return m_window.findChild<QLabel*>("reportNote")->text().contains("mean"); });
    m_window.findChild<QTableView*>("reportTable")->selectRow(2);
    QTest::qWait(1000);
    dock->setFolder("report");  // no path of this machine
    shoot("report");
    trigger("layoutViewAction");
  }

  void keys() {
    trigger("keysAction");
    auto* window = m_window.findChild<KeyDialog*>();
    window->grab().save(m_folder + "/window_keys.png");
    window->close();
  }

  void light() {
    trigger("lightColours");
    QTest::qWait(1000);
    shoot("light");
    trigger("darkColours");
  }

  void speed() {
    trigger("layoutMeasureAction");
    auto* measure = m_window.findChild<QPushButton*>("measureButton");
    m_window.findChild<QSpinBox*>("budgetBox")->setValue(20);
    measure->click();
    QTest::qWait(1000);
    wait([&] { return !measure->text().contains("Stop"); });
    shoot("speed");
    trigger("layoutViewAction");
  }

  void live() {
    QDir::setCurrent(HOGELSCOPE_SOURCE_DIR);  // the dock shows the name as it was given
    files(m_window).open("data/room.glb");
    wait([this] { return m_window.windowTitle().contains("new session"); });
    wait([this] { return view()->notice().isEmpty(); });
    trigger("compareIdealAction");
    wait([this] { return !view()->otherImage().isNull(); });
    trigger("sideBySideAction");
    open("lightField");
    shoot("live");
  }

  /// An arc of states before the display, their views on their near planes, and the viewing zone.
  void scene() {
    trigger("stopComparingAction");
    Session session = loadSession("data/room.json");
    const CameraState first = session.cameras.front();
    const double distance = 1.6 * std::max(session.display.size[0], session.display.size[1]);
    session.cameras.clear();
    for (int degrees = -24; degrees <= 24; degrees += 6) {
      CameraState state = first;
      state.camera.name = std::to_string(degrees) + "°";
      const double angle = radians(degrees);
      state.camera.eye = {distance * std::sin(angle), 0, distance * std::cos(angle)};
      session.cameras.push_back(state);
    }
    session.lightField.file = std::string(HOGELSCOPE_SOURCE_DIR "/data/") + "room.glb";
    const std::string file = m_temporary.filePath("arc.json").toStdString();
    saveSession(file, session);
    files(m_window).open(QString::fromStdString(file));
    m_window.findChild<QComboBox*>("stateBox")->setCurrentIndex(2);
    trigger("singleAction");
    trigger("sceneZoneAction");
    trigger("sceneStatePicturesAction");
    DisplayScene& scene = m_window.findChild<SceneController*>()->scene();
    trigger("sceneFrontAction");
    scene.turn(50, 18);
    trigger("fitAction");
    wait([this] { return !view()->image().isNull() && view()->notice().isEmpty(); });
    QTest::qWait(2000);
    open("camera");  // shows no path of this machine
    shoot("scene");
  }

  QString m_folder;
  QSize m_size;
  QString m_test;
  QTemporaryDir m_temporary;
  MainWindow m_window;
};

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QStandardPaths::setTestModeEnabled(true);
  const QTemporaryDir settings;  // not the user's own
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  QSettings().setValue("window/hintsUsed", QStringList{"eye", "pixel", "directions"});
  installTranslations();
  const QStringList arguments = application.arguments();
  const QStringList size = arguments.value(2).split('x');
  if (size.size() != 2 || arguments.size() < 4 || !QDir(arguments.value(1)).exists()) {
    qCritical("usage: screenshots FOLDER WIDTHxHEIGHT TEST | SESSION ACTION…");
    return 2;
  }
  Shooting shooting(arguments[1], {size[0].toInt(), size[1].toInt()}, arguments[3]);
  if (arguments.size() == 4)
    shooting.run();
  else
    shooting.one(arguments[3], arguments.mid(4));
  return 0;
}
