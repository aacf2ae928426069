// SPDX-License-Identifier: BSD-3-Clause
// Runs the real program like a user, without a display server.
#pragma once

#include <unistd.h>

#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QStringList>
#include <csignal>

/// Programs inherit what is ignored, as SIGINT is where a script has started the tests with `&`.
inline const auto signalBefore = std::signal(SIGINT, SIG_DFL);

struct Outcome {
  int status = -1;  ///< exit status; -1 if a signal ended it, or it did not start
  QByteArray out;
  QByteArray err;
};

/// Returns the environment of a batch machine: no display server, and no Qt platform.
inline QProcessEnvironment withoutDisplay() {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
    environment.remove(name);
  return environment;
}

inline void start(QProcess& process, const QStringList& arguments, const QString& folder) {
  process.setProcessEnvironment(withoutDisplay());
  process.setWorkingDirectory(folder);
  process.start(HOGELSCOPE_PROGRAM, arguments);
}

/// Waits without a limit, because ctest ends hanging tests.
inline void waitForEnd(QProcess& process) {
  if (process.state() != QProcess::NotRunning) process.waitForFinished(-1);
}

inline Outcome ended(QProcess& process) {
  waitForEnd(process);
  const bool hasCrashed =
      process.exitStatus() != QProcess::NormalExit || process.error() == QProcess::FailedToStart;
  return {hasCrashed ? -1 : process.exitCode(), process.readAllStandardOutput(),
          process.readAllStandardError()};
}

/// Runs the program in `folder` and waits for its end.
inline Outcome run(const QStringList& arguments, const QString& folder) {
  QProcess process;
  start(process, arguments, folder);
  return ended(process);
}

/// Waits until `isThere()`. Returns false if the process has ended before.
template <class Condition>
bool waitUntil(QProcess& process, Condition isThere) {
  while (!isThere()) {
    if (process.state() == QProcess::NotRunning || process.waitForFinished(1)) return isThere();
  }
  return true;
}

/// Sends a signal unless the process has ended: its number is then 0, which means this whole
/// process group.
inline void send(const QProcess& process, int signal) {
  if (process.processId() > 0) ::kill(pid_t(process.processId()), signal);
}

/// Returns seconds on all cores, which measure the progress even on a busy machine.
inline double cpuSeconds(const QProcess& process) {
  QFile file(QString("/proc/%1/stat").arg(process.processId()));
  if (!file.open(QIODevice::ReadOnly)) return 0;
  const QByteArray text = file.readAll();
  const QList<QByteArray> fields = text.mid(text.lastIndexOf(')') + 2).split(' ');
  return (fields.value(11).toDouble() + fields.value(12).toDouble()) /
         double(::sysconf(_SC_CLK_TCK));
}

/// The paper's six states, with a light field like the sample's but a sixteenth of its hogels.
inline const QString sampleSession =
    QStringLiteral(HOGELSCOPE_SOURCE_DIR "/tests/data/table1.json");
