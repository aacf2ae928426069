// SPDX-License-Identifier: BSD-3-Clause
// Tests loading: every wrong library is refused with one line, whatever a plugin throws becomes
// one, and the process goes on; the example's light is that of its formula.
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <numbers>

#include "io/documents/session_file.h"
#include "io/json/json_parameters.h"
#include "io/plugins/plugin_guard.h"
#include "io/plugins/plugin_library.h"
#include "io/plugins/plugin_list.h"
#include "tests/plugins/plugin_files.h"

using namespace hogelscope;

namespace {

class Listener final : public plugin::Progress {
 public:
  explicit Listener(bool isOn) : m_isOn(isOn) {}
  [[nodiscard]] bool go(double) const override { return m_isOn; }

 private:
  bool m_isOn;
};

/// The program's own errors in a listener, which a plugin passes on.
template <class Error>
class Thrower final : public plugin::Progress {
 public:
  explicit Thrower(Error error) : m_error(std::move(error)) {}
  [[nodiscard]] bool go(double) const override { throw m_error; }

 private:
  Error m_error;
};

const plugin::Panel panel{{0.5, 0.5}, {64, 64}, {32, 32}, {0.01, 0.01}};

}  // namespace

class TestPluginLibrary : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void unknownPlugins();
  void refusedPlugins();
  void wrongLibraries_data();
  void wrongLibraries();
  void makesNothing();
  void throwsInEachCall_data();
  void throwsInEachCall();
  void stopsAndErrorsOfTheProgram();
  void liesAreFound();
  void longLines();
  void namesOfEveryLiveScene();
  void theExample();
  void theExampleRefuses();

 private:
  [[nodiscard]] QString path(const QString& name) const { return m_folder.path() + "/" + name; }
  /// Puts one of the wrong libraries into the plugin "wrong".
  void install(const QString& library, const Keys& changes = {}) {
    const QString file = QString(HOGELSCOPE_WRONG_PLUGINS "/%1.so").arg(library);
    // A library of the same path and file is not loaded again.
    QDir(m_place).removeRecursively();
    m_place = path(QString("p/%1").arg(++m_count));
    writePlugin(m_place, contentOf(file), changes);
  }
  static QString load(PluginKind kind = PluginKind::metric, const char* name = "wrong") {
    return errorOf([&] { (void)loadPlugin(name, kind); });
  }

  QTemporaryDir m_folder;
  QString m_place = "none";
  int m_count = 0;
};

void TestPluginLibrary::initTestCase() {
  qputenv("HOME", path("home").toUtf8());
  QVERIFY(QDir::setCurrent(m_folder.path()) && QDir().mkpath(path("p")));
  addPluginFolder(path("p").toStdString());
}

void TestPluginLibrary::unknownPlugins() {
  QCOMPARE(load(PluginKind::content, "examples"),
           "plugin examples: is not installed; did you mean example?");
  const QString line = load(PluginKind::content, "raytracer");
  QVERIFY2(line.startsWith("plugin raytracer: is not installed; looked in " + path("p") + ", "),
           qPrintable(line));
}

void TestPluginLibrary::refusedPlugins() {
  install("throws", {{"abi", "1"}, {"name", "\"example\""}});
  QVERIFY(QFile::rename(m_place, path("p/wrong")));
  m_place = path("p/wrong");
  QCOMPARE(load(), "plugin wrong: " + path("p/wrong/plugin.json: abi: 1, this program needs 3: "
                                           "build the plugin again with this program's SDK"));
  install("throws", {{"kinds", "[\"content\"]"}});
  QCOMPARE(load(PluginKind::lens), "plugin wrong: has no lens; its plugin.json says what it has");
}

void TestPluginLibrary::wrongLibraries_data() {
  QTest::addColumn<QString>("library");
  QTest::addColumn<QString>("line");  ///< after the file's name
  const QString other = " is not that of its plugin.json: build the plugin again";
  QTest::newRow("abi") << "other_abi"
                       << ": its abi" + other;
  QTest::newRow("build") << "other_build"
                         << ": its build" + other;
  QTest::newRow("no build") << "no_build"
                            << ": its build" + other;
  QTest::newRow("name") << "other_name"
                        << ": its name" + other;
  QTest::newRow("no symbol") << "no_symbol"
                             << " has no symbol hogelscope_plugin: it needs the line "
                                "HOGELSCOPE_PLUGIN(…)";
  QTest::newRow("unresolved") << "unresolved"
                              << ": undefined symbol: _Z19functionOfNoLibraryv";
}

