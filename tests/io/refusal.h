// SPDX-License-Identifier: BSD-3-Clause
// Tests of invalid documents: one line, status 2, no image.
#pragma once

#include <QTest>

#include "io/documents/session_file.h"
#include "tests/cli/program.h"
#include "tests/io/documents.h"

/// Adds the columns of a table of such documents.
inline void refusalColumns() {
  QTest::addColumn<QByteArray>("document");
  QTest::addColumn<QByteArray>("line");
}

/// Adds a row: the document, and the line on stderr after "hogelscope: ", as for compareLine().
inline void refused(const char* name, const QByteArray& document, const QByteArray& line) {
  QTest::newRow(name) << document << line;
}

/// Runs the real program with the row's document as s.json in `folder`.
inline void checkProgram(const QString& folder) {
  QFETCH(QByteArray, document);
  QFETCH(QByteArray, line);
  writeFile(folder + "/s.json", document);
  const QString output = folder + "/out";
  QDir(output).removeRecursively();
  const Outcome outcome =
      run({"--render", "--session", "s.json", "--output", "out", "--masks"}, folder);
  QVERIFY(outcome.err.endsWith('\n'));
  compareLine(outcome.err.chopped(1), "hogelscope: " + line);
  QCOMPARE(outcome.out, QByteArray());
  QCOMPARE(outcome.status, 2);
  QCOMPARE(namesIn(output), QStringList());
}

/// Loads the row's document in this process; the program prints such errors unchanged.
inline void checkLoading(const QString& folder) {
  QFETCH(QByteArray, document);
  QFETCH(QByteArray, line);
  QVERIFY(QDir::setCurrent(folder));
  writeFile("s.json", document);
  QByteArray error;
  try {
    (void)hogelscope::loadSession("s.json");
  } catch (const hogelscope::InputError& caught) {
    error = caught.what();
  }
  compareLine(error, line);
}
