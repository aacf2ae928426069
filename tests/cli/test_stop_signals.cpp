// SPDX-License-Identifier: BSD-3-Clause
// Tests that a process of batch mode ends after a signal wherever it is, without temporary files.
#include <sys/wait.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <csignal>
#include <functional>

#include "cli/stop_signals.h"
#include "io/files/atomic_file.h"
#include "io/files/temporary_files.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

/// A process that has begun a file, and then does `work`, which does not return.
class Child {
 public:
  explicit Child(const std::function<void()>& work) {
    std::array<int, 2> ready{};
    if (::pipe(ready.data()) != 0) qFatal("no pipe");
    m_process = ::fork();
    if (m_process == 0) {
      catchSignals();
      const AtomicFile file("begun.txt");
      writeAll(file.descriptor(), "half of it", "begun.txt");
      registerTemporary("named.part");  // as where the file system has no files without names
      writeFile("named.part", "half of it");
      (void)!::write(ready[1], "!", 1);
      work();
      ::_exit(99);
    }
    ::close(ready[1]);
    char byte = 0;
    if (::read(ready[0], &byte, 1) != 1) qFatal("the child has ended");
    ::close(ready[0]);
  }

  void send(int signal) const { ::kill(m_process, signal); }
  /// The signal that it ended by, or -1.
  [[nodiscard]] int end() const {
    int status = 0;
    ::waitpid(m_process, &status, 0);
    return WIFSIGNALED(status) ? WTERMSIG(status) : -1;
  }

 private:
  pid_t m_process = -1;
};

[[noreturn]] void sleepForEver() {
  for (;;) ::pause();
}

/// Hears the signal, and then does not come to its end.
void hearAndSleep() {
  while (!mustStop()) QTest::qSleep(1);
  sleepForEver();
}

}  // namespace

class TestStopSignals : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir::setCurrent(m_folder->path()));
    std::signal(SIGINT, SIG_DFL);  // a script that starts the tests with `&` ignores it
  }

  void nobodyHears() {
    const Child child(sleepForEver);
    QCOMPARE(namesIn(".").size(), 1);
    child.send(SIGTERM);
    QCOMPARE(child.end(), SIGTERM);
    QCOMPARE(namesIn("."), QStringList());
  }

  void heardButDoesNotEnd() {
    const Child child(hearAndSleep);
    child.send(SIGINT);
    QCOMPARE(child.end(), SIGINT);
    QCOMPARE(namesIn("."), QStringList());
  }

  void twoSignals() {
    const Child child(hearAndSleep);
    child.send(SIGINT);
    child.send(SIGTERM);
    const int last = child.end();
    QVERIFY(last == SIGTERM || last == SIGINT);
    QCOMPARE(namesIn("."), QStringList());
  }

  /// As of a script's `job &`.
  void ignoredStaysIgnored() {
    std::signal(SIGINT, SIG_IGN);
    const Child child(hearAndSleep);
    std::signal(SIGINT, SIG_DFL);
    child.send(SIGINT);
    child.send(SIGTERM);
    QCOMPARE(child.end(), SIGTERM);
    QCOMPARE(namesIn("."), QStringList());
  }

  void stopsInOrder() {
    const Child child([] {
      while (!mustStop()) QTest::qSleep(1);
      endBySignal();
    });
    child.send(SIGTERM);
    QCOMPARE(child.end(), SIGTERM);
    QCOMPARE(namesIn("."), QStringList());
  }

  /// What has its name is not temporary any more, and what was given up is not there.
  void otherFilesStay() {
    const Child child([] {
      writeTextFile("whole.txt", "all of it");
      { const AtomicFile givenUp("given up.txt"); }
      sleepForEver();
    });
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists("whole.txt"), 120000);
    child.send(SIGTERM);
    QCOMPARE(child.end(), SIGTERM);
    QCOMPARE(namesIn("."), QStringList{"whole.txt"});
    QCOMPARE(contentOf("whole.txt"), QByteArray("all of it"));
  }

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(TestStopSignals)
#include "test_stop_signals.moc"
