// SPDX-License-Identifier: BSD-3-Clause
// Tests that counts read right: "1 thread", "2 threads".
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <QtTest>

#include "gui/app/translations.h"
#include "gui/session/state_commands.h"
#include "gui/view/view_worker.h"
#include "picture/scene_text.h"

using namespace hogelscope;

namespace {

QString contentOf(const QString& name) {
  QFile file(name);
  if (!file.open(QIODevice::ReadOnly)) qFatal("%s cannot be read", qPrintable(name));
  return QString::fromUtf8(file.readAll());
}

/// All of hogelscope_en.ts: source → its two forms.
QMap<QString, QStringList> forms() {
  QXmlStreamReader xml(contentOf(HOGELSCOPE_SOURCE_DIR "/resources/translations/hogelscope_en.ts"));
  QMap<QString, QStringList> all;
  QString source;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QString("source")) source = xml.readElementText();
    if (xml.name() == QString("numerusform")) all[source] << xml.readElementText();
  }
  return all;
}

}  // namespace

class TestTranslations : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { installTranslations(); }

  void countsReadRight() {
    QCOMPARE(ViewWorker::tr(", %n threads", "", 1), QString(", 1 thread"));
    QCOMPARE(ViewWorker::tr(", %n threads", "", 2), QString(", 2 threads"));
    QCOMPARE(StateCommands::tr("Delete %n states", "", 1), QString("Delete state"));
    QCOMPARE(StateCommands::tr("Delete %n states", "", 3), QString("Delete 3 states"));
    PixelTrace traced;
    traced.taps = 1;
    QVERIFY(SceneText::pixel(0, 0, traced).endsWith(" · 1 leakage tap"));
    traced.taps = 25;
    QVERIFY(SceneText::pixel(0, 0, traced).endsWith(" · 25 leakage taps"));
  }

  /// And none of the forms is left empty.
  void everyCountOfTheSourcesHasItsForms() {
    const QMap<QString, QStringList> known = forms();
    for (const QStringList& each : known) QVERIFY(each.size() == 2 && !each.contains(QString()));
    static const QRegularExpression count(R"rx(tr\(\s*"([^"]*%n[^"]*)")rx");
    QDirIterator files(HOGELSCOPE_SOURCE_DIR "/src", {"*.cpp"}, QDir::Files,
                       QDirIterator::Subdirectories);
    QStringList found;
    while (files.hasNext())
      for (const auto& match : count.globalMatch(contentOf(files.next())))
        found << match.captured(1);
    QVERIFY(found.size() >= 6);
    for (const QString& source : found) QVERIFY2(known.contains(source), qPrintable(source));
    for (const QString& source : known.keys()) QVERIFY2(found.contains(source), qPrintable(source));
  }
};

QTEST_GUILESS_MAIN(TestTranslations)
#include "test_translations.moc"
