// SPDX-License-Identifier: BSD-3-Clause
// Tests the table of options against all jobs: each option is used or refused, and each job's help
// has those that it uses.
#include <QMap>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "cli/flags.h"
#include "cli/help.h"
#include "cli/jobs.h"
#include "cli/program.h"
#include "core/base/error.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

using namespace hogelscope;

Q_DECLARE_METATYPE(const Flag*)
Q_DECLARE_METATYPE(const Job*)

namespace {

QString text(std::string_view view) {
  return QString::fromUtf8(view.data(), qsizetype(view.size()));
}

QString dashed(std::string_view name) {
  return "--" + text(name);
}

CommandLine parse(const QStringList& arguments) {
  std::vector<std::string> list;
  for (const QString& argument : arguments) list.push_back(argument.toStdString());
  return parseCommandLine(list);
}

QString refusalOf(const QStringList& arguments) {
  return errorOf([&] { (void)parse(arguments); });
}

/// With a value that the option takes.
QStringList given(const Flag& flag) {
  static const QMap<QString, QString> values{
      {"set", "psf.sigma=1"}, {"format", "exr"},      {"fail-below", "30"}, {"count", "3"},
      {"region", "box"},      {"seed", "3"},          {"memory", "100"},    {"threads", "2"},
      {"budget", "9"},        {"session", "s.json"},  {"test", "t.png"},    {"output", "out/o"},
      {"against", "ideal"},   {"shard", "1/2"},       {"frames", "0:1"},    {"between", "3"},
      {"fps", "25"},          {"stereo", "anaglyph"}, {"focus-stack", "3"}, {"quality", "exact"},
      {"experiment", "dsis"}};
  if (flag.value.empty()) return {dashed(flag.name)};
  return {dashed(flag.name), values.value(text(flag.name), "value")};
}

/// The job with what it needs.
QStringList smallest(const Job& job) {
  static const QMap<QString, QString> values{
      {"make-cameras", "random"}, {"generate", "edge"},    {"pack", "q_qs5x3a1.png"},
      {"export", "hogels"},       {"optimise", "hogels"},  {"info", "s.json"},
      {"status", "out"},          {"sweep", "table.json"}, {"votes", "v.json"}};
  QStringList arguments{dashed(job.name)};
  if (!job.value.empty()) arguments << values.value(text(job.name));
  for (const Flag& flag : allFlags())
    if (needs(&job, flag)) arguments += given(flag);
  return arguments;
}

/// Command lines, of which an example may have several, and go on after a backslash.
QStringList examplesOf(const Job& job) {
  QStringList lines = text(job.examples).replace("\\\n", "").split('\n', Qt::SkipEmptyParts);
  return lines.replaceInStrings("'", "\"");
}

}  // namespace

class TestOptionTable : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void jobsNameOptionsThatThereAre_data();
  void jobsNameOptionsThatThereAre();
  void everyOptionIsUsedOrRefused_data();
  void everyOptionIsUsedOrRefused();
  void jobsReadTheirOwnOptions_data();
  void jobsReadTheirOwnOptions();
  void whatIsUsedIsHeard_data();
  void whatIsUsedIsHeard();
  void nothingIsMissing_data();
  void nothingIsMissing();
  void helpOnAJob_data();
  void helpOnAJob();
  void helpSaysWhoseOptionsAre();
  void manPageHasAll();
  void bashCompletes_data();
  void bashCompletes();
};

void TestOptionTable::jobsNameOptionsThatThereAre_data() {
  helpOnAJob_data();
}

/// A misspelt name would take the option from the job.
void TestOptionTable::jobsNameOptionsThatThereAre() {
  QFETCH(const Job*, job);
  std::vector<std::string_view> named = job->needs;
  named.insert(named.end(), job->takes.begin(), job->takes.end());
  for (const std::string_view name : named)
    QVERIFY2(std::ranges::any_of(allFlags(), [&](const Flag& flag) { return flag.name == name; }),
             name.data());
}

void TestOptionTable::everyOptionIsUsedOrRefused_data() {
  QTest::addColumn<const Job*>("job");  ///< null: the window
  QTest::addColumn<const Flag*>("flag");
  for (const Flag& flag : allFlags()) {
    QTest::addRow("window, %s", flag.name.data()) << static_cast<const Job*>(nullptr) << &flag;
    for (const Job& job : jobs())
      if (job.name != "help")
        QTest::addRow("%s, %s", job.name.data(), flag.name.data()) << &job << &flag;
  }
}

