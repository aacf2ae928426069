// SPDX-License-Identifier: BSD-3-Clause
// Tests how input errors read, and the name that a mistyped one was meant to be.
#include <QTest>
#include <map>

#include "core/base/error.h"
#include "core/base/parameters.h"
#include "core/base/text.h"

using namespace hogelscope;

class TestParameters : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void errorsReadAsOneLine();
  void nearestName_data();
  void nearestName();
  void labels();
};

void TestParameters::errorsReadAsOneLine() {
  const InputError error("cameras[0].fov", "is 200");
  QCOMPARE(QString(error.what()), QString("cameras[0].fov: is 200"));
  QCOMPARE(QString(error.in("s.json").what()), QString("s.json: cameras[0].fov: is 200"));
  QCOMPARE(QString(error.in("s.json").in("t.json").what()), QString(error.in("s.json").what()));
  QCOMPARE(QString(InputError("s.json", "", "is no session").what()),
           QString("s.json: is no session"));
}

void TestParameters::nearestName_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("nearest");
  QTest::newRow("the same") << "fov"
                            << "fov";
  QTest::newRow("one letter wrong") << "fob"
                                    << "fov";
  QTest::newRow("one letter missing") << "windwSize"
                                      << "windowSize";
  QTest::newRow("one letter more") << "eyee"
                                   << "eye";
  QTest::newRow("swapped") << "lokoat"
                           << "lookat";
  QTest::newRow("case") << "WINDOWSIZE"
                        << "windowSize";
  QTest::newRow("half of it wrong") << "lookxyz"
                                    << "lookat";
  QTest::newRow("nothing near") << "temperature"
                                << "";
  QTest::newRow("empty") << ""
                         << "";
  QTest::newRow("very long") << QString(5000, 'f') << "";
}

void TestParameters::nearestName() {
  QFETCH(const QString, name);
  QFETCH(const QString, nearest);
  constexpr std::array<std::string_view, 4> known{"eye", "lookat", "fov", "windowSize"};
  const std::string_view found = hogelscope::nearestName(name.toStdString(), known);
  QCOMPARE(QString::fromUtf8(found.data(), qsizetype(found.size())), nearest);
}

void TestParameters::labels() {
  const std::map<std::string, std::string> labels{
      {"windowSize", "Window size"},    {"eye", "Eye"},          {"psf", "PSF"}, {"k1", "k1"},
      {"sub-aperture", "Sub aperture"}, {"fovXMax", "Fov xmax"}, {"", ""}};
  for (const auto& [name, label] : labels) QCOMPARE(formLabel(name), label);
}

QTEST_APPLESS_MAIN(TestParameters)
#include "test_parameters.moc"
