// SPDX-License-Identifier: BSD-3-Clause
// Tests the order of the rooms in ARCHITECTURE.md by the #include lines of src: a room includes
// only those that it may, only some know foreign libraries, and no circle is larger than two
// modules.
#include <QDirIterator>
#include <QRegularExpression>
#include <QTest>
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

/// The rooms that a room may include, beside itself; a name without a slash means all of its rooms.
const std::map<QString, QStringList>& allowedRooms() {
  static const std::map<QString, QStringList> rooms{
      {"core/base", {}},
      {"sdk/hogelscope", {"core/base"}},
      {"core/light_field", {"core/base", "sdk/hogelscope"}},
      {"core/panel", {"core/base", "core/light_field", "sdk/hogelscope"}},
      {"core/optics", {"core/base", "core/light_field", "core/panel"}},
      {"core/lens", {"core/base", "core/optics"}},
      {"core/engine", {"core/base", "core/light_field", "core/panel", "core/optics", "core/lens"}},
      {"core/cameras", {"core/base", "core/light_field", "core/panel", "core/optics"}},
      {"core/content",
       {"core/base", "sdk/hogelscope", "core/light_field", "core/panel", "core/optics"}},
      {"core/metrics",
       {"core/base", "core/light_field", "core/panel", "core/optics", "core/lens", "core/engine"}},
      {"io/files", {"core"}},
      {"io/json", {"core"}},
      {"io/images", {"core", "io/files"}},
      {"io/codecs", {"core", "io/images"}},
      {"io/twin", {"core", "io/files", "io/images"}},
      {"io/plugins", {"core", "io/files", "io/json", "sdk/hogelscope"}},
      {"io/cameras", {"core", "io/files", "io/json"}},
      {"io/documents", {"core", "io/cameras", "io/files", "io/json", "io/plugins"}},
      {"capture/names", {"core"}},
      {"capture/order", {"core"}},
      {"capture/lenslets", {"core"}},
      {"io/layouts", {"core", "capture", "io/files", "io/images"}},
      {"io/store",
       {"core", "io/files", "io/json", "io/images", "io/layouts", "io/plugins", "io/documents"}},
      {"io/scene",
       {"core", "capture", "io/documents", "io/files", "io/images", "io/layouts", "io/plugins",
        "io/store", "io/twin", "sdk/hogelscope"}},
      {"io/opening", {"core", "capture", "io"}},
      {"vtk", {"core", "io", "sdk/hogelscope"}},
      {"study", {"core"}},
      {"measure", {"core", "io", "runs", "page", "sdk/hogelscope"}},
      {"optimise", {"core", "io", "runs", "page"}},
      {"page", {"core", "io/files"}},
      {"web/engine", {"core"}},
      {"web", {"core", "io", "page"}},
      {"chart", {"core", "page", "study", "measure"}},
      {"picture", {"core"}},
      {"runs", {"core", "io"}},
      {"report/page", {"core", "page"}},
      {"report", {"core", "io", "runs", "page", "report/page"}},
      {"campaign", {"core", "io", "page", "report"}},
      {"cli", {"core", "io", "runs", "report"}},
      {"cli/jobs",
       {"core", "io", "runs", "study", "measure", "optimise", "page", "chart", "report", "campaign",
        "web", "cli"}},
      {"python",
       {"core", "io", "runs", "measure", "optimise", "report", "campaign", "web",
        "sdk/hogelscope"}},
      {"gui/widgets", {"core", "report"}},
      {"gui/keys", {"core", "io", "gui/widgets"}},
      {"gui/session", {"core", "io", "gui/keys", "gui/widgets"}},
      {"gui/view",
       {"core", "io", "vtk", "study", "chart", "picture", "gui/session", "gui/widgets"}},
      {"gui/files",
       {"core", "io", "optimise", "picture", "web", "gui/session", "gui/view", "gui/widgets"}},
      {"gui/scene", {"core", "io", "vtk", "picture", "gui/session", "gui/widgets"}},
      {"gui/docks",
       {"core", "io", "study", "measure", "page", "chart", "picture", "report", "gui/session",
        "gui/view", "gui/scene", "gui/widgets"}},
      {"gui/app", {"core", "io", "vtk", "study", "chart", "report", "gui"}},
      {"main", {"core", "io", "cli", "gui/app"}}};
  return rooms;
}

/// Headers of libraries that a folder of src must not include. The simulation includes the standard
/// library's, which have no folder and no ending, and the one of huge pages. Charts and pictures
/// are files, too, whose bytes do not depend on the user's language.
const std::map<QString, QString>& foreignHeaders() {
  static const std::map<QString, QString> headers{
      {"core", R"(^(?!sys/mman\.h$).*[./])"},
      {"capture", "^(Q[A-Z]|vtk|OpenImageIO|nlohmann)"},
      {"io", "^(Q[A-Z]|vtk)"},
      {"vtk", "^(Q[A-Z]|opencv|OpenImageIO|nlohmann)"},
      {"study", "^(Q[A-Z]|vtk|OpenImageIO|nlohmann)"},
      {"measure", "^(Q[A-Z]|vtk|opencv|OpenImageIO)"},
      {"chart", "^(QLocale$|vtk|opencv|OpenImageIO|nlohmann)"},
      {"picture", "^(QLocale$|vtk|opencv|OpenImageIO|nlohmann)"},
      {"runs", "^(Q[A-Z]|vtk|opencv|OpenImageIO)"},
      {"page", R"([./])"},
      {"report", "^(Q[A-Z]|vtk|opencv|OpenImageIO|nlohmann)"},
      {"cli", "^(Q[A-Z]|opencv|OpenImageIO|nlohmann)"},
      {"python", "^(Q[A-Z]|vtk|opencv|OpenImageIO|nlohmann)"},
      {"gui", "^(opencv|OpenImageIO|nlohmann)"}};
  return headers;
}

