// SPDX-License-Identifier: BSD-3-Clause
// Tests what counts in the allowed memory: limits of control groups, light fields of all layouts,
// units; and that drawing a unit's errors can be stopped.
#include <QTemporaryDir>
#include <QTest>

#include "io/documents/session_file.h"
#include "io/files/system_limits.h"
#include "io/scene/light_field_export.h"
#include "io/scene/view_source.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

constexpr std::size_t little = 20000;  // bytes

/// Allows little memory while it lives.
class LittleMemory {
 public:
  LittleMemory() { allowMemory(little); }
  LittleMemory(const LittleMemory&) = delete;
  LittleMemory& operator=(const LittleMemory&) = delete;
  ~LittleMemory() { allowMemory(0); }
};

LightFieldParams paramsOf(Layout layout, const std::string& file) {
  LightFieldParams params;
  params.layout = layout;
  params.file = file;
  return params;
}

}  // namespace

class TestMemoryLimits : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void groups_data();
  void groups();
  void lightFields_data();
  void lightFields();
  void units();
  void drawsCanBeStopped();

 private:
  QTemporaryDir m_folder;
};

void TestMemoryLimits::initTestCase() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
  writeFile("two/memory.max", "max\n");
  writeFile("two/job/memory.max", "3000000000\n");
  writeFile("two/job/step/memory.max", "max\n");
  writeFile("one/memory/job/memory.limit_in_bytes", "2000000000\n");
  writeFile("one/memory/memory.limit_in_bytes", "9223372036854771712\n");
}

void TestMemoryLimits::groups_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("root");
  QTest::addColumn<qulonglong>("bytes");  // 0: no limit
  QTest::newRow("of the group") << "0::/job\n"
                                << "two" << 3000000000ULL;
  QTest::newRow("of a group around it") << "0::/job/step\n"
                                        << "two" << 3000000000ULL;
  QTest::newRow("none") << "0::/\n"
                        << "two" << 0ULL;
  QTest::newRow("the first version") << "4:cpu,cpuacct:/\n3:memory:/job\n"
                                     << "one" << 2000000000ULL;
  QTest::newRow("another group's") << "3:cpu:/job\n"
                                   << "one" << 0ULL;
  QTest::newRow("nothing there") << "0::/job\n"
                                 << "nothing" << 0ULL;
  QTest::newRow("other text") << "0\nabc:\n"
                              << "two" << 0ULL;
}

void TestMemoryLimits::groups() {
  QFETCH(QString, text);
  QFETCH(QString, root);
  QFETCH(qulonglong, bytes);
  QCOMPARE(qulonglong(memoryOfGroups(text.toStdString(), root.toStdString()).value_or(0)), bytes);
}

void TestMemoryLimits::lightFields_data() {
  QTest::addColumn<int>("layout");
  QTest::addColumn<QString>("file");
  QTest::newRow("hogels") << int(Layout::hogels) << "hogels.png";
  QTest::newRow("views") << int(Layout::views) << "views";
  QTest::newRow("mosaic") << int(Layout::mosaic) << "mosaic.png";
}

/// 16×16 hogels of 8×8 directions are 66 kB: read as a whole they are refused, with advice.
void TestMemoryLimits::lightFields() {
  QFETCH(int, layout);
  QFETCH(QString, file);
  Session session = newSession();
  session.display.hogels = {16, 16};
  session.display.directions = {8, 8};
  const auto scene = openLightField(session.lightField, session.display);
  const Layout stored = static_cast<Layout>(layout);
  (stored == Layout::hogels  ? exportHogels
   : stored == Layout::views ? exportViews
                             : exportMosaic)(*scene, file.toStdString(), {});
  session.lightField = paramsOf(stored, file.toStdString());
  (void)loadViewSource(session, {});
  const LittleMemory memory;
  const QString error = errorOf([&] { (void)loadViewSource(session, {}); });
  QVERIFY2(error.contains("of memory, 20 kB are allowed: allow more, or pack it into a store"),
           qPrintable(error));
  QVERIFY2(error.startsWith(file), qPrintable(error));
}

void TestMemoryLimits::units() {
  Session session = newSession();
  session.display.hogels = {20000, 20000};  // 19 GB, if they were drawn
  session.display.directions = {2, 2};
  session.twin.random.shift.sigma = 1e-6;
  allowMemory(1000000000);
  const QString error = errorOf([&] { (void)loadViewSource(session, {}); });
  allowMemory(0);
  QVERIFY2(error.contains("needs 19.2 GB of memory, 1 GB are allowed: allow more"),
           qPrintable(error));
  session.display.hogels = {16, 16};
  (void)loadViewSource(session, {});
}

void TestMemoryLimits::drawsCanBeStopped() {
  Session session = newSession();
  session.display.hogels = {2000, 2000};
  session.display.directions = {2, 2};
  session.twin.random.shift.sigma = 1e-6;
  session.twin.random.shift.length = 100;
  int asked = 0;
  const auto stop = [&](double) { return ++asked < 10; };
  bool isStopped = false;
  try {
    (void)twinOf(session.twin, displayOf(session), nullptr, stop);
  } catch (const Cancelled&) {
    isStopped = true;
  }
  QVERIFY(isStopped);
  QCOMPARE(asked, 10);
}

QTEST_GUILESS_MAIN(TestMemoryLimits)
#include "test_memory_limits.moc"
