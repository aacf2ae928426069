// SPDX-License-Identifier: BSD-3-Clause
// Session documents and files for tests of reading and writing.
#pragma once

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <functional>

#include "core/base/error.h"

/// The sections of a document as JSON.
struct Sections {
  QByteArray display = R"({"hogels": [4, 3], "directions": [5, 6]})";
  QByteArray lightField = R"({"file": "scene.png"})";
  QByteArray sampling = "{}";
  QByteArray cameras = R"([{"name": "a", "psf": {"sigma": 1.5, "windowSize": 9}}, {"name": "b"}])";
};

inline QByteArray text(const Sections& sections = {}) {
  return R"({"hogelscope": 1, "display": )" + sections.display + R"(, "lightField": )" +
         sections.lightField + R"(, "sampling": )" + sections.sampling + R"(, "cameras": )" +
         sections.cameras + "}";
}

/// Returns the exception of `action` as main() prints it; "" if there is none.
inline QString errorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const hogelscope::InputError& error) {
    return error.what();
  } catch (const std::exception& error) {
    return QString("not an InputError: ") + error.what();
  }
  return {};
}

/// Compares lines. An `expected` line that ends with "…" is a prefix, followed by a library's text.
inline void compareLine(const QByteArray& line, const QByteArray& expected) {
  const QByteArray more = "…";
  const bool isBegin = expected.endsWith(more);
  const QByteArray begin = isBegin ? expected.chopped(more.size()) : expected;
  QCOMPARE(isBegin ? line.left(begin.size()) : line, begin);
  QVERIFY(!isBegin || (line.size() > begin.size() && !line.contains('\n')));
}

/// Writes a file, and creates its folder.
inline void writeFile(const QString& file, const QByteArray& content) {
  QDir().mkpath(QFileInfo(file).path());
  QFile out(file);
  if (!out.open(QIODevice::WriteOnly) || out.write(content) != content.size())
    qFatal("cannot write %s", qPrintable(file));
}

inline QByteArray contentOf(const QString& file) {
  QFile in(file);
  return in.open(QIODevice::ReadOnly) ? in.readAll() : "cannot be read: " + file.toUtf8();
}

/// Returns all entries of a folder, including hidden files and broken links.
inline QStringList namesIn(const QString& folder) {
  return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::System |
                                QDir::NoDotAndDotDot);
}
