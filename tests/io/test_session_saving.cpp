// SPDX-License-Identifier: BSD-3-Clause
// Tests that saving a session replaces the old file whole, or leaves it alone.
#include <sys/resource.h>
#include <unistd.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>

#include "io/documents/session_file.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

Session someSession() {
  Session session;
  session.lightField.file = "scene.png";
  session.display.hogels = {4, 3};
  session.display.directions = {5, 6};
  session.cameras.resize(1);
  session.cameras[0].camera.name = "a";
  return session;
}

QString errorOfSaving(const QString& file, const Session& session = someSession()) {
  return errorOf([&] { saveSession(file.toStdString(), session); });
}

/// Works as an ordinary user while it lives, since root may write anywhere.
class OrdinaryUser {
 public:
  OrdinaryUser() : m_isRoot(::geteuid() == 0) {
    if (m_isRoot && ::seteuid(65534) != 0) qFatal("seteuid");
  }
  ~OrdinaryUser() {
    if (m_isRoot && ::seteuid(0) != 0) qFatal("seteuid");
  }
  OrdinaryUser(const OrdinaryUser&) = delete;
  OrdinaryUser& operator=(const OrdinaryUser&) = delete;

 private:
  bool m_isRoot;
};

/// No file grows beyond `bytes` while it lives: what a full disk is like.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &m_old);
    const rlimit limited{bytes, m_old.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limited);
  }
  ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &m_old); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit m_old{};
};

}  // namespace

class TestSessionSaving : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void replacesTheOldFile();
  void missingFolder();
  void aFolderInItsPlace();
  void readOnlyFolder();
  void fullDisk();
  void linksStay();
  void linksToNothing();
  void addingAStateKeepsTheRest();
  void addingToWhatIsNoSession();
  void statesAlone();
  void noContentYet();
  void notText();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestSessionSaving::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

void TestSessionSaving::replacesTheOldFile() {
  writeFile("s.json", QByteArray(100000, 'x'));
  QCOMPARE(errorOfSaving("s.json"), "");
  QVERIFY(loadSession("s.json") == someSession());
  QCOMPARE(namesIn("."), QStringList{"s.json"});
}

void TestSessionSaving::missingFolder() {
  QCOMPARE(errorOfSaving("none/s.json"),
           "none/s.json: cannot be written: No such file or directory");
  QCOMPARE(namesIn("."), QStringList());
}

void TestSessionSaving::aFolderInItsPlace() {
  QVERIFY(QDir().mkdir("s.json"));
  writeFile("s.json/inside", "kept");
  QCOMPARE(errorOfSaving("s.json"), "s.json: cannot be written: it is there, and is not a file");
  QCOMPARE(namesIn("."), QStringList{"s.json"});
  QCOMPARE(contentOf("s.json/inside"), "kept");
}

void TestSessionSaving::readOnlyFolder() {
  QVERIFY(QDir().mkdir("locked"));
  writeFile("locked/s.json", "old");
  constexpr auto all = QFile::ReadUser | QFile::ReadGroup | QFile::ReadOther | QFile::ExeUser |
                       QFile::ExeGroup | QFile::ExeOther;
  QVERIFY(QFile::setPermissions(".", all | QFile::WriteUser));
  QVERIFY(QFile::setPermissions("locked", all));
  {
    const OrdinaryUser user;
    QCOMPARE(errorOfSaving("locked/s.json"), "locked/s.json: cannot be written: Permission denied");
  }
  QCOMPARE(namesIn("locked"), QStringList{"s.json"});
  QCOMPARE(contentOf("locked/s.json"), "old");
  QVERIFY(QFile::setPermissions("locked", all | QFile::WriteUser));
}

void TestSessionSaving::fullDisk() {
  writeFile("s.json", "old");
  QString error;
  {
    const FullDisk disk(100);
    error = errorOfSaving("s.json");
  }
  QCOMPARE(error, "s.json: cannot be written: File too large");
  QCOMPARE(contentOf("s.json"), "old");
  QCOMPARE(namesIn("."), QStringList{"s.json"});
}

void TestSessionSaving::linksStay() {
  QVERIFY(QDir().mkdir("real"));
  writeFile("real/s.json", "old");
  QVERIFY(QFile::link("real/s.json", "link.json"));
  QCOMPARE(errorOfSaving("link.json"), "");
  QCOMPARE(QFileInfo("link.json").symLinkTarget(), QFileInfo("real/s.json").absoluteFilePath());
  QVERIFY(contentOf("real/s.json").startsWith("{\n"));
  QCOMPARE(namesIn("."), (QStringList{"link.json", "real"}));
  QCOMPARE(namesIn("real"), QStringList{"s.json"});
  QVERIFY(loadSession("link.json") == someSession());
}

