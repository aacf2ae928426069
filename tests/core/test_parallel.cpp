// SPDX-License-Identifier: BSD-3-Clause
// Tests work on several threads: every piece once, errors, and that it is at the same time; and its
// progress.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTest>
#include <QThread>
#include <atomic>
#include <barrier>
#include <csignal>
#include <fstream>
#include <mutex>
#include <set>
#include <thread>

#include "core/base/parallel.h"
#include "core/base/progress.h"

using namespace hogelscope;

class TestSideBySide : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void rowsWithoutThreads();
  void everyPieceOnce();
  void atTheSameTime();
  void errors();
  void progressOfSteps();
  void progressStops();
  void progressForThreads();
  void fractionsAreKept();
};

/// A process without memory for a thread's stack. It must be the first to ask for threads.
void TestSideBySide::rowsWithoutThreads() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  QSKIP("the sanitizer's own memory is beyond any limit");
#endif
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGABRT, SIG_DFL);  // Qt's handler would wait for threads that are not here
    std::thread(::pause).detach();  // takes the stack that the parent's thread has left
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t bytes = pages * std::size_t(::sysconf(_SC_PAGESIZE)) + (rlim_t{1} << 20U);
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_AS, &limit);
    std::atomic<int> rows = 0;
    try {
      parallelRows(1000, [&](int begin, int end) { rows += end - begin; });
    } catch (...) {
      ::_exit(2);
    }
    ::_exit(rows == 1000 ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  QVERIFY2(WIFEXITED(status) && WEXITSTATUS(status) == 0, QByteArray::number(status));
}

void TestSideBySide::everyPieceOnce() {
  for (const int workers : {1, 2, 7}) {
    std::vector<std::atomic<int>> calls(500);
    std::mutex mutex;
    std::set<std::size_t> names;
    sideBySide(calls.size(), workers, [&](std::size_t k, std::size_t worker) {
      ++calls[k];
      const std::lock_guard lock(mutex);
      names.insert(worker);
    });
    for (const auto& count : calls) QCOMPARE(count.load(), 1);
    QVERIFY(*names.rbegin() < std::size_t(workers));
  }
  sideBySide(0, 3, [](std::size_t, std::size_t) { QFAIL("there is nothing to do"); });
}

/// Each of three pieces waits for the others: one thread alone would wait for ever.
void TestSideBySide::atTheSameTime() {
  std::barrier all(3);
  sideBySide(3, 3, [&](std::size_t, std::size_t) { all.arrive_and_wait(); });
}

void TestSideBySide::errors() {
  for (const int workers : {1, 3}) {
    std::atomic<int> begun = 0;
    QVERIFY_THROWS_EXCEPTION(Cancelled,
                             sideBySide(100000, workers, [&](std::size_t k, std::size_t) {
                               ++begun;
                               if (k == 10) throw Cancelled();
                               QThread::usleep(50);  // 10 comes to its end before the last ones
                             }));
    QVERIFY2(begun < 100000, "the others went on");
  }
}

void TestSideBySide::progressOfSteps() {
  std::vector<double> told;
  StepProgress progress([&](double done) {
    told.push_back(done);
    return true;
  });
  progress.expect(6);
  progress.expect(4);
  progress.finish(5);
  QTest::qSleep(30);
  QVERIFY(progress.of(4)(0.25));
  QTest::qSleep(30);
  QVERIFY(progress.within()(0.9));
  QCOMPARE(told, (std::vector{0.5, 0.6, 0.6}));  // never back
}

void TestSideBySide::progressStops() {
  int calls = 0;
  StepProgress progress([&](double) { return ++calls < 2; });
  progress.expect(3);
  progress.finish();
  QTest::qSleep(30);
  QVERIFY_THROWS_EXCEPTION(Cancelled, progress.finish());
  QTest::qSleep(30);
  QVERIFY(!progress.within()(0));
  QCOMPARE(calls, 2);  // who said stop is not asked again
}

/// From several threads: one call at a time, never backwards, and who said stop is not asked again.
void TestSideBySide::progressForThreads() {
  QVERIFY(!forThreads({}));
  std::atomic<int> inside = 0;
  int calls = 0;
  double farthest = -1;
  bool isInOrder = true;
  const Progress progress = forThreads([&](double done) {
    isInOrder = isInOrder && ++inside == 1 && done >= farthest;
    farthest = done;
    QTest::qSleep(2);
    --inside;
    return ++calls < 4;
  });
  std::atomic<int> stopped = 0;
  sideBySide(4, 4, [&](std::size_t k, std::size_t) {
    while (progress(k == 0 ? 0.5 : 0)) {
    }
    ++stopped;
  });
  QVERIFY(isInOrder);
  QCOMPARE(stopped.load(), 4);
  QVERIFY(!progress(1));
  QCOMPARE(calls, 4);
}

/// A fraction between two calls of the listener is not lost, though most calls only ask.
void TestSideBySide::fractionsAreKept() {
  std::vector<double> told;
  const Progress progress = forThreads([&](double done) {
    told.push_back(done);
    return told.size() < 2;
  });
  QVERIFY(progress(0));
  QVERIFY(progress(0.5));
  while (progress(0)) continue;
  QCOMPARE(told, (std::vector{0.0, 0.5}));
}

QTEST_GUILESS_MAIN(TestSideBySide)
#include "test_parallel.moc"
