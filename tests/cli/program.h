// SPDX-License-Identifier: BSD-3-Clause
// Runs the real program as a user would, without a display server.
#pragma once

#include <QProcess>
#include <QProcessEnvironment>
#include <QStringList>

struct Outcome {
  int status = -1;  ///< exit status; -1 if it crashed, or was killed for taking too long
  QString why;      ///< of the -1
  QByteArray out;
  QByteArray err;
};

/// The environment of a batch machine: no display server, and no platform chosen for Qt.
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

/// Runs it in `folder` and waits, `limit` milliseconds at most.
inline Outcome run(const QStringList& arguments, const QString& folder, int limit = 30000) {
  QProcess process;
  start(process, arguments, folder);
  const bool ended = process.waitForFinished(limit);
  if (!ended) process.kill();
  process.waitForFinished();
  Outcome outcome{-1, {}, process.readAllStandardOutput(), process.readAllStandardError()};
  if (ended && process.exitStatus() == QProcess::NormalExit)
    outcome.status = process.exitCode();
  else
    outcome.why = ended ? QString("crashed") : QString("still at work after %1 ms").arg(limit);
  return outcome;
}

/// The paper's six states, on the sample light field.
inline const QString sampleSession = QStringLiteral(HOGELSCOPE_SOURCE_DIR "/data/table1.json");
