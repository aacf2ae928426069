// SPDX-License-Identifier: BSD-3-Clause
// Tests the readers of OpenCV's YAML and XML: node by node against cv::FileStorage over what that
// wrote, and with what crashed or stopped cv::FileStorage.
#include <QTemporaryDir>
#include <QTest>
#include <opencv2/core.hpp>

#include "io/json/xml_reader.h"
#include "io/json/yaml_reader.h"
#include "tests/core/random.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

/// "" or where the two differ.
QString difference(const cv::FileNode& expected, const Json& read, const QString& path) {
  if (expected.isMap() || expected.isSeq()) {
    if (expected.size() != read.size() || expected.isMap() != read.is_object())
      return path + " has another shape";
    std::size_t k = 0;
    for (const cv::FileNode& item : expected) {
      const std::string name = expected.isMap() ? item.name() : std::to_string(k);
      if (expected.isMap() && !read.contains(name)) return path + " lacks " + name.c_str();
      const QString inner =
          difference(item, expected.isMap() ? read[name] : read[k], path + "/" + name.c_str());
      if (!inner.isEmpty()) return inner;
      ++k;
    }
    return {};
  }
  const bool isSame = expected.isInt()    ? read.is_number_integer() && read == int(expected)
                      : expected.isReal() ? read.is_number_float() && read == double(expected)
                                          : read.is_string() && read == std::string(expected);
  return isSame ? QString() : path + " is " + read.dump(-1, ' ', true).c_str();
}

/// Not a whole number above INT_MAX that is written without an exponent: OpenCV 4.10 reads others.
double randomReal(Random& random) {
  for (;;) {
    const double value = random.uniform(-1, 1) * std::pow(10, random.integer(-300, 300));
    if (std::abs(value) < 1e9 || std::abs(value) > 1e17) return value;
  }
}

std::string randomText(Random& random) {
  static const std::vector<std::string> parts{"a",  "Z",  "1",  ".",  " ", "-",  ":",  "#",  "'",
                                              "\"", "\\", "\t", "\n", "[", "{",  ",",  "*",  "&",
                                              "!",  "%",  "~",  "ü",  "?", "- ", ": ", " #", "://"};
  std::string text;
  for (int k = random.integer(0, 12); k > 0; --k)
    text += parts[std::size_t(random.integer(0, int(parts.size()) - 1))];
  // The writer takes these for the begin or end of a list, and does not quote a quote alone.
  const bool isRead = text.size() != 1 && text.find_first_of("[]{}\\") != 0;
  return isRead ? text : "x" + text;
}

cv::Mat randomMatrix(Random& random) {
  cv::Mat_<double> values(random.integer(1, 4), random.integer(1, 20));
  for (double& value : values) value = randomReal(random);
  cv::Mat matrix;
  values.convertTo(matrix, random.flip() ? CV_64F : CV_8U);
  return matrix;
}

/// What the names of keys begin with; XML has none with spaces.
const char* keyBegin = "key ";

void writeValue(cv::FileStorage& storage, Random& random, int depth);

void writeKeys(cv::FileStorage& storage, Random& random, int depth) {
  for (int k = random.integer(1, 4); k > 0; --k) {
    storage << keyBegin + std::to_string(k);
    writeValue(storage, random, depth);
  }
}

/// One of all that OpenCV writes, except a matrix in braces, which is not YAML at all.
void writeValue(cv::FileStorage& storage, Random& random, int depth) {
  switch (random.integer(0, depth < 4 ? 7 : 3)) {
    case 0:
      storage << random.integer(-2147483647, 2147483647);
      break;
    case 1:
      storage << randomReal(random);
      break;
    case 2:
      storage << randomText(random);
      break;
    case 3:
      storage << std::vector<double>{randomReal(random), 0, 1};
      break;
    case 4:
      storage << randomMatrix(random);
      break;
    case 5:
      storage << "{:"
              << "x" << randomReal(random) << "n" << 3 << "at"
              << "[:" << 1 << 0.5 << "]"
              << "}";
      break;
    case 6:
      storage << "[";
      for (int k = random.integer(1, 3); k > 0; --k) writeValue(storage, random, depth + 1);
      storage << "]";
      break;
    default:
      storage << "{";
      writeKeys(storage, random, depth + 1);
      storage << "}";
  }
}

}  // namespace

class TestYamlReader : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void readsWhatOpenCvReads();
  void readsItsXml();
  void xml_data();
  void xml();
  void dialect_data();
  void dialect();
  void isRefused_data();
  void isRefused();
};

