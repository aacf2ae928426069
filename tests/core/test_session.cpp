// SPDX-License-Identifier: BSD-3-Clause
// Tests the rules that join a session's fields, with their messages.
#include <QTest>
#include <cmath>
#include <functional>
#include <string_view>

#include "core/optics/session.h"
#include "tests/io/documents.h"

using namespace hogelscope;
using namespace std::string_view_literals;

using Change = std::function<void(Session&)>;
Q_DECLARE_METATYPE(Change)

namespace {

CameraState state(const std::string& name) {
  CameraState result;
  result.camera.name = name;
  return result;
}

Session goodSession() {
  Session session;
  session.lightField.file = "scene.png";
  session.display.hogels = {4, 3};
  session.display.directions = {5, 6};
  session.cameras = {state("left"), state("right")};
  return session;
}

}  // namespace

class TestSession : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void goodSessionsPass();
  void badSession_data();
  void badSession();
  void badNames_data();
  void badNames();
  void goodNames();
  void namesDifferInMoreThanCase_data();
  void namesDifferInMoreThanCase();
  void aTwinMayNeedLinearLight();
  void warnsOfCutWindows();
  void resolvedTakesWhatIsLeftOut();
  void resolvedRefusesWhatDiffers();
};

void TestSession::goodSessionsPass() {
  QCOMPARE(errorOf([] { check(goodSession()); }), QString());
  Session views = goodSession();
  views.display.hogels = {0, 0};
  views.display.directions = {0, 0};
  views.lightField.layout = Layout::views;
  QCOMPARE(errorOf([&] { check(views); }), QString());
  views.lightField.layout = Layout::quilt;
  QCOMPARE(errorOf([&] { check(views); }), QString());
  Session unleaked = goodSession();
  unleaked.cameras[0].psf = {0, 1};
  QCOMPARE(errorOf([&] { check(unleaked); }), QString());
}

void TestSession::badSession_data() {
  QTest::addColumn<Change>("change");
  QTest::addColumn<QString>("message");
  const auto row = [](const char* name, const Change& change, const char* message) {
    QTest::newRow(name) << change << QString(message);
  };
  row(
      "a focal length of 0", [](Session& s) { s.cameras[0].intrinsics.fx = 0; },
      "cameras[0].intrinsics.fx: and fy are focal lengths, above 0 px");
  row(
      "a focal length that is no number",
      [](Session& s) {
        s.cameras[0].intrinsics = {5, NAN};
      },
      "cameras[0].intrinsics.fx: and fy are focal lengths, above 0 px");
  row(
      "no file", [](Session& s) { s.lightField.file = ""; },
      "lightField.file: is missing: name the image or folder to show");
  row(
      "no hogels",
      [](Session& s) {
        s.display.hogels = {0, 0};
      },
      "display.hogels: is missing: a hogel image does not say it");
  row(
      "no directions",
      [](Session& s) {
        s.display.directions = {0, 0};
      },
      "display.directions: is missing: a hogel image does not say it");
  row(
      "no cameras", [](Session& s) { s.cameras.clear(); },
      "cameras: is empty: give at least one camera state");
  row(
      "same names", [](Session& s) { s.cameras[1].camera.name = "left"; },
      "cameras[1].name: \"left\" is also cameras[0]; every state has a name of its own");
  row(
      "no frame", [](Session& s) { s.cameras[1].camera.lookat = s.cameras[1].camera.eye; },
      "cameras[1].lookat: is the eye itself: the camera looks nowhere");
  row(
      "no roll",
      [](Session& s) {
        s.cameras[0].camera.up = {0, 0, 1};
      },
      "cameras[0].up: is parallel to the line from eye to lookat");
  row(
      "sigma 0",
      [](Session& s) {
        s.cameras[1].psf = {0, 5};
      },
      "cameras[1].psf.sigma: is 0 with a windowSize of 5: give a sigma above 0, or windowSize 1 "
      "for no leakage");
}

