// SPDX-License-Identifier: BSD-3-Clause
// Tests what a report keeps on disk while it runs: exact figures, cut-off files, other reports.
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "io/documents/panel_error_file.h"
#include "runs/journal.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

const std::vector<double> figures{1.0 / 3, std::nan(""), 0.1 + 0.2, 1e-300, 5e300, INFINITY, 0};

const JournalHead head{"k", 5, 2};

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  const auto equal = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return std::ranges::equal(a, b, equal);
}

}  // namespace

class TestJournal : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { m_folder = std::make_unique<QTemporaryDir>(); }
  void goesOn();
  void anotherReport();
  void cutAnywhere();
  void damaged_data();
  void damaged();
  void oneAtATime();
  void journalsOfShards();
  void panelErrors();
  void strangePanelErrors_data();
  void strangePanelErrors();

 private:
  [[nodiscard]] std::filesystem::path folder() const { return m_folder->path().toStdString(); }
  [[nodiscard]] QString file() const { return m_folder->filePath("report.journal"); }

  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestJournal::goesOn() {
  {
    Journal journal(folder(), head);
    QVERIFY(journal.entries().empty() && !journal.replacedAnother());
    journal.add(7, figures, "");
    journal.add(2, {}, "a \"reason\"\nwith lines, \xff");
  }
  Journal again(folder(), head);
  QCOMPARE(again.entries().size(), 2U);
  QVERIFY(same(again.entries().at(7).values, figures));
  QVERIFY(QString::fromStdString(again.entries().at(2).problem).startsWith("a \"reason\"\nwith"));
  again.add(9, figures, "");
  again.remove();
  QVERIFY(!QFile::exists(file()));
}

void TestJournal::anotherReport() {
  { Journal(folder(), head).add(7, figures, ""); }
  Journal other(folder(), {"l", 5, 2});
  QVERIFY(other.entries().empty());
  QVERIFY(other.replacedAnother());
}

/// kill -9 and a full disk leave any beginning of the file.
void TestJournal::cutAnywhere() {
  {
    Journal journal(folder(), head);
    for (std::size_t row = 0; row < 3; ++row) journal.add(row, figures, "");
  }
  const QByteArray whole = contentOf(file());
  const qsizetype headEnd = whole.indexOf('\n') + 1;
  for (qsizetype size = 0; size <= whole.size(); ++size) {
    writeFile(file(), whole.left(size));
    const auto lines = std::size_t(whole.left(size).count('\n'));
    {
      Journal journal(folder(), head);
      QCOMPARE(journal.entries().size(), size < headEnd ? 0 : lines - 1);
      journal.add(5, figures, "");
    }
    QCOMPARE(Journal(folder(), head).entries().size(), size < headEnd ? 1 : lines);
  }
}

void TestJournal::damaged_data() {
  QTest::addColumn<QByteArray>("line");
  QTest::newRow("not JSON") << QByteArray("\0\xff{", 3);
  QTest::newRow("another shape") << QByteArray(R"([1, 2])");
  QTest::newRow("no row") << QByteArray(R"({"mse": 1})");
  QTest::newRow("a negative row") << QByteArray(
      R"({"row":-1,"mse":"x","mseSeen":1,"ssim":1,"seen":1,"mseYuv":[1,1,1]})");
  QTest::newRow("a short list") << QByteArray(
      R"({"row":1,"mse":1,"mseSeen":1,"ssim":1,"seen":1,"mseYuv":[1],"problem":""})");
  QTest::newRow("deep") << QByteArray(200000, '[');
}

/// What stands before the damage is used.
void TestJournal::damaged() {
  QFETCH(QByteArray, line);
  { Journal(folder(), head).add(0, figures, ""); }
  const QByteArray good = contentOf(file());
  writeFile(file(), good + line + "\n" + good.mid(good.indexOf('\n') + 1));
  QCOMPARE(Journal(folder(), head).entries().size(), 1U);
  QCOMPARE(contentOf(file()), good);
}

void TestJournal::oneAtATime() {
  const Journal first(folder(), head);
  QCOMPARE(
      errorOf([&] { Journal second(folder(), head); }),
      file() + ": is in use: another hogelscope makes this report; wait, or choose another folder");
}

