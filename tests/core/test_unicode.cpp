// SPDX-License-Identifier: BSD-3-Clause
// Tests the reading of UTF-8 against Qt's, and that foreign text becomes harmless.
#include "core/base/text.h"

#include <QStringDecoder>
#include <QTest>
#include <random>
#include <set>

using namespace hogelscope;

namespace {

bool isUtf8(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const Character next = characterAt(text, at);
    if (!next.point) return false;
    at += next.bytes;
  }
  return true;
}

bool isUtf8ForQt(const std::string& text) {
  QStringDecoder decoder(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
  const QString decoded = decoder(QByteArrayView(text.data(), qsizetype(text.size())));
  return !decoder.hasError();
}

}  // namespace

class TestUnicode : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void isReadAsQtDoes();
  void controlsAreEscaped_data();
  void controlsAreEscaped();
  void nothingHarmfulIsLeft();
};

void TestUnicode::isReadAsQtDoes() {
  // Every lead with every second byte and two tails, which finds all limits of RFC 3629.
  for (int lead = 1; lead < 256; ++lead)
    for (int second = 1; second < 256; ++second)
      for (const char* tail : {"", "\x80", "\xbf\xbf", "a"}) {
        const std::string text = std::string{char(lead), char(second)} + tail;
        QVERIFY2(isUtf8(text) == isUtf8ForQt(text), QByteArray::fromStdString(text).toHex());
      }
}

void TestUnicode::controlsAreEscaped_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QByteArray>("shown");
  QTest::newRow("plain") << QByteArray("Größe 測試 \u05d0.png")
                         << QByteArray("Größe 測試 \u05d0.png");
  QTest::newRow("lines") << QByteArray("a\nb\tc") << QByteArray("a\\x0ab\\x09c");
  QTest::newRow("colours") << QByteArray("\x1b[31m\x7f") << QByteArray("\\x1b[31m\\x7f");
  QTest::newRow("C1") << QByteArray("\u009b31m\u0085") << QByteArray("\\u009b31m\\u0085");
  QTest::newRow("bidirectional") << QByteArray("a\u202egnp.exe\u2066")
                                 << QByteArray("a\\u202egnp.exe\\u2066");
  QTest::newRow("not UTF-8") << QByteArray("\xff\xc3") << QByteArray("\\xff\\xc3");
  QTest::newRow("too long") << QByteArray("\xc0\x8a\xe0\x80\x8a")
                            << QByteArray("\\xc0\\x8a\\xe0\\x80\\x8a");
  QTest::newRow("surrogate") << QByteArray("\xed\xa0\x80") << QByteArray("\\xed\\xa0\\x80");
}

void TestUnicode::controlsAreEscaped() {
  QFETCH(const QByteArray, text);
  QFETCH(const QByteArray, shown);
  QCOMPARE(QByteArray::fromStdString(printable(text.toStdString())), shown);
}

void TestUnicode::nothingHarmfulIsLeft() {
  const std::set turning{QChar::DirLRE, QChar::DirLRO, QChar::DirRLE, QChar::DirRLO, QChar::DirPDF,
                         QChar::DirLRI, QChar::DirRLI, QChar::DirFSI, QChar::DirPDI};
  std::mt19937 random(7);
  for (int k = 0; k < 20000; ++k) {
    std::string text;
    for (unsigned n = random() % 12; n > 0; --n) {
      // Leads and tails of U+0080 to U+20FF often.
      const unsigned kind = random() % 4;
      text += char(kind == 0   ? random() % 256
                   : kind == 1 ? 0xc2
                   : kind == 2 ? 0xe2
                               : 0x80 + random() % 64);
    }
    const QString line = QString::fromStdString(printable(text));
    for (const QChar c : line) {
      QVERIFY2(!turning.contains(c.direction()) && c.category() != QChar::Other_Control &&
                   c.category() != QChar::Separator_Line &&
                   c.category() != QChar::Separator_Paragraph,
               line.toUtf8());
    }
    QCOMPARE(printable(printable(text)), printable(text));
  }
}

QTEST_APPLESS_MAIN(TestUnicode)
#include "test_unicode.moc"
