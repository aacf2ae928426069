// SPDX-License-Identifier: BSD-3-Clause
// Tests that every job finds an output folder that cannot be written before it works.
#include <linux/capability.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <QTest>

#include "io/files/folders.h"
#include "tests/cli/program.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

namespace {

constexpr int cannotDrop = 77;  ///< exit status where privileges stay

/// As run(), where not even root may write into a folder whose permissions say no.
Outcome runWithoutPrivileges(const QStringList& arguments, const QString& folder) {
  QProcess process;
  process.setChildProcessModifier([] {
    if (::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE) != 0 && ::geteuid() == 0) ::_exit(cannotDrop);
  });
  start(process, arguments, folder);
  return ended(process);
}

}  // namespace

class TestOutputFolder : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void isFoundFirst_data();
  void isFoundFirst();
  void nothingIsLeftInIt();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

/// The light field is found damaged only when it is read.
void TestOutputFolder::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
  writeImageFile("a.png", 128, 128,
                 [](int x, int y, int c) { return float((x * y + c) % 251) / 255; });
  const QByteArray whole = contentOf("a.png");
  writeFile("a.png", whole.left(whole.size() / 2));
  writeFile("s.json", text({.display = R"({"hogels": [16, 16], "directions": [8, 8]})",
                            .lightField = R"({"file": "a.png"})"}));
  QVERIFY(QDir().mkdir("locked"));
}

void TestOutputFolder::isFoundFirst_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QString>("file");  ///< that is written in the folder; "": several
  const QStringList session{"--session", "s.json"};
  QTest::newRow("render") << QStringList{"--render"} + session << "";
  QTest::newRow("report") << QStringList{"--report", "--test", "a.png"} + session << "";
  QTest::newRow("tradeoff") << QStringList{"--tradeoff"} + session << "";
  QTest::newRow("stability") << QStringList{"--stability"} << "";
  QTest::newRow("make-cameras") << QStringList{"--make-cameras", "random"} + session << "/o.json";
  QTest::newRow("generate") << QStringList{"--generate", "edge"} + session << "/o.png";
  QTest::newRow("pack") << QStringList{"--pack", "a.png"} + session << "/o.tif";
}

void TestOutputFolder::isFoundFirst() {
  QFETCH(QStringList, arguments);
  QFETCH(QString, file);
  const auto outcome = [&](const QString& output) {
    return runWithoutPrivileges(arguments + QStringList{"--output", output}, m_folder->path());
  };
  QVERIFY(QFile::setPermissions("locked", QFile::ReadOwner | QFile::ExeOwner));
  const Outcome there = outcome("locked" + file);
  const Outcome below = outcome("locked/new" + file);
  QVERIFY(QFile::setPermissions("locked", QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
  if (there.status == cannotDrop) QSKIP("root may write everywhere here");
  QCOMPARE(there.err, QByteArray("hogelscope: locked: cannot be written: Permission denied\n"));
  QCOMPARE(there.status, 2);
  QCOMPARE(there.out, QByteArray());
  QCOMPARE(below.err, QByteArray("hogelscope: locked/new: cannot be made: Permission denied\n"));
  QCOMPARE(below.status, 2);
  QCOMPARE(namesIn("locked"), QStringList());
}

void TestOutputFolder::nothingIsLeftInIt() {
  hogelscope::checkWritable("locked");
  QCOMPARE(namesIn("locked"), QStringList());
  QCOMPARE(errorOf([] { hogelscope::checkWritable("none"); }),
           QString("none: cannot be written: No such file or directory"));
  // A file system without files that have no name.
  QVERIFY(
      errorOf([] { hogelscope::checkWritable("/proc"); }).startsWith("/proc: cannot be written"));
}

QTEST_GUILESS_MAIN(TestOutputFolder)
#include "test_output_folder.moc"