struct Include {
  QString module;  ///< path of the file without its ending
  QString header;
  bool isOurs = false;
};

std::vector<Include> allIncludes(const QString& folder) {
  // \x22 is a quotation mark, which moc does not understand in a raw string.
  static const QRegularExpression line(R"(^\s*#\s*include\s*[<\x22]([^>\x22]+)[>\x22])",
                                       QRegularExpression::MultilineOption);
  std::vector<Include> includes;
  QDirIterator files(folder, {"*.h", "*.cpp", "*.cxx"}, QDir::Files, QDirIterator::Subdirectories);
  while (files.hasNext()) {
    QFile file(files.next());
    if (!file.open(QIODevice::ReadOnly)) continue;
    const QString module = QDir(folder).relativeFilePath(file.fileName()).section('.', 0, 0);
    for (const auto& match : line.globalMatch(QString::fromUtf8(file.readAll()))) {
      QString header = match.captured(1);
      bool isOurs = QFile::exists(folder + "/" + header);
      // VTK classes include each other without a folder, as VTK's own do.
      if (!isOurs && QFile::exists(folder + "/vtk/" + header)) {
        header = "vtk/" + header;
        isOurs = true;
      }
      includes.push_back({module, header, isOurs});
    }
  }
  return includes;
}

QString roomOf(const QString& path) {
  return path.contains('/') ? path.section('/', 0, -2) : QString("main");
}

bool mayInclude(const QString& room, const QString& other) {
  if (room == other) return true;
  const QStringList& allowed = allowedRooms().at(room);
  return allowed.contains(other) || allowed.contains(other.section('/', 0, 0));
}

/// Modules are reachable from each other exactly if they are in one circle.
using Graph = std::map<QString, std::set<QString>>;

std::set<QString> reachable(const Graph& graph, const QString& from) {
  std::set<QString> found;
  std::vector<QString> open{from};
  while (!open.empty()) {
    const QString module = open.back();
    open.pop_back();
    const auto next = graph.find(module);
    if (next == graph.end()) continue;
    for (const QString& other : next->second)
      if (found.insert(other).second) open.push_back(other);
  }
  return found;
}

QStringList circleOf(const Graph& graph, const std::map<QString, std::set<QString>>& reach,
                     const QString& module) {
  QStringList circle;
  if (!reach.at(module).contains(module)) return circle;
  for (const auto& [other, next] : graph)
    if (reach.at(module).contains(other) && reach.at(other).contains(module)) circle << other;
  return circle;
}

}  // namespace

class TestLayers : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void everyRoomHasItsRule();
  void roomsKeepTheirOrder();
  void librariesStayInTheirRooms();
  void circlesAreSmall();
  void otherBuildsFindTheirHeaders();

 private:
  std::vector<Include> m_includes;
};

void TestLayers::initTestCase() {
  m_includes = allIncludes(HOGELSCOPE_SOURCE_DIR "/src");
  QVERIFY(m_includes.size() > 1000);
}

void TestLayers::everyRoomHasItsRule() {
  for (const Include& include : m_includes)
    QVERIFY2(allowedRooms().contains(roomOf(include.module)), qPrintable(include.module));
}

void TestLayers::roomsKeepTheirOrder() {
  QStringList wrong;
  for (const auto& [module, header, isOurs] : m_includes)
    if (isOurs && !mayInclude(roomOf(module), roomOf(header))) wrong << module + " → " + header;
  QVERIFY2(wrong.isEmpty(), qPrintable("\n" + wrong.join('\n')));
}

void TestLayers::librariesStayInTheirRooms() {
  QStringList wrong;
  for (const auto& [module, header, isOurs] : m_includes) {
    const auto foreign = foreignHeaders().find(module.section('/', 0, 0));
    if (!isOurs && foreign != foreignHeaders().end() &&
        QRegularExpression(foreign->second).match(header).hasMatch())
      wrong << module + " → " + header;
  }
  QVERIFY2(wrong.isEmpty(), qPrintable("\n" + wrong.join('\n')));
}

/// A header and its source are one module.
void TestLayers::circlesAreSmall() {
  Graph graph;
  for (const auto& [module, header, isOurs] : m_includes)
    if (isOurs && header.section('.', 0, 0) != module)
      graph[module].insert(header.section('.', 0, 0));
  std::map<QString, std::set<QString>> reach;
  for (const auto& [module, next] : graph) reach[module] = reachable(graph, module);
  for (const auto& [module, next] : graph) {
    const QStringList circle = circleOf(graph, reach, module);
    constexpr int most = 2;
    QVERIFY2(circle.size() <= most, qPrintable(circle.join(", ")));
  }
}

/// Fuzzers are not built with the tests.
void TestLayers::otherBuildsFindTheirHeaders() {
  const QString root = HOGELSCOPE_SOURCE_DIR "/";
  QStringList missing;
  for (const Include& include : allIncludes(root + "tests/fuzz"))
    if (include.header.contains('/') && !QFile::exists(root + "src/" + include.header) &&
        !QFile::exists(root + include.header))
      missing << include.module + ": " + include.header;
  QVERIFY2(missing.isEmpty(), qPrintable(missing.join('\n')));
}

QTEST_GUILESS_MAIN(TestLayers)
#include "test_layers.moc"
