// SPDX-License-Identifier: BSD-3-Clause
// Tests where plugins are looked for, and what plugin.json must say before a library is loaded.
#include <QTemporaryDir>
#include <QTest>
#include <filesystem>

#include "io/plugins/plugin_list.h"
#include "tests/cli/program.h"
#include "tests/plugins/plugin_files.h"

using namespace hogelscope;

class TestPluginList : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void foldersInOrder();
  void missingFolders();
  void aPluginIsListed();
  void refusals_data();
  void refusals();
  void wrongFiles();
  void linksAndLoops();
  void theFirstOfOneName();
  void theTable();
  void theInstallation();

 private:
  [[nodiscard]] QString path(const QString& name) const { return m_folder.path() + "/" + name; }

  QTemporaryDir m_folder;
};

/// Not the user's own plugins.
void TestPluginList::initTestCase() {
  qputenv("HOME", path("home").toUtf8());
  QVERIFY(QDir().mkpath(path("p")));
  addPluginFolder(path("p").toStdString());
}

/// The tests are in a folder beside the program's own, in the build tree.
void TestPluginList::foldersInOrder() {
  const auto folders = pluginFolders();
  const std::filesystem::path build = QFileInfo(HOGELSCOPE_PROGRAM).path().toStdString() + "/..";
  QCOMPARE(folders.size(), std::size_t(4));
  QCOMPARE(folders[0], std::filesystem::canonical(path("p").toStdString()));
  QCOMPARE(folders[1].string(), path("home/.local/lib/hogelscope/plugins-3").toStdString());
  QVERIFY(folders[2].string().ends_with("/hogelscope/plugins-3"));
  QCOMPARE(folders[3], std::filesystem::canonical(build) / "plugins-3");
  const QString older = path("home/.local/lib/hogelscope/plugins-1");
  writePlugin(older + "/stripes", "library", {{"abi", "1"}, {"name", "\"stripes\""}});
  QCOMPARE(pluginFolders().back().string(), older.toStdString());
  QCOMPARE(foundIn(older + "/stripes").refusal,
           (older + "/stripes/plugin.json: abi: 1, this program needs 3: build the plugin again "
                    "with this program's SDK")
               .toStdString());
  QVERIFY(QDir(older).removeRecursively());
  qputenv("HOME", "somewhere/relative");
  QCOMPARE(pluginFolders().size(), std::size_t(3));
  qputenv("HOME", path("home").toUtf8());
}

void TestPluginList::missingFolders() {
  const auto add = [](const QString& folder) {
    return errorOf([&] { addPluginFolder(folder.toStdString()); });
  };
  writeFile(path("file"), "x");
  QCOMPARE(add("nowhere"), "nowhere: is not a folder; each plugin is a folder in it");
  QCOMPARE(add(path("file")), path("file") + ": is not a folder; each plugin is a folder in it");
  QCOMPARE(pluginFolders().size(), std::size_t(4));
}

void TestPluginList::aPluginIsListed() {
  writePlugin(path("p/good"), "library");
  writeFile(path("p/README"), "beside the plugins");
  QVERIFY(QDir().mkpath(path("p/empty")));
  const FoundPlugin found = foundIn(path("p/good"));
  QCOMPARE(found.refusal, std::string());
  QCOMPARE(found.name, std::string("wrong"));
  QCOMPARE(found.version, std::string("1.0"));
  QCOMPARE(found.kinds.size(), std::size_t(3));
  QCOMPARE(found.library.string(), path("p/good/wrong.so").toStdString());
  for (const FoundPlugin& other : listPlugins())
    QVERIFY(other.folder.filename() != "README" && other.folder.filename() != "empty");
}

