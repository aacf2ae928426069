// SPDX-License-Identifier: BSD-3-Clause
// Tests the file of keys: what is saved comes back, what is no such file is one line.
#include "io/documents/key_map_file.h"

#include <QTemporaryDir>
#include <QTest>

#include "tests/io/documents.h"

using namespace hogelscope;

class TestKeyMapFile : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QVERIFY(QDir::setCurrent(m_folder.path())); }

  void whatIsSavedComesBack() {
    const KeyTexts keys{
        {"duplicateAction", "Ctrl+D"}, {"walkForwardAction", "Ö; \""}, {"rollLeftAction", ""}};
    saveKeyTexts("a/b/keys.json", keys);  // makes the folders
    QVERIFY(loadKeyTexts("a/b/keys.json") == keys);
    saveKeyTexts("a/b/keys.json", {});
    QVERIFY(loadKeyTexts("a/b/keys.json").empty());
    QCOMPARE(namesIn("a/b"), QStringList("keys.json"));
  }

  void theDocument() {
    saveKeyTexts("keys.json", {{"duplicateAction", "Ctrl+D"}});
    QCOMPARE(contentOf("keys.json").simplified(),
             QByteArray(R"({ "hogelscopeKeys": 1, "keys": { "duplicateAction": "Ctrl+D" } })"));
  }

  void refused_data();
  void refused();

  void noFolder() {
    writeFile("plain", "");
    QVERIFY(errorOf([] { saveKeyTexts("plain/keys.json", {}); }).contains("plain"));
  }

 private:
  QTemporaryDir m_folder;
};

void TestKeyMapFile::refused_data() {
  QTest::addColumn<QByteArray>("document");
  QTest::addColumn<QString>("line");
  const auto row = [](const char* name, const QByteArray& document, const char* line) {
    QTest::newRow(name) << document << QString("keys.json: ") + line;
  };
  row("empty", "", "is empty");
  row("not JSON", "{\"hogelscopeKeys\": 1,", "is not JSON");
  row("a list", "[]", "");
  row("a session", R"({"hogelscope": 1})", "hogelscopeKeys: is missing");
  row("version", R"({"hogelscopeKeys": 2, "keys": {}})",
      "hogelscopeKeys: 2 is not a version that this program reads: 1");
  row("no keys", R"({"hogelscopeKeys": 1})", "keys: is not an object");
  row("keys a list", R"({"hogelscopeKeys": 1, "keys": []})", "keys: is not an object");
  row("a number", R"({"hogelscopeKeys": 1, "keys": {"saveAction": 7}})",
      "keys.saveAction: 7 is not a text");
  row("unknown", R"({"hogelscopeKeys": 1, "keys": {}, "kees": {}})", "kees: ");
}

void TestKeyMapFile::refused() {
  QFETCH(QByteArray, document);
  QFETCH(QString, line);
  writeFile("keys.json", document);
  const QString error = errorOf([] { (void)loadKeyTexts("keys.json"); });
  QVERIFY2(error.startsWith(line), qPrintable(error));
  QVERIFY(!error.contains('\n'));
}

QTEST_APPLESS_MAIN(TestKeyMapFile)
#include "test_key_map_file.moc"