void TestPluginLibrary::wrongLibraries() {
  QFETCH(QString, library);
  QFETCH(QString, line);
  install(library);
  QCOMPARE(load(), "plugin wrong: " + m_place + "/wrong.so" + line);
}

/// plugin.json fits these, so the loader of libraries is what refuses them, but not a truncated
/// one, which would end the process.
void TestPluginLibrary::makesNothing() {
  install("makes_nothing");
  const PluginLibrary library = loadPlugin("wrong", PluginKind::metric);
  QCOMPARE(errorOf([&] { (void)library.makeContent(); }),
           "plugin wrong: no licence for this machine");
  QCOMPARE(errorOf([&] { (void)library.makeLens(); }), "plugin wrong: makes no lens");
  QCOMPARE(errorOf([&] { (void)library.makeMetric(); }), "plugin wrong: has no metric");

  const QByteArray whole = contentOf(HOGELSCOPE_WRONG_PLUGINS "/throws.so");
  install("throws");
  writeFile(m_place + "/wrong.so", whole.first(whole.size() / 3));
  QVERIFY(load().contains("plugin.json: bytes: wrong.so has "));
  for (const double part : {0.01, 0.1, 0.3, 0.5, 0.9, 0.9999}) {
    writePlugin(m_place, whole.first(qsizetype(part * double(whole.size()))));
    QVERIFY2(load().endsWith("plugin.json: file: wrong.so is cut off: install the plugin again"),
             qPrintable(load()));
  }
  for (const QByteArray& text : {QByteArray("#!/bin/sh\n"), QByteArray(5000, 'x')}) {
    install("throws");
    writePlugin(m_place, text);
    const QString line = load();
    QVERIFY2(line.startsWith("plugin wrong: " + m_place + "/wrong.so: ") && !line.contains('\n'),
             qPrintable(line));
  }
}

void TestPluginLibrary::throwsInEachCall_data() {
  QTest::addColumn<QString>("library");
  QTest::addColumn<QString>("line");
  QTest::newRow("an exception") << "throws"
                                << "plugin wrong: room.obj: is empty: save it again";
  QTest::newRow("a number") << "throws_number"
                            << "plugin wrong: throws what is not a std::exception";
}

void TestPluginLibrary::throwsInEachCall() {
  QFETCH(QString, library);
  QFETCH(QString, line);
  install(library);
  const PluginLibrary wrong = loadPlugin("wrong", PluginKind::metric);
  const auto content = wrong.makeContent();
  const auto lens = wrong.makeLens();
  const auto metric = wrong.makeMetric();
  Json object = Json::object();
  JsonReader visitor(object, "");
  double depth = 0;
  const std::vector<std::function<void()>> calls{
      [&] { content->describe(visitor); },    [&] { content->open(panel, {}, Listener(true)); },
      [&] { (void)content->files(); },        [&] { (void)content->notes(); },
      [&] { content->trace({}, {}); },        [&] { (void)content->traceDepths({}, {}); },
      [&] { content->depths(depth, depth); }, [&] { (void)content->triangles(); },
      [&] { lens->describe(visitor); },       [&] { lens->open(0, 60, {}); },
      [&] { (void)lens->directionOf(0); },    [&] { (void)lens->slopeOf(0); },
      [&] { (void)metric->title(); },         [&] { (void)metric->unit(); },
      [&] { (void)metric->decimals(); },      [&] { (void)metric->compare({}, {}, {}); }};
  for (const auto& call : calls) QCOMPARE(errorOf(call), line);
}

/// What a plugin throws after a stop is no error; the program's own exceptions pass it unchanged.
void TestPluginLibrary::stopsAndErrorsOfTheProgram() {
  install("throws");
  const auto content = loadPlugin("wrong", PluginKind::content).makeContent();
  QVERIFY_EXCEPTION_THROWN(content->open(panel, {}, Listener(false)), Cancelled);
  QVERIFY_EXCEPTION_THROWN(content->open(panel, {}, Thrower(Cancelled())), Cancelled);
  const InputError error("disk", "is full");
  QCOMPARE(errorOf([&] { content->open(panel, {}, Thrower(error)); }), "disk: is full");
}

