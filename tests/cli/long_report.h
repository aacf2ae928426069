// SPDX-License-Identifier: BSD-3-Clause
// A report that runs long enough to be stopped, and the contents of its folder.
#pragma once

#include <QDir>
#include <QFile>

#include "tests/io/documents.h"
#include "tests/io/images.h"

inline constexpr int stateCount = 40;

inline float content(int x, int y, int channel) {
  return float((x * 5 + y * 3 + channel * 40 + (x / 16) * (y / 8)) % 200 + 20) / 255;
}

inline float noisy(int x, int y, int channel) {
  return content(x, y, channel) + float((x * 7919 + y * 104729 + channel) % 16) / 255;
}

/// Returns a session slow enough to be killed: 4 rays per pixel with 25 taps each.
inline QByteArray longSession() {
  QByteArray cameras;
  for (int k = 0; k < stateCount; ++k)
    cameras += (k == 0 ? "" : ", ") + QByteArray("{\"name\": \"s") + QByteArray::number(k + 10) +
               "\", \"eye\": [" + QByteArray::number(0.01 * k - 0.2) +
               ", 0, 0.7], \"fov\": 45, \"res\": [90, 68], \"psf\": {\"sigma\": 0.8, "
               "\"windowSize\": 5}}";
  return text({.display = R"({"hogels": [16, 16], "directions": [8, 8]})",
               .lightField = R"({"file": "a.png"})",
               .sampling = R"({"samplesPerPixel": 2})",
               .cameras = "[" + cameras + "]"});
}

inline QStringList report(const QString& output, const QStringList& more = {}) {
  return QStringList{"--report", "--session", "s.json",   "--test", "b.png",
                     "--test",   "c.png",     "--output", output,   "--images"} +
         more;
}

/// Returns the number of rows in the journal.
inline int rowsIn(const QString& folder, const QString& ending = {}) {
  QFile journal(folder + "/report.journal" + ending);
  return journal.open(QIODevice::ReadOnly) ? int(journal.readAll().count('\n')) - 1 : 0;
}

/// Returns the first difference between two folders, or ""; ignores report.html, which contains a
/// time.
inline QString difference(const QString& a, const QString& b) {
  if (namesIn(a) != namesIn(b)) return namesIn(a).join(' ') + " | " + namesIn(b).join(' ');
  for (const QString& name : namesIn(a)) {
    const QString one = a + "/" + name;
    const QString other = b + "/" + name;
    if (QFileInfo(one).isDir()) {
      if (const QString within = difference(one, other); !within.isEmpty()) return within;
    } else if (name != "report.html" && contentOf(one) != contentOf(other)) {
      return one;
    }
  }
  return {};
}

/// Writes s.json for a.png, and two tests, b.png and c.png.
inline void writeLongSession() {
  writeImageFile("a.png", 128, 128, content);
  writeImageFile("b.png", 128, 128, noisy);
  writeImageFile("c.png", 128, 128, [](int x, int y, int c) { return noisy(y, x, c); });
  writeFile("s.json", longSession());
}