/// The whole table by all jobs.
void TestOptionTable::everyOptionIsUsedOrRefused() {
  QFETCH(const Job*, job);
  QFETCH(const Flag*, flag);
  QStringList arguments = job == nullptr ? QStringList{"s.json"} : smallest(*job);
  if (!needs(job, *flag)) arguments += given(*flag);
  const QString refusal = refusalOf(arguments);
  const QString owners = QString::fromStdString(optionsOf(jobsOf(*flag)));
  if (accepts(job, *flag))
    QCOMPARE(refusal, QString());
  else if (job == nullptr)
    QCOMPARE(refusal,
             dashed(flag->name) + ": belongs to " + owners + "; without a job the window opens");
  else
    QCOMPARE(refusal, dashed(flag->name) + ": is not an option of " + dashed(job->name) +
                          "; it belongs to " + owners);
}

void TestOptionTable::jobsReadTheirOwnOptions_data() {
  everyOptionIsUsedOrRefused_data();
}

/// Reading another one is a mistake in the program, also where the option is not given.
void TestOptionTable::jobsReadTheirOwnOptions() {
  QFETCH(const Job*, job);
  QFETCH(const Flag*, flag);
  const CommandLine line = parse(job == nullptr ? QStringList{"s.json"} : smallest(*job));
  QCOMPARE(line.mayHave(flag->name), accepts(line.job, *flag));
  if (line.mayHave(flag->name)) {
    QCOMPARE(line.has(flag->name), needs(line.job, *flag));
  } else {
    QVERIFY_EXCEPTION_THROWN((void)line.has(flag->name), std::logic_error);
    QVERIFY_EXCEPTION_THROWN((void)line.text(flag->name), std::logic_error);
    QVERIFY_EXCEPTION_THROWN((void)line.texts(flag->name), std::logic_error);
    QVERIFY_EXCEPTION_THROWN((void)line.number(flag->name), std::logic_error);
  }
}

void TestOptionTable::whatIsUsedIsHeard_data() {
  QTest::addColumn<const Job*>("job");
  QTest::addColumn<const Flag*>("flag");
  for (const Flag& flag : allFlags())
    for (const Job& job : jobs())
      if (!flag.value.empty() && accepts(&job, flag))
        QTest::addRow("%s, %s", job.name.data(), flag.name.data()) << &job << &flag;
}

/// A value that cannot be right ends every job that has the option.
void TestOptionTable::whatIsUsedIsHeard() {
  QFETCH(const Job*, job);
  QFETCH(const Flag*, flag);
  const QTemporaryDir folder;
  QVERIFY(QDir::setCurrent(folder.path()));
  writeFile("s.json", ::text());
  writeFile("table.json", R"({"parameters": {"psf.sigma": [1]}, "figures": ["megapixels"]})");
  writeFile("v.json", R"({"hogelscope votes": 1, "viewer": "a",
      "trials": [{"state": "s", "vote": 3, "shown": ["a", "b"]}]})");
  for (const char* file : {"scene.png", "t.png", "q_qs5x3a1.png"}) writeGrey(file, 20, 18);
  const QString bad = flag->name == "set"      ? "display.wrong=1"
                      : flag->name == "output" ? "s.json/wrong/wrong"
                                               : "wrong";
  QStringList arguments = smallest(*job);
  if (needs(job, *flag))
    arguments[arguments.indexOf(dashed(flag->name)) + 1] = bad;
  else
    arguments << dashed(flag->name) << bad;
  const QString error = errorOf([&] { (void)runBatch(parse(arguments)); });
  QVERIFY2(error.contains("wrong") || error.contains(dashed(flag->name) + ": "), qPrintable(error));
  QVERIFY2(!error.startsWith("not an InputError"), qPrintable(error));
}

void TestOptionTable::nothingIsMissing_data() {
  QTest::addColumn<const Job*>("job");
  QTest::addColumn<const Flag*>("flag");
  for (const Flag& flag : allFlags())
    for (const Job& job : jobs())
      if (needs(&job, flag))
        QTest::addRow("%s, %s", job.name.data(), flag.name.data()) << &job << &flag;
}

void TestOptionTable::nothingIsMissing() {
  QFETCH(const Job*, job);
  QFETCH(const Flag*, flag);
  QStringList arguments = smallest(*job);
  arguments.remove(arguments.indexOf(dashed(flag->name)), 2);
  QCOMPARE(refusalOf(arguments), dashed(flag->name) + ": is missing; " + dashed(job->name) +
                                     " needs " + dashed(flag->name) + " " + text(flag->value) +
                                     ", see --help " + text(job->name));
}

void TestOptionTable::helpOnAJob_data() {
  QTest::addColumn<const Job*>("job");
  for (const Job& job : jobs()) QTest::newRow(job.name.data()) << &job;
}