void TestSessionSaving::linksToNothing() {
  QVERIFY(QFile::link("later.json", "link.json"));
  QCOMPARE(errorOfSaving("link.json"), "");
  QCOMPARE(namesIn("."), (QStringList{"later.json", "link.json"}));
  QVERIFY(QFileInfo("link.json").isSymLink());
  QVERIFY(loadSession("later.json") == someSession());
}

/// A new session of the desktop app.
void TestSessionSaving::noContentYet() {
  Session session = someSession();
  session.lightField.file.clear();
  QCOMPARE(errorOfSaving("s.json", session), "");
  QVERIFY2(contentOf("s.json").contains(R"("file": "")"), contentOf("s.json"));
}

/// JSON has no place for other bytes than UTF-8.
void TestSessionSaving::notText() {
  writeFile("s.json", "old");
  Session session = someSession();
  session.lightField.file = "sc\xffne.png";
  const QString error = errorOfSaving("s.json", session);
  QVERIFY2(error.startsWith("s.json: "), qPrintable(error));
  QCOMPARE(contentOf("s.json"), "old");
  QCOMPARE(namesIn("."), QStringList{"s.json"});
}

/// Also what this program would write otherwise: keys left out, their order, numbers as integers.
void TestSessionSaving::addingAStateKeepsTheRest() {
  const QByteArray document = text({.display = R"({"directions": [5, 6], "hogels": [4, 3]})"});
  writeFile("s.json", document);
  CameraState state = someSession().cameras[0];
  state.psf = {1.25, 7};
  appendStates("s.json", {state, state});
  const Session session = loadSession("s.json");
  QCOMPARE(session.cameras.size(), std::size_t(4));
  QCOMPARE(session.cameras[2].camera.name, std::string("a 2"));
  QCOMPARE(session.cameras[3].camera.name, std::string("a 3"));
  QVERIFY(session.cameras[3].psf == state.psf);
  QJsonObject before = QJsonDocument::fromJson(document).object();
  QJsonObject after = QJsonDocument::fromJson(contentOf("s.json")).object();
  for (int k = 0; k < 2; ++k)
    QCOMPARE(after["cameras"].toArray()[k], before["cameras"].toArray()[k]);
  before.remove("cameras");
  after.remove("cameras");
  QCOMPARE(after, before);
  QVERIFY(contentOf("s.json").indexOf("directions") < contentOf("s.json").indexOf("\"hogels\""));
  QCOMPARE(namesIn("."), QStringList{"s.json"});
}

void TestSessionSaving::addingToWhatIsNoSession() {
  const auto error = [] { return errorOf([] { appendStates("s.json", someSession().cameras); }); };
  QVERIFY(error().startsWith("s.json: cannot be read"));
  writeFile("s.json", "{");
  QVERIFY(error().startsWith("s.json: is not JSON"));
  QCOMPARE(contentOf("s.json"), QByteArray("{"));
}

void TestSessionSaving::statesAlone() {
  writeFile("s.json", R"({"hogelscope": 1, "cameras": [{"name": "x", "fov": 30}]})");
  const std::vector<CameraState> states = loadStates("s.json");
  QCOMPARE(states.size(), std::size_t(1));
  QCOMPARE(states[0].camera.fov, 30.0);
  writeFile("s.json", text());
  QCOMPARE(loadStates("s.json").size(), std::size_t(2));
  const auto refused = [](const QByteArray& document) {
    writeFile("s.json", document);
    return errorOf([] { (void)loadStates("s.json"); });
  };
  QCOMPARE(refused(R"({"hogelscope": 1})"),
           QString("s.json: cameras: is missing or empty: there is no camera state to load"));
  QCOMPARE(refused(R"({"hogelscope": 1, "camera": []})"),
           QString("s.json: camera: is not known here; did you mean \"cameras\"?"));
  QVERIFY(refused(R"({"hogelscope": 1, "cameras": [{"name": "a/b"}]})")
              .startsWith("s.json: cameras[0].name: "));
}

QTEST_APPLESS_MAIN(TestSessionSaving)
#include "test_session_saving.moc"