void TestPluginList::refusals_data() {
  QTest::addColumn<Keys>("keys");
  QTest::addColumn<QString>("line");
  const auto add = [](const char* row, const char* key, const QByteArray& value,
                      const QString& line) {
    QTest::newRow(row) << Keys{{key, value}} << line;
  };
  const QString another = ", this program needs 3: build the plugin again with this program's SDK";
  add("other abi", "abi", "1", "abi: 1" + another);
  add("abi as text", "abi", "\"3\"", "abi: \"3\"" + another);
  add("abi as truth", "abi", "true", "abi: true" + another);
  add("half abi", "abi", "1.5", "abi: 1.5" + another);
  add("no abi", "abi", "", "abi: is missing" + another);
  const QString build = "build: is not " HOGELSCOPE_PLUGIN_BUILD
                        ": build the plugin with the compiler that built this program";
  add("other build", "build", "\"msvc\"", build);
  add("build as number", "build", "7", build);
  add("no build", "build", "", build);
  const QString name = " is not a plugin's name: small letters, digits and \"-\"";
  add("no name", "name", "", "name: \"\"" + name);
  add("name with slash", "name", "\"a/b\"", "name: \"a/b\"" + name);
  add("name of capitals", "name", "\"Mesh\"", "name: \"Mesh\"" + name);
  add("long name", "name", "\"" + QByteArray(1000, 'a') + "\"",
      "name: \"" + QString(40, 'a') + "\"" + name);
  add("name as list", "name", "[]", "name: [] is not a text");
  add("version as number", "version", "1.0", "version: 1.0 is not a text");
  add("version of two lines", "version", "\"1\\n2\"", "version: \"1\\n2\" has a control character");
  const QString kinds = "kinds: is not a list of \"content\", \"lens\", \"metric\"";
  add("no kinds", "kinds", "", kinds);
  add("empty kinds", "kinds", "[]", kinds);
  add("kind as text", "kinds", "\"metric\"", kinds);
  add("unknown kind", "kinds", "[\"metric\", \"reader\"]", kinds);
  add("no file", "file", "", "file: \"\" is not the name of a file beside it");
  add("file above", "file", "\"../wrong.so\"",
      "file: \"../wrong.so\" is not the name of a file beside it");
  add("file from the root", "file", "\"/bin/ls\"",
      "file: \"/bin/ls\" is not the name of a file beside it");
  add("file ..", "file", "\"..\"", "file: \"..\" is not the name of a file beside it");
  add("missing file", "file", "\"other.so\"", "file: other.so: No such file or directory");
  add("truncated", "bytes", "8",
      "bytes: wrong.so has 7 bytes, not 8: it is damaged or was "
      "replaced; install the plugin again");
  add("no bytes", "bytes", "",
      "bytes: wrong.so has 7 bytes, not 0: it is damaged or was "
      "replaced; install the plugin again");
  add("negative bytes", "bytes", "-7", "bytes: -7 is out of range: 1 to 2147483647");
  add("huge bytes", "bytes", "7e300", "bytes: 7e+300 is out of range: 1 to 2147483647");
  add("unknown key", "flie", "1", "flie: is not known here; did you mean \"file\"?");
}

void TestPluginList::refusals() {
  QFETCH(Keys, keys);
  QFETCH(QString, line);
  writePlugin(path("p/good"), "library", keys);
  QCOMPARE(QString::fromStdString(foundIn(path("p/good")).refusal),
           path("p/good/plugin.json: ") + line);
}

/// What is no document of a plugin at all.
void TestPluginList::wrongFiles() {
  const auto refusalOf = [this](const QByteArray& text) {
    writePlugin(path("p/good"), "library");
    writeFile(path("p/good/plugin.json"), text);
    return QString::fromStdString(foundIn(path("p/good")).refusal)
        .remove(path("p/good/plugin.json: "));
  };
  QCOMPARE(refusalOf("[]"), "is not an object: { \"name\": value, … }");
  QCOMPARE(refusalOf("7"), "is not an object: { \"name\": value, … }");
  QVERIFY(refusalOf("").startsWith("is empty"));
  QVERIFY(refusalOf("\x7f"
                    "ELF\0\1\2")
              .startsWith("is not JSON: "));
  QVERIFY(refusalOf(pluginJson(7, {{"abi", "NaN"}})).startsWith("is not JSON: "));
  QVERIFY(refusalOf(pluginJson(7, {{"abi", "1e999"}})).startsWith("is not JSON: "));
  QVERIFY(refusalOf(pluginJson(7).chopped(1)).startsWith("is not JSON: "));
  QVERIFY(refusalOf("{\"abi\": 1, \"abi\": 1}").contains("stands twice"));
  QVERIFY(refusalOf("{\"kinds\": " + QByteArray(60000, '[')).startsWith("is nested deeper"));
  QCOMPARE(refusalOf(QByteArray(65537, ' ')), "is larger than 64 KiB: not a document of a plugin");
  QVERIFY(QFile::remove(path("p/good/plugin.json")) && QDir().mkpath(path("p/good/plugin.json")));
  QCOMPARE(QString::fromStdString(foundIn(path("p/good")).refusal),
           path("p/good/plugin.json: is a folder, not a file"));
}

