// SPDX-License-Identifier: BSD-3-Clause
// Tests the hashes of files against known ones and against sha256sum itself.
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "report/file_hash.h"
#include "tests/io/documents.h"

using namespace hogelscope;

class TestFileHash : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QVERIFY(QDir::setCurrent(m_folder.path())); }
  void ofText();
  void ofFiles();
  void stops();
  void missing();

 private:
  QTemporaryDir m_folder;
};

/// FIPS 180-2's own example.
void TestFileHash::ofText() {
  QCOMPARE(sha256("abc"),
           std::string("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
}

void TestFileHash::ofFiles() {
  writeFile("a", QByteArray(3000000, 'x') + "y");
  writeFile("b", "");
  QProcess sum;
  sum.start("sha256sum", {"a", "b"});
  QVERIFY(sum.waitForFinished(-1));
  const QByteArray lines = sum.readAllStandardOutput();
  QCOMPARE(lines.left(64),
           QByteArray::fromStdString(sha256(std::vector<std::filesystem::path>{"a"})));
  QCOMPARE(sha256(std::vector<std::filesystem::path>{"a", "b"}), sha256(lines.toStdString()));
}

void TestFileHash::stops() {
  writeFile("a", "x");
  QVERIFY_THROWS_EXCEPTION(
      Cancelled, sha256(std::vector<std::filesystem::path>{"a"}, [](double) { return false; }));
}

void TestFileHash::missing() {
  QVERIFY(errorOf([] {
            (void)sha256(std::vector<std::filesystem::path>{"none.png"});
          }).startsWith("none.png: cannot be read: "));
}

QTEST_GUILESS_MAIN(TestFileHash)
#include "test_file_hash.moc"
