// SPDX-License-Identifier: BSD-3-Clause
// Tests the library of displays: all sessions of the folder are in it, and what is no library is
// one line.
#include "io/documents/display_library.h"

#include <QTemporaryDir>
#include <QTest>
#include <set>

#include "io/documents/session_file.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

const std::filesystem::path folder = HOGELSCOPE_SOURCE_DIR "/data/displays";

}  // namespace

class TestDisplayLibrary : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QVERIFY(QDir::setCurrent(m_folder.path())); }

  void allSessionsAreInIt() {
    std::set<std::string> named, there;
    for (const LibraryDisplay& each : loadDisplayLibrary(folder / "library.json")) {
      QVERIFY(!each.name.empty() && !each.source.empty());
      named.insert(each.file);
      (void)loadSession(folder / (each.file + ".json"));
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".json" && entry.path().stem() != "library")
        there.insert(entry.path().stem().string());
    QVERIFY(named == there && !named.empty());
  }

  void refused_data();
  void refused();

 private:
  QTemporaryDir m_folder;
};

void TestDisplayLibrary::refused_data() {
  QTest::addColumn<QByteArray>("document");
  QTest::addColumn<QString>("line");
  const auto row = [](const char* name, const QByteArray& document, const char* line) {
    QTest::newRow(name) << document << QString("library.json: ") + line;
  };
  row("empty", "", "is empty");
  row("a session", R"({"hogelscope": 1})", "hogelscopeDisplays: is not 1");
  row("version", R"({"hogelscopeDisplays": 2, "displays": []})", "hogelscopeDisplays: is not 1");
  row("no list", R"({"hogelscopeDisplays": 1, "displays": {}})", "displays: is not a list");
  row("a number", R"({"hogelscopeDisplays": 1, "displays": [{"file": 3}]})",
      "displays[0].file: is not a text");
  row("a text missing", R"({"hogelscopeDisplays": 1, "displays": [{"file": "a", "name": "b"}]})",
      "displays[0].source: is not a text");
  row("another key",
      R"({"hogelscopeDisplays": 1, "displays": [
          {"file": "a", "name": "b", "source": "c", "assumed": "", "size": 1}]})",
      "displays[0].size: is not known here");
}

void TestDisplayLibrary::refused() {
  QFETCH(QByteArray, document);
  QFETCH(QString, line);
  writeFile("library.json", document);
  const QString error = errorOf([] { (void)loadDisplayLibrary("library.json"); });
  QVERIFY2(error.startsWith(line), qPrintable(error));
}

QTEST_GUILESS_MAIN(TestDisplayLibrary)
#include "test_display_library.moc"