void TestSession::badSession() {
  QFETCH(const Change, change);
  QFETCH(const QString, message);
  Session session = goodSession();
  change(session);
  QCOMPARE(errorOf([&] { check(session); }), message);
}

void TestSession::badNames_data() {
  QTest::addColumn<QByteArray>("name");
  QTest::addColumn<QString>("why");
  const QString slash = "has a slash; it names the picture's file";
  const QString control = "has a control character or one that changes the direction of writing";
  const QString ends =
      "begins or ends with a space, or ends with a dot; it names the picture's file";
  const QString device = "is a device's name on Windows; it names the picture's file";
  const auto row = [](const char* name, const QByteArray& bad, const QString& why) {
    QTest::newRow(name) << bad << why;
  };
  row("empty", "", "is missing: every state has a name of its own");
  row("long", QByteArray(201, 'a'), "is longer than 200 bytes");
  row("long in bytes", QByteArray("é").repeated(101), "is longer than 200 bytes");
  row("slash", "a/b", slash);
  row("backslash", "a\\b", slash);
  row("line end", "a\nb", control);
  row("delete", "a\x7f", control);
  row("null", QByteArray(1, '\0'), control);
  row("escape of a terminal", "a\x1b[31m", control);
  row("escape in one character, U+009B", "a\xc2\x9b", control);
  // As UTF-16: QString::fromUtf8 drops U+FEFF at the beginning.
  for (const char16_t bad : u"\u061c\u200e\u200f\u202a\u202e\u2066\u2069"sv)
    row(qPrintable(QString("bidirectional %1").arg(int(bad), 4, 16)),
        "a" + QString(bad).toUtf8() + "gnp.b", control);
  for (const char16_t bad : u"\u00ad\u200b\u2028\u2060\ufeff"sv)
    row(qPrintable(QString("invisible %1").arg(int(bad), 4, 16)), "a" + QString(bad).toUtf8(),
        control);
  row("not UTF-8", "a\xff", "is not UTF-8");
  row("a character cut off", "a\xe2\x80", "is not UTF-8");
  row("a character too long", "a\xc0\xaf", "is not UTF-8");
  row("half a pair", "a\xed\xa0\x80", "is not UTF-8");
  row("beyond Unicode", "a\xf4\x90\x80\x80", "is not UTF-8");
  row("dot", ".", "begins with a dot; it names the picture's file");
  row("dots", "..", "begins with a dot; it names the picture's file");
  row("space in front", " a", ends);
  row("space behind", "a ", ends);
  row("only a space", " ", ends);
  row("dot behind", "a.", ends);
  row("a mask's", "left.mask", "ends with .mask, which names the masks");
  row("a mask's in capitals", "left.MASK", "ends with .mask, which names the masks");
  for (const char* bad : {"CON", "nul", "Aux.left", "prn .a", "com1", "LPT9", "COM¹", "conout$"})
    row(bad, bad, device);
}

void TestSession::badNames() {
  QFETCH(const QByteArray, name);
  QFETCH(const QString, why);
  const CameraState bad = state(name.toStdString());
  const QString error = errorOf([&] { check(bad, "cameras[7]"); });
  QVERIFY2(error.startsWith("cameras[7].name: ") && error.endsWith(why), qPrintable(error));
}

void TestSession::goodNames() {
  for (const std::string& name :
       {std::string("Fig 1"), std::string(200, 'a'), std::string("a.b"), std::string("mask"),
        std::string("Köln 60°"), std::string("a.mask.b"), std::string("console"),
        std::string("com"), std::string("com10"), std::string("nul-1"), std::string("مرحبا"),
        std::string("क्\u200dष"), std::string("🙂")})
    QCOMPARE(errorOf([&] { check(state(name), "cameras[0]"); }), QString());
}

