// SPDX-License-Identifier: BSD-3-Clause
// Tests that the pictures in resources have no texts inside: programs that make them write their
// command lines there, with paths of the machine. The manual shows them to everybody.
#include <QDirIterator>
#include <QTest>
#include <QtEndian>

namespace {

/// Returns the types of a PNG's chunks.
QByteArrayList chunksOf(const QByteArray& png) {
  constexpr int signature = 8;
  constexpr int frame = 12;  // length, type and checksum
  QByteArrayList types;
  for (qsizetype at = signature; at + frame <= png.size();) {
    types.append(png.mid(at + 4, 4));
    at += frame + qsizetype(qFromBigEndian<quint32>(png.constData() + at));
  }
  return types;
}

}  // namespace

class TestPictures : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void haveNoTexts() {
    int count = 0;
    QDirIterator at(HOGELSCOPE_SOURCE_DIR "/resources", {"*.png"}, QDir::Files,
                    QDirIterator::Subdirectories);
    while (at.hasNext()) {
      QFile file(at.next());
      QVERIFY(file.open(QIODevice::ReadOnly));
      const QByteArrayList chunks = chunksOf(file.readAll());
      QVERIFY2(chunks.contains("IDAT") && chunks.contains("IEND"), qPrintable(file.fileName()));
      for (const char* text : {"tEXt", "zTXt", "iTXt", "eXIf"})
        QVERIFY2(!chunks.contains(text), qPrintable(file.fileName() + " has " + text));
      ++count;
    }
    QVERIFY(count > 20);
  }
};

QTEST_GUILESS_MAIN(TestPictures)
#include "test_pictures.moc"