void TestYamlReader::readsWhatOpenCvReads() {
  const QTemporaryDir folder;
  const std::string file = folder.filePath("random.yml").toStdString();
  Random random(14);
  for (int k = 0; k < 300; ++k) {
    cv::FileStorage out(file, cv::FileStorage::WRITE);
    writeKeys(out, random, 0);
    out.writeComment("a comment: \"with a quote", false);
    writeValue(out << "last", random, 0);
    out.release();
    if (random.flip()) {
      cv::FileStorage more(file, cv::FileStorage::APPEND);
      more << "appended" << 0.1;
    }
    const QByteArray content = contentOf(file.c_str());
    const cv::FileStorage in(file, cv::FileStorage::READ);
    Json read;
    const QString error = errorOf([&] { read = parseOpenCvYaml(content.toStdString()); });
    QVERIFY2(error.isEmpty(), error.toUtf8() + "\n" + content);
    if (const cv::FileNode appended = in["appended"]; !appended.empty()) {
      QCOMPARE(read["appended"].get<double>(), double(appended));
      read.erase("appended");
    }
    const QString different = difference(in.root(), read, "");
    QVERIFY2(different.isEmpty(), different.toUtf8() + "\n" + content);
  }
}

/// The same of XML. Numbers without a point are whole there, whatever they were.
void TestYamlReader::readsItsXml() {
  const QTemporaryDir folder;
  const std::string file = folder.filePath("random.xml").toStdString();
  Random random(15);
  keyBegin = "key-";
  for (int k = 0; k < 300; ++k) {
    cv::FileStorage out(file, cv::FileStorage::WRITE);
    writeKeys(out, random, 0);
    out.writeComment("a comment: <with> \"a quote", false);
    out.release();
    const QByteArray content = contentOf(file.c_str());
    const cv::FileStorage in(file, cv::FileStorage::READ);
    Json read;
    const QString error = errorOf([&] { read = parseOpenCvXml(content.toStdString()); });
    QVERIFY2(error.isEmpty(), error.toUtf8() + "\n" + content);
    const QString different = difference(in.root(), read, "");
    QVERIFY2(different.isEmpty(), different.toUtf8() + "\n" + content);
  }
  keyBegin = "key ";
}

void TestYamlReader::xml_data() {
  QTest::addColumn<QByteArray>("xml");
  QTest::addColumn<QByteArray>("json");
  const auto add = [](const char* name, const QByteArray& xml, const QByteArray& json) {
    QTest::newRow(name) << xml << json;
  };
  add("words", "<r><a>1 -2.5 b \"c d\"</a></r>", R"({"a":[1,-2.5,"b","c d"]})");
  add("items", "<r><a><_>1</_><_><b>2</b></_></a></r>", R"({"a":[1,{"b":2}]})");
  add("nothing", "<r><a/><b></b><c x='>'/></r>", R"({"a":"","b":"","c":""})");
  add("one number", "<r><m type_id=\"opencv-matrix\"><data>3.</data></m></r>",
      R"({"m":{"data":3.0}})");
  add("characters", "<r><a>\"&lt;&amp;&gt;&quot;\"</a></r>", R"({"a":"<&>\""})");
  add("comments", "<!-- < --><?xml version=\"1.0\"?><r><!--a--><a>1<!-- 2 --></a></r><!-- -->",
      R"({"a":1})");
  add("twice", "<r><a>1</a><a>2</a></r>", "line 1: \"a\" stands twice");
  add("mixed", "<r><a>1</a>\n<_>2</_></r>", "line 2: has items (_) beside names");
  add("an entity", "<r><a>&bomb;</a></r>", "line 1: has an entity that is not known: &bomb;");
  add("no end", "<r><a>1</a>", "line 1: is not XML: an element has no end");
  add("no comment's end", "<r><!-- ", "line 1: is not XML: \"-->\" is missing");
  add("more", "<r></r>x", "line 1: is not XML: something follows the last element");
}

void TestYamlReader::xml() {
  QFETCH(QByteArray, xml);
  QFETCH(QByteArray, json);
  QByteArray read;
  const QString error =
      errorOf([&] { read = QByteArray::fromStdString(parseOpenCvXml(xml.toStdString()).dump()); });
  QCOMPARE(error.isEmpty() ? read : error.toUtf8(), json);
}

