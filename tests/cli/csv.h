// SPDX-License-Identifier: BSD-3-Clause
// Reads report.csv and compares its numbers with the expected ones.
#pragma once

#include <QFile>
#include <QRegularExpression>
#include <QStringList>
#include <cmath>
#include <vector>

#include "core/base/geometry.h"
#include "core/metrics/metric.h"

/// Returns the cells of a line (RFC 4180).
inline QStringList cellsOf(const QByteArray& line) {
  QStringList cells{""};
  bool isQuoted = false;
  for (const QChar c : QString::fromUtf8(line)) {
    if (c == '"') {
      if (!isQuoted && cells.back().size() > 0) cells.back() += c;
      isQuoted = !isQuoted;
    } else if (c == ',' && !isQuoted) {
      cells << "";
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

/// Returns all lines of a file.
inline QList<QStringList> tableOf(const QString& name) {
  QList<QStringList> table;
  QFile file(name);
  if (!file.open(QIODevice::ReadOnly)) return table;
  for (const QByteArray& line : file.readAll().split('\n'))
    if (!line.isEmpty()) table << cellsOf(line);
  return table;
}

/// Whether the cell reads back as `number` and has at most 17 significant digits.
inline bool says(const QString& cell, double number) {
  if (std::isnan(number)) return cell == "nan";
  if (std::isinf(number)) return cell == "inf";
  const QString digits = QString(cell).section('e', 0, 0).remove('.').remove('-');
  const qsizetype zeros = digits.size() - QString(digits).remove(QRegularExpression("^0+")).size();
  return cell.toDouble() == number && digits.size() - zeros <= 17;
}

inline bool saysAll(const QStringList& cells, const std::vector<double>& values,
                    const hogelscope::Vec3& eye) {
  using namespace hogelscope;
  const std::vector<double> numbers{values[mseColumn],
                                    values[psnrColumn],
                                    values[mseSeenColumn],
                                    values[psnrSeenColumn],
                                    values[ssimColumn],
                                    values[seenColumn],
                                    eye.x,
                                    eye.y,
                                    eye.z};
  if (cells.size() != int(numbers.size()) + 2) return false;
  for (std::size_t k = 0; k < numbers.size(); ++k)
    if (!says(cells[int(k) + 2], numbers[k])) return false;
  return true;
}
