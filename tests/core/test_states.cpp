// SPDX-License-Identifier: BSD-3-Clause
// Tests adding, copying, moving, naming and removing camera states.
#include "core/states.h"

#include <QTest>

#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

CameraState named(const char* name) {
  CameraState state;
  state.camera.name = name;
  return state;
}

Session abc() {
  Session session;
  session.cameras = {named("a"), named("b"), named("c")};
  return session;
}

QString namesOf(const Session& session) {
  QStringList names;
  for (const CameraState& state : session.cameras)
    names << QString::fromStdString(state.camera.name);
  return names.join("|");
}

}  // namespace

class TestStates : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void addingFindsAFreeName() {
    Session session = abc();
    QCOMPARE(addState(session, named("d")), std::size_t(3));
    addState(session, named("a"));
    addState(session, named("a"));
    addState(session, named("a 2"));
    QCOMPARE(namesOf(session), QString("a|b|c|d|a 2|a 3|a 2 2"));
  }

  void aCopyStandsBehindItsOriginal() {
    Session session = abc();
    session.cameras[1].psf.sigma = 3;
    QCOMPARE(duplicateState(session, 1), std::size_t(2));
    QCOMPARE(namesOf(session), QString("a|b|b 2|c"));
    QCOMPARE(session.cameras[2].psf.sigma, 3.0);
    duplicateState(session, 3);
    QCOMPARE(namesOf(session), QString("a|b|b 2|c|c 2"));
  }

  void moving_data() {
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    QTest::addColumn<QString>("names");
    QTest::newRow("down") << 0 << 2 << "b|c|a";
    QTest::newRow("one down") << 0 << 1 << "b|a|c";
    QTest::newRow("up") << 2 << 0 << "c|a|b";
    QTest::newRow("nowhere") << 1 << 1 << "a|b|c";
  }

  void moving() {
    QFETCH(const int, from);
    QFETCH(const int, to);
    Session session = abc();
    moveState(session, std::size_t(from), std::size_t(to));
    QTEST(namesOf(session), "names");
  }

  void theLastOneStays() {
    Session session = abc();
    removeState(session, 1);
    QCOMPARE(namesOf(session), QString("a|c"));
    removeState(session, 0);
    QCOMPARE(errorOf([&] { removeState(session, 0); }),
             QString("cameras: has one state only, and a session needs one"));
    QCOMPARE(namesOf(session), QString("c"));
  }

  void renaming() {
    Session session = abc();
    renameState(session, 1, "b");
    renameState(session, 1, "new");
    QCOMPARE(namesOf(session), QString("a|new|c"));
    QCOMPARE(errorOf([&] { renameState(session, 1, "c"); }),
             QString("name: \"c\" is another state's already"));
    QVERIFY(errorOf([&] { renameState(session, 1, "d/e"); }).startsWith("cameras[1].name: "));
    QVERIFY(!errorOf([&] { renameState(session, 1, ""); }).isEmpty());
    QCOMPARE(namesOf(session), QString("a|new|c"));
  }

  void mergingKeepsAll() {
    Session session = abc();
    mergeStates(session, {named("b"), named("x"), named("b")});
    QCOMPARE(namesOf(session), QString("a|b|c|b 2|x|b 3"));
  }
};

QTEST_APPLESS_MAIN(TestStates)
#include "test_states.moc"
