// SPDX-License-Identifier: BSD-3-Clause
// Tests live light fields in sessions: documents, overrides, mistakes, reading and streaming.
#include "io/scene/live_file.h"

#include <QTemporaryDir>
#include <QTest>

#include "io/documents/session_file.h"
#include "io/files/system_limits.h"
#include "io/opening/session_around.h"
#include "io/scene/view_source.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

const Sections live{.lightField =
                        R"({"layout": "live", "source": "scene", "scene": {"samples": 2}})"};

}  // namespace

class TestLiveFile : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    m_folder = std::make_unique<QTemporaryDir>();
    m_file = m_folder->filePath("s.json").toStdString();
  }
  void document();
  void savedAndRead();
  void overrides();
  void mistakes_data();
  void mistakes();
  void otherLightFields();
  void readsAndStreams();
  void whatTheSessionDoesNotName();

 private:
  Session loaded(const Sections& sections, const std::vector<std::string>& overrides = {}) {
    writeFile(QString::fromStdString(m_file), text(sections));
    return loadSession(m_file, overrides);
  }

  std::unique_ptr<QTemporaryDir> m_folder;
  std::string m_file;
};

void TestLiveFile::document() {
  const LightFieldParams params = loaded(live).lightField;
  QVERIFY(params.layout == Layout::live && params.source == "scene");
  QVERIFY(params.content.isGiven() && params.type == LiveType::uint8);
  QCOMPARE(params.live.samples, 2);
  QVERIFY((params.live.fill == std::array<double, 2>{1, 1}));
}

void TestLiveFile::savedAndRead() {
  Session session = loaded(live, {"lightField.type=real", "lightField.scene.depth=[-1,0.25]"});
  saveSession(m_file, session);
  QVERIFY(loadSession(m_file) == session);
  const QString written = contentOf(QString::fromStdString(m_file));
  QVERIFY2(written.contains("\"depth\": [-1") && written.contains("0.25]"), qPrintable(written));
  session.lightField.live.samples = 3;
  QVERIFY(!(loadSession(m_file) == session));
}

void TestLiveFile::overrides() {
  QCOMPARE(loaded(live, {"lightField.scene.samples=8"}).lightField.live.samples, 8);
  const Sections bare{.lightField = R"({"layout": "live", "source": "scene"})"};
  QCOMPARE(loaded(bare, {"lightField.scene.samples=8"}).lightField.live.samples, 8);
  QCOMPARE(loaded(bare).lightField.live.samples, 1);
}

void TestLiveFile::mistakes_data() {
  QTest::addColumn<QByteArray>("lightField");
  QTest::addColumn<QByteArray>("display");
  QTest::addColumn<QString>("error");
  const QByteArray display = live.display;
  QTest::newRow("no source") << QByteArray(R"({"layout": "live"})") << display
                             << "lightField.source: is missing";
  QTest::newRow("another source") << QByteArray(R"({"layout": "live", "source": "scenes"})")
                                  << display << "plugin scenes: is not installed";
  QTest::newRow("a file") << QByteArray(R"({"layout": "live", "source": "scene", "file": "a.png"})")
                          << display << "lightField.file: is not of a live light field";
  QTest::newRow("no hogels") << live.lightField << QByteArray(R"({"directions": [5, 6]})")
                             << "display.hogels: is missing: a scene does not say it";
  QTest::newRow("no directions") << live.lightField << QByteArray(R"({"hogels": [5, 6]})")
                                 << "display.directions: is missing";
  QTest::newRow("unknown field")
      << QByteArray(R"({"layout": "live", "source": "scene", "scene": {"sample": 3}})") << display
      << "lightField.scene.sample: ";
  QTest::newRow("samples 0")
      << QByteArray(R"({"layout": "live", "source": "scene", "scene": {"samples": 0}})") << display
      << "lightField.scene.samples: ";
  QTest::newRow("depth reversed")
      << QByteArray(R"({"layout": "live", "source": "scene", "scene": {"depth": [1, -1]}})")
      << display << "lightField.scene.depth: begins in front of its end";
  QTest::newRow("another's object")
      << QByteArray(R"({"layout": "live", "source": "scene", "mesh": {}})") << display
      << "lightField.mesh: ";
  QTest::newRow("not an object") << QByteArray(
                                        R"({"layout": "live", "source": "scene", "scene": 3})")
                                 << display << "lightField.scene";
  QTest::newRow("fields of others")
      << QByteArray(R"({"layout": "live", "source": "scene", "shear": [1, 1]})") << display
      << "lightField.shear: ";
}

void TestLiveFile::mistakes() {
  QFETCH(const QByteArray, lightField);
  QFETCH(const QByteArray, display);
  QFETCH(const QString, error);
  const QString found = errorOf([&] {
    const Session session = loaded({.display = display, .lightField = lightField});
    (void)openLightField(session.lightField, session.display);
  });
  QVERIFY2(found.contains("s.json: " + error), qPrintable(found));
  QVERIFY(!found.contains('\n'));
}

/// A test light field replaces a live one and the other way round.
void TestLiveFile::otherLightFields() {
  const Session session = loaded(live);
  QVERIFY(withLightField(session, "other.png").lightField.layout == Layout::hogels);
  const Session file = loaded({});
  QVERIFY(file.lightField.layout == Layout::hogels);
  const std::string other = m_folder->filePath("live.json").toStdString();
  saveSession(other, session);
  QVERIFY(withLightField(file, other).lightField == session.lightField);
  QVERIFY(!readTheSame(session, file));
}

void TestLiveFile::readsAndStreams() {
  for (const char* type : {"uint8", "real"}) {
    const Session session = loaded(live, {std::string("lightField.type=") + type});
    const auto file = openLightField(session.lightField, session.display);
    QVERIFY((file->size() == LightFieldSize{4, 3, 5, 6}));
    const LightField whole = file->read({});
    const auto source = file->source({}, {});
    int rows = 0;
    const std::size_t allowed = allowedMemory();
    allowMemory(1);  // a row at a time
    file->stream(
        [&](int j, int v, const StoredRows& rgb) {
          ++rows;
          std::visit(
              [&](const auto* values) {
                const double unit =
                    std::is_floating_point_v<std::decay_t<decltype(*values)>> ? 255 : 1;
                for (int i = 0; i < 4; ++i)
                  for (int u = 0; u < 5; ++u, values += 3) {
                    const Rgb texel = whole.texel({i, j, u, v});
                    QCOMPARE(texel.r, double(values[0]) * unit);
                    QCOMPARE(texel.b, double(values[2]) * unit);
                    QVERIFY(source->texel({i, j, u, v}) == texel);
                  }
              },
              rgb);
        },
        {});
    allowMemory(allowed);
    QCOMPARE(rows, 18);
    QVERIFY_THROWS_EXCEPTION(
        Cancelled, file->stream([](int, int, const StoredRows&) {}, [](double) { return false; }));
  }
}

/// No ideal view of what is not live.
void TestLiveFile::whatTheSessionDoesNotName() {
  requireLive(loaded(live));
  QVERIFY(errorOf([&] { requireLive(loaded({})); }).contains("only a 3-D scene"));
}

QTEST_APPLESS_MAIN(TestLiveFile)
#include "test_live_file.moc"