void TestYamlReader::dialect_data() {
  QTest::addColumn<QByteArray>("yaml");
  QTest::addColumn<QByteArray>("json");
  const auto add = [](const char* name, const QByteArray& yaml, const QByteArray& json) {
    QTest::newRow(name) << "%YAML:1.0\n" + yaml << json;
  };
  add("nothing", "", "{}");
  add("an empty document", "---\n", "{}");
  add("numbers", "a: [ 1., .5, -1.e-3, 2, 1e5, 0x10, 1_0, +1 ]",
      R"({"a":[1.0,0.5,-0.001,2,100000.0,"0x10","1_0","+1"]})");
  add("not numbers", "a: [ .Inf, -.Inf, .Nan, 1e999, ~, true ]",
      R"({"a":[".Inf","-.Inf",".Nan","1e999","~","true"]})");
  add("quoted numbers", "a: \"1\"\nb: '2'", R"({"a":"1","b":"2"})");
  add("large whole numbers", "a: 4294967296", R"({"a":4294967296.0})");
  add("tags", "a: !!opencv-matrix\n   rows: 3\nb: !!str 3", R"({"a":{"rows":3},"b":3})");
  add("no blank", "image_width:852\na: { x:1, y:[ 2 ], z:\"b:c\" }",
      R"({"image_width":852,"a":{"x":1,"y":[2],"z":"b:c"}})");
  add("a time", "a: 10:20:30", R"({"a":"10:20:30"})");
  add("two documents", "---\na: 1\n...\n---\nb: 2\n", R"({"a":1,"b":2})");
  add("of Windows", "---\r\na: 1\r\nb: [ 1,\r\n 2 ]\r\n", R"({"a":1,"b":[1,2]})");
}

void TestYamlReader::dialect() {
  QFETCH(const QByteArray, yaml);
  QFETCH(const QByteArray, json);
  QCOMPARE(QByteArray::fromStdString(parseOpenCvYaml(yaml.toStdString()).dump()), json);
}

void TestYamlReader::isRefused_data() {
  QTest::addColumn<QByteArray>("yaml");
  QTest::addColumn<QString>("line");
  const auto add = [](const char* name, const QByteArray& yaml, const char* line) {
    QTest::newRow(name) << "%YAML:1.0\n" + yaml << QString(line);
  };
  const auto many = [](const QByteArray& text) { return text.repeated(300000 / text.size()); };
  constexpr const char* deep = "line 2: is nested deeper than any calibration";
  add("brackets", "x: " + many("["), deep);
  add("braces", "x: " + many("{x: "), deep);
  add("brackets in braces", "x: " + many("{a: ["), deep);
  add("behind a quote in a word", "x: [a'b, " + many("["), deep);
  add("behind a hash in a word", "x: [a#b, " + many("["), deep);
  add("behind a text", "x: [ \"]]]]\", " + many("["), deep);
  add("dashes", "x:\n  " + many("- "), "line 3: is nested deeper than any calibration");
  add("question marks", many("? "), "line 2: a name is not a text");
  add("brackets on lines", "x: " + many("[\n"), "line 34: is nested deeper than any calibration");
  add("keys on a line", many("a: "),
      "line 2: is not YAML: mapping values are not allowed in this context");
  add("an alias", "a: &a [1, 2]\nb: [*a, *a]",
      "line 3: repeats another part of the file (*); write it out");
  add("an alias as a name", "? *a\n: 1", "line 2: a name is not a text");
  add("a list as a name", "? [1]\n: 1", "line 2: a name is not a text");
  add("a name twice", "a: 1\nb: 2\na: 3", "line 4: \"a\" stands twice");
  add("a name twice, in two documents", "a: 1\n---\na: 3", "line 4: \"a\" stands twice");
  add("a list alone", "- 1", "line 2: is not of the form NAME: VALUE");
  add("a text alone", "1", "line 2: is not of the form NAME: VALUE");
  add("no text", "a: 1\nb: \xFF", "line 3: is not YAML: invalid leading UTF-8 octet");
  add("another NUL", QByteArray("a: 1\nb: \0\n", 10),
      "line 3: is not YAML: control characters are not allowed");
  add("an open bracket", "a: [1,\n", "line 3: is not YAML: did not find expected node content");
  QByteArray names;
  for (int k = 0; k < 30000; ++k) names += "n" + QByteArray::number(k) + ":\n";
  add("many names", names, "line 1002: has more names than any calibration");
}

void TestYamlReader::isRefused() {
  QFETCH(const QByteArray, yaml);
  QFETCH(const QString, line);
  QCOMPARE(errorOf([&] { (void)parseOpenCvYaml(yaml.toStdString()); }), line);
}

QTEST_APPLESS_MAIN(TestYamlReader)
#include "test_yaml_reader.moc"