void TestPluginLibrary::liesAreFound() {
  install("lies");
  const PluginLibrary library = loadPlugin("wrong", PluginKind::content);
  const auto content = library.makeContent();
  double depth = 0;
  QCOMPARE(errorOf([&] { content->depths(depth, depth); }),
           "plugin wrong: its depths are not back ≤ front");
  QCOMPARE(content->notes(), std::vector<std::string>(50, "two lines\\x1b[2J"));
  QVERIFY(!content->traceDepths({}, {}));
  QCOMPARE(content->triangles().corners.size(), std::size_t(3));
  for (const int corner : {-1, 3}) {
    const Json parameters{{"corner", corner}};
    JsonReader reader(parameters, "");
    content->describe(reader);
    QCOMPARE(errorOf([&] { (void)content->triangles(); }),
             "plugin wrong: its triangles are not three numbers and colours for each point and "
             "three points for each triangle");
  }
  const auto metric = library.makeMetric();
  QCOMPARE(errorOf([&] { (void)metric->title(); }),
           "plugin wrong: its title is not a line of 40 letters");
  QCOMPARE(errorOf([&] { (void)metric->unit(); }),
           "plugin wrong: its unit is not a line of 40 letters");
  QCOMPARE(errorOf([&] { (void)metric->decimals(); }), "plugin wrong: its decimals are not 0 to 9");
  const Json wrong{{"corner", "three"}};
  JsonReader reader(wrong, "lightField.wrong");
  QCOMPARE(errorOf([&] { content->describe(reader); }),
           "lightField.wrong.corner: \"three\" is not a number");
}

void TestPluginLibrary::longLines() {
  const QString line = pluginError("wrong", std::string(5000, 'x')).what();
  QCOMPARE(line, "plugin wrong: " + QString(400, 'x') + "…");
  QCOMPARE(QString(pluginError("wrong", "").what()), "plugin wrong: throws without saying why");
  QCOMPARE(QString(pluginError("wrong", "\x1b[2J").what()), "plugin wrong: \\x1b[2J");
}

/// Its own parameters stand beside samples, fill and depth.
void TestPluginLibrary::namesOfEveryLiveScene() {
  install("lies");
  writeFile("s.json", text({.lightField = R"({"layout": "live", "source": "wrong",
                                              "wrong": {"corner": 1, "fill": 2}})"}));
  QCOMPARE(errorOf([] { (void)loadSession("s.json"); }),
           "s.json: lightField.wrong.fill: is declared twice: a plugin's parameter needs another "
           "name");
}

/// A ray meets the plane where its line does; one that ends before it, or comes from behind, not.
void TestPluginLibrary::theExample() {
  const auto grating = loadPlugin("example", PluginKind::content).makeContent();
  const Json parameters{{"z", 0.1}, {"frequency", 25.0}, {"size", 0.2}};
  JsonReader reader(parameters, "");
  grating->describe(reader);
  reader.refuseUnknown();
  grating->open(panel, {}, Listener(true));
  double back = 0;
  double front = 0;
  grating->depths(back, front);
  QCOMPARE(back, 0.1);
  QCOMPARE(front, 0.1);
  const std::vector<plugin::Ray> rays{{0.01, 0, 1.1, 0.02, 0, 10},   // meets x = −0.01
                                      {0.01, 0, 1.1, 0.02, 0, 0.9},  // ends before
                                      {0.01, 0, 0.05, 0.02, 0, 1},   // begins behind
                                      {0.01, 0, 1.1, 0, 0.2, 10}};   // passes below
  std::vector<plugin::Colour> colours(rays.size(), {9, 9, 9});
  grating->trace(rays, colours);
  const double light = 127.5 + 127.5 * std::cos(2 * std::numbers::pi * 25 * 0.01);
  QVERIFY(std::abs(colours[0].r - light) < 1e-4 && colours[0].g == colours[0].r);
  for (std::size_t k = 1; k < rays.size(); ++k) QCOMPARE(colours[k].r, 0.0F);
  QCOMPARE(grating->triangles().points.size(), std::size_t(12));
}

void TestPluginLibrary::theExampleRefuses() {
  const auto grating = loadPlugin("example", PluginKind::content).makeContent();
  const Json parameters{{"z", 0.0}, {"frequency", 100.0}};
  JsonReader reader(parameters, "");
  grating->describe(reader);
  QCOMPARE(errorOf([&] { grating->open(panel, {}, Listener(true)); }),
           "plugin example: frequency: is above what the panel's hogels can show");
}

QTEST_GUILESS_MAIN(TestPluginLibrary)
#include "test_plugin_library.moc"