void TestJournal::journalsOfShards() {
  { Journal(folder(), head, Shard{10, 10}).add(3, figures, ""); }
  { Journal(folder(), {"other", 1, 1}, Shard{2, 10}).add(0, figures, ""); }
  Journal atWork(folder(), head);
  atWork.add(1, figures, "");
  for (const char* name : {"report.journal.1", "report.journal.0x1-4", "report.journal.1-4.bak",
                           "report.journal.01-4", "report.journal.-1-4", "report.journal.1-4"})
    writeFile(m_folder->filePath(name), "{\"hogelscope report\":1,\"key\":4}\n");
  QVERIFY(QFile::link(m_folder->filePath("report.journal.2-10"),
                      m_folder->filePath("report.journal.3-10")));
  const std::vector<FoundJournal> found = findJournals(folder());
  QCOMPARE(found.size(), 3U);
  QVERIFY(!found[0].shard && found[0].isInUse && found[0].head == head);
  QVERIFY(found[1].shard == Shard({2, 10}) && !found[1].isInUse && found[1].head.key == "other");
  QVERIFY(found[2].shard == Shard({10, 10}) && found[2].entries.contains(3));
  QVERIFY(same(found[2].entries.at(3).values, figures));
  QCOMPARE(errorOf([&] { (void)findJournals(folder() / "none"); }),
           m_folder->filePath("none") + ": cannot be read: No such file or directory");
}

void TestJournal::panelErrors() {
  const LightFieldSize size{2, 1, 1, 3};
  const SavedPanelError saved{
      {4, 1}, PanelError(size, {{1, 2}, {std::uint64_t{1} << 60U, 4}}, {{5, 6}, {0, 0}, {9, 9}})};
  const std::filesystem::path path = folder() / "p";
  QVERIFY(!loadPanelError(path, "k", size));
  savePanelError(path, "k", saved);
  const auto loaded = loadPanelError(path, "k", size);
  QVERIFY(loaded.has_value());
  QCOMPARE(loaded->states, saved.states);
  QVERIFY(loaded->error.hogels() == saved.error.hogels());
  QVERIFY(loaded->error.directions() == saved.error.directions());
  QVERIFY(!loadPanelError(path, "another", size));
  QVERIFY(!loadPanelError(path, "k", {2, 1, 1, 2}));
  QVERIFY(!loadPanelError(path, "k", {3, 1, 1, 3}));
  const QByteArray whole = contentOf(m_folder->filePath("p"));
  for (qsizetype bytes = 0; bytes < whole.size(); ++bytes) {
    writeFile(m_folder->filePath("p"), whole.left(bytes));
    QVERIFY(!loadPanelError(path, "k", size));
  }
}

void TestJournal::strangePanelErrors_data() {
  QTest::addColumn<QByteArray>("head");
  QTest::addColumn<bool>("isRead");
  QTest::newRow("whole") << QByteArray(R"("key": "k", "states": [1, 2])") << true;
  QTest::newRow("no states") << QByteArray(R"("key": "k")") << false;
  QTest::newRow("a number") << QByteArray(R"("key": "k", "states": 1e300)") << false;
  QTest::newRow("beyond all rows") << QByteArray(R"("key": "k", "states": [1e300])") << false;
  QTest::newRow("below 0") << QByteArray(R"("key": "k", "states": [-1])") << false;
  QTest::newRow("half a row") << QByteArray(R"("key": "k", "states": [0.5])") << false;
  QByteArray keys;
  for (int k = 0; k < 300000; ++k) keys += "\"" + QByteArray::number(k) + "\": 1, ";
  QTest::newRow("many keys") << keys + R"("key": "k", "states": [1])" << false;
}

void TestJournal::strangePanelErrors() {
  QFETCH(QByteArray, head);
  QFETCH(bool, isRead);
  constexpr qsizetype cells = 3 * sizeof(PanelError::Cell);
  writeFile(m_folder->filePath("p"),
            R"({"hogelscope panel error":1,)" + head + "}\n" + QByteArray(cells, '\0'));
  QCOMPARE(loadPanelError(folder() / "p", "k", {2, 1, 1, 1}).has_value(), isRead);
}

QTEST_GUILESS_MAIN(TestJournal)
#include "test_journal.moc"