void TestPluginList::linksAndLoops() {
  const auto refusal = [&] {
    return QString::fromStdString(foundIn(path("p/good")).refusal)
        .remove(path("p/good/plugin.json: "));
  };
  writePlugin(path("p/good"), "library");
  writeFile(path("outside.so"), "library");
  QVERIFY(QFile::remove(path("p/good/wrong.so")));
  QVERIFY(QFile::link(path("outside.so"), path("p/good/wrong.so")));
  QCOMPARE(refusal(), "file: wrong.so leads out of the plugin's folder");
  QVERIFY(QFile::remove(path("p/good/wrong.so")));
  QVERIFY(QFile::link("wrong.so", path("p/good/wrong.so")));
  QCOMPARE(refusal(), "file: wrong.so: Too many levels of symbolic links");
  QVERIFY(QFile::remove(path("p/good/wrong.so")) && QDir().mkpath(path("p/good/wrong.so")));
  QCOMPARE(refusal(), "file: wrong.so is not a file with content");
  QVERIFY(QFile::remove(path("p/good/plugin.json")));
  QVERIFY(QFile::link("plugin.json", path("p/good/plugin.json")));
  QCOMPARE(refusal(), "cannot be read: Too many levels of symbolic links");
  QVERIFY(QDir(path("p/good")).removeRecursively());
  QVERIFY(QFile::link("good", path("p/good")));
  QCOMPARE(refusal(), "cannot be read: Too many levels of symbolic links");
  QVERIFY(QFile::remove(path("p/good")));
  // A link to a whole plugin is as good as the plugin.
  writePlugin(path("elsewhere"), "library");
  QVERIFY(QFile::link(path("elsewhere"), path("p/good")));
  QCOMPARE(refusal(), QString());
  QVERIFY(QFile::remove(path("p/good")));
}

void TestPluginList::theFirstOfOneName() {
  const QString own = path("home/.local/lib/hogelscope/plugins-3/wrong");
  writePlugin(path("p/good"), "library");
  writePlugin(path("p/other"), "library", {{"name", "\"other\""}});
  writePlugin(own, "library");
  QCOMPARE(foundIn(path("p/good")).refusal, std::string());
  QCOMPARE(foundIn(path("p/other")).refusal, std::string());
  QCOMPARE(QString::fromStdString(foundIn(own).refusal), own + ": is hidden by " + path("p/good"));
  QVERIFY(QDir(path("home")).removeRecursively());
}

/// --plugins in the real program: everything wrong is a line of the table, and the status is 0.
void TestPluginList::theTable() {
  writePlugin(path("p/good"), "library");
  writePlugin(path("p/other"), "library", {{"abi", "1"}});
  const Outcome outcome = run({"--plugins", "--plugins-path", "p"}, m_folder.path());
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.status, 0);
  const QString out = QString::fromUtf8(outcome.out).replace(QRegularExpression(" +"), " ");
  QVERIFY(out.startsWith("plugin version kinds folder, or why it is refused\n"));
  QVERIFY(out.contains("\nwrong 1.0 content, lens, metric " + path("p/good") + "\n"));
  QVERIFY(out.contains("\nother - refused " + path("p/other/plugin.json: abi: 1, this program")));
  QVERIFY(out.contains("\nexample 1.0 content "));
  QVERIFY(out.contains("\nlooked in " + path("p") + "\n"));
  QVERIFY(out.contains("/home/.local/lib/hogelscope/plugins-3 (missing)\n"));
  const Outcome missing = run({"--plugins", "--plugins-path", "q"}, m_folder.path());
  QCOMPARE(missing.err,
           QByteArray("hogelscope: q: is not a folder; each plugin is a folder in it\n"));
  QCOMPARE(missing.status, 2);
}

/// The same program in another place finds the plugins that are there, and not its build tree's.
void TestPluginList::theInstallation() {
  const auto build = pluginFolders()[3].parent_path();
  const QString folder =
      QString::fromStdString(pluginFolders()[2].lexically_relative(build).string());
  QVERIFY(folder.startsWith("lib") && QDir().mkpath(path("prefix/bin")));
  QVERIFY(QFile::copy(HOGELSCOPE_PROGRAM, path("prefix/bin/hogelscope")));
  writePlugin(path("prefix/" + folder + "/wrong"), "library");
  QProcess process;
  process.start(path("prefix/bin/hogelscope"), {"--plugins"});
  const Outcome outcome = ended(process);
  QCOMPARE(outcome.err, QByteArray());
  QVERIFY2(outcome.out.contains(path("prefix/" + folder + "/wrong\n").toUtf8()), outcome.out);
  QVERIFY2(!outcome.out.contains("example"), outcome.out);
}

QTEST_GUILESS_MAIN(TestPluginList)
#include "test_plugin_list.moc"