/// It has the options of the job and no others, and its examples are command lines of the job.
void TestOptionTable::helpOnAJob() {
  QFETCH(const Job*, job);
  const std::string name(job->name);
  const QString help = QString::fromStdString(helpText(name));
  QVERIFY(help.startsWith("hogelscope " + dashed(name)));
  for (const QString& line : help.split('\n')) QVERIFY2(line.size() <= 100, qPrintable(line));
  for (const Flag& flag : allFlags())
    QCOMPARE(help.contains("\n  " + dashed(flag.name) + " "), accepts(job, flag));
  for (const QString& line : examplesOf(*job)) {
    QStringList words = QProcess::splitCommand(line);
    QCOMPARE(words.takeFirst(), QString("hogelscope"));
    words.removeAll("…");
    QVERIFY2(parse(words).job == job, qPrintable(line));
  }
  QCOMPARE(parse({"--help", text(name)}).subject, name);
  if (name != "help") QCOMPARE(parse(smallest(*job) << "-h").subject, name);
}

void TestOptionTable::helpSaysWhoseOptionsAre() {
  const QString help = QString::fromStdString(helpText("")).simplified();
  QVERIFY(help.contains(
      "--fail-below DB --report: exit status 1 if any PSNR over the pixels seen is below."));
  QVERIFY(help.contains("--format png|exr|tif --render: of the pictures: EXR holds"));
  QVERIFY(help.contains("Every pair of groups is compared"));
  QVERIFY(help.contains("--quiet Prints nothing but errors. Not for --info, --plugins, --status."));
}

void TestOptionTable::manPageHasAll() {
  const QString page = QString::fromStdString(helpText("man")).replace("\\-", "-");
  QVERIFY(page.startsWith(".\\\""));
  for (const Job& job : jobs())
    QVERIFY2(page.contains(".TP\n\\fB" + dashed(job.name) + "\\fR"), job.name.data());
  for (const Flag& flag : allFlags())
    QVERIFY2(page.contains(".TP\n\\fB" + dashed(flag.name) + "\\fR"), flag.name.data());
}

void TestOptionTable::bashCompletes_data() {
  QTest::addColumn<QStringList>("words");  ///< of which the last is completed
  QTest::addColumn<QStringList>("proposed");
  const auto row = [](const char* name, const QStringList& words, const QStringList& proposed) {
    QTest::newRow(name) << words << proposed;
  };
  row("a job", {"--re"}, {"--render", "--report"});
  row("an option of the job", {"--render", "--th"}, {"--threads"});
  row("none of another job", {"--render", "--fail"}, {});
  row("none twice", {"--render", "--masks", "--mas"}, {});
  row("one that may repeat", {"--report", "--test", "a.png", "--tes"}, {"--test"});
  row("choices", {"--render", "--format", ""}, {"png", "exr", "tif"});
  row("after =", {"--render", "--format", "=", "e"}, {"exr"});
  row("both choices", {"--report", "--against", ""}, {"ideal", "design"});
  row("the only choice", {"--report", "--against", "d"}, {"design"});
  row("layouts", {"--export", "h"}, {"hogels"});
  row("topics", {"--help", "comp"}, {"completion"});
  row("a number", {"--render", "--threads", ""}, {});
  row("files", {"--session", "a"}, {"a folder", "a.hogelscope"});
  row("a window's file", {"a"}, {"a folder", "a.hogelscope"});
  row("folders", {"--plugins-path", "a"}, {"a folder"});
}

void TestOptionTable::bashCompletes() {
  QFETCH(const QStringList, words);
  QFETCH(const QStringList, proposed);
  const QTemporaryDir folder;
  QVERIFY(QDir(folder.path()).mkdir("a folder"));
  writeFile(folder.path() + "/a.hogelscope", "{}");
  writeFile(folder.path() + "/script", helpText("completion").c_str());
  QProcess bash;
  bash.setWorkingDirectory(folder.path());
  bash.start("bash", QStringList{"--norc", "-c",
                                 ". ./script; COMP_WORDS=(hogelscope \"$@\"); COMP_CWORD=$#; "
                                 "_hogelscope; printf '%s\\n' \"${COMPREPLY[@]}\"",
                                 "bash"} +
                         words);
  QVERIFY(bash.waitForFinished(-1));
  QCOMPARE(bash.readAllStandardError(), QByteArray());
  QStringList lines =
      QString::fromUtf8(bash.readAllStandardOutput()).split('\n', Qt::SkipEmptyParts);
  QStringList expected = proposed;
  lines.sort();
  expected.sort();
  QCOMPARE(lines, expected);
}

QTEST_GUILESS_MAIN(TestOptionTable)
#include "test_option_table.moc"