void TestSession::namesDifferInMoreThanCase_data() {
  QTest::addColumn<QString>("one");
  QTest::addColumn<QString>("other");
  QTest::addColumn<bool>("isSame");
  QTest::newRow("ASCII") << "Left"
                         << "lEFT" << true;
  QTest::newRow("umlauts") << "KÖLN"
                           << "köln" << true;
  QTest::newRow("Greek, final sigma") << "ΛΟΓΟΣ"
                                      << "λογος" << true;
  QTest::newRow("Cyrillic") << "МИР"
                            << "мир" << true;
  QTest::newRow("another letter") << "köln"
                                  << "koln" << false;
  QTest::newRow("another number") << "Fig 1"
                                  << "fig 2" << false;
}

void TestSession::namesDifferInMoreThanCase() {
  QFETCH(const QString, one);
  QFETCH(const QString, other);
  QFETCH(const bool, isSame);
  Session session = goodSession();
  session.cameras = {state(one.toStdString()), state("middle"), state(other.toStdString())};
  const QString line = "cameras[2].name: \"" + other + "\" is also cameras[0], \"" + one +
                       "\"; every state has a name of its own, whatever its case";
  QCOMPARE(errorOf([&] { check(session); }), isSame ? line : QString());
}

void TestSession::aTwinMayNeedLinearLight() {
  Session named = goodSession();
  named.twinFile = "unit.json";
  TwinParams turned;
  turned.lensArray.rotation = 1;
  const Session session = withTwin(named, turned);
  QCOMPARE(session.twin, turned);
  QVERIFY(session.twinFile.empty());
  QCOMPARE(session.cameras, named.cameras);
  TwinParams uneven;
  uneven.random.gain.sigma = 0.1;
  named.twin = uneven;
  QVERIFY(errorOf([&] { check(named); }).contains("\"linear\""));
  QCOMPARE(errorOf([&] { check(withTwin(named, uneven)); }), QString());
}

void TestSession::warnsOfCutWindows() {
  Session session = goodSession();
  QVERIFY(warnings(session).empty());
  session.cameras[0].psf = {0.89, 5};  // keeps 99.006 %
  QVERIFY(warnings(session).empty());
  session.cameras[0].psf = {0.9, 5};  // keeps 98.907 %
  QCOMPARE(warnings(session).size(), std::size_t(1));
  session.cameras[0].psf = {};
  session.cameras[1].psf = {2, 7};
  const std::vector<std::string> lines = warnings(session);
  QCOMPARE(lines.size(), std::size_t(1));
  QVERIFY(QString::fromStdString(lines[0]).contains("right"));
  QVERIFY(QString::fromStdString(lines[0]).endsWith(
      "psf: a window of 7 keeps 84.6 % of the Gaussian of sigma 2; widen it"));
  session.cameras[0].psf = {2, 7};
  QCOMPARE(warnings(session),
           std::vector<std::string>{session.cameras[0].camera.name +
                                    " and 1 more: " + lines[0].substr(lines[0].find("psf"))});
}

void TestSession::resolvedTakesWhatIsLeftOut() {
  PanelParams display;
  display.size = {0.3, 0.2};
  const PanelParams taken = resolved(display, {4, 3, 5, 6});
  QVERIFY((taken.hogels == std::array{4, 3}) && (taken.directions == std::array{5, 6}));
  QVERIFY(taken.size == display.size);
  QVERIFY(resolved(taken, {4, 3, 5, 6}) == taken);
  display.directions = {5, 6};
  QVERIFY(resolved(display, {4, 3, 5, 6}) == taken);
}

void TestSession::resolvedRefusesWhatDiffers() {
  const PanelParams display = displayOf(goodSession());
  QCOMPARE(errorOf([&] {
             resolved(display, {4, 2, 5, 6});
           }),
           QString("display.hogels: is 4×3, but the light field's file has 4×2"));
  QCOMPARE(errorOf([&] {
             resolved(display, {4, 3, 9, 6});
           }),
           QString("display.directions: is 5×6, but the light field's file has 9×6"));
}

QTEST_APPLESS_MAIN(TestSession)
#include "test_session.moc"
