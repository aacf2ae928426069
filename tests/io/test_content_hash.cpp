// SPDX-License-Identifier: BSD-3-Clause
// Tests the hashes of files against a known one and against xxh128sum itself.
#include <sys/stat.h>

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "io/files/content_hash.h"
#include "tests/io/documents.h"

using namespace hogelscope;

class TestContentHash : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QVERIFY(QDir::setCurrent(m_folder.path())); }
  void ofText();
  void ofFiles();
  void stops();
  void missing();
  void devicesAndPipes();

 private:
  QTemporaryDir m_folder;
};

/// Of XXH3's own tests: nothing at all.
void TestContentHash::ofText() {
  QCOMPARE(contentHash(""), std::string("99aa06d3014798d86001c324468d497f"));
}

void TestContentHash::ofFiles() {
  writeFile("a", QByteArray(3000000, 'x') + "y");
  writeFile("b", "");
  QProcess sum;
  sum.start("xxh128sum", {"a", "b"});
  QVERIFY(sum.waitForFinished(-1));
  const QByteArray lines = sum.readAllStandardOutput();
  QCOMPARE(lines.left(32),
           QByteArray::fromStdString(contentHash(std::vector<std::filesystem::path>{"a"})));
  QCOMPARE(contentHash(std::vector<std::filesystem::path>{"a", "b"}),
           contentHash(lines.toStdString()));
}

void TestContentHash::stops() {
  writeFile("a", "x");
  QVERIFY_THROWS_EXCEPTION(Cancelled, contentHash(std::vector<std::filesystem::path>{"a"},
                                                  [](double) { return false; }));
}

void TestContentHash::missing() {
  QVERIFY(errorOf([] {
            (void)contentHash(std::vector<std::filesystem::path>{"none.png"});
          }).startsWith("none.png: cannot be read: "));
}

/// They may have no end, or no beginning.
void TestContentHash::devicesAndPipes() {
  QCOMPARE(::mkfifo("pipe", 0600), 0);
  for (const char* file : {"/dev/zero", "pipe"})
    QCOMPARE(errorOf([file] { (void)contentHash(std::vector<std::filesystem::path>{file}); }),
             QString(file) + ": is a device or a pipe, not a file");
}

QTEST_GUILESS_MAIN(TestContentHash)
#include "test_content_hash.moc"
