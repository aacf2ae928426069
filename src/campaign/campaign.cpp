// SPDX-License-Identifier: BSD-3-Clause
#include "campaign/campaign.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/light_field/frames.h"
#include "io/files/atomic_file.h"
#include "io/json/json_parameters.h"
#include "io/scene/numbered_frames.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view sceneMark = "{scene}";
constexpr std::size_t leastOfCurve = 4;  // tests

std::string textOf(JsonReader& reader, const char* name, const char* otherwise = nullptr) {
  const Json* value = reader.section(name);
  if (value == nullptr && otherwise != nullptr) return otherwise;
  if (value == nullptr || !value->is_string() || value->get_ref<const std::string&>().empty())
    throw InputError(reader.pathOf(name), "is not a text");
  return value->get<std::string>();
}

/// Whether a name can be that of a folder in the report's.
bool isFolderName(const std::string& name) {
  return !name.empty() && name != "." && name != ".." &&
         name.find_first_of("/\\") == std::string::npos && printable(name) == name;
}

std::string beside(const std::string& document, const std::string& path) {
  return (fs::path(document).parent_path() / path).lexically_normal().string();
}

std::vector<CampaignScene> readScenes(const Json* scenes, const std::string& document) {
  if (scenes == nullptr || !scenes->is_object() || scenes->empty())
    throw InputError("scenes", "is not an object of scenes: {\"NAME\": \"session.json\", …}");
  std::vector<CampaignScene> read;
  for (const auto& [name, value] : scenes->items()) {
    const std::string path = "scenes." + printable(name);
    if (!isFolderName(name))
      throw InputError(path, "is not the name of a folder, which the scene's report gets");
    CampaignScene scene{name, ""};
    if (value.is_string()) {
      scene.session = value.get<std::string>();
    } else if (value.is_object()) {
      JsonReader reader(value, path);
      scene.session = textOf(reader, "session");
      scene.states = textOf(reader, "states", "");
      reader.refuseUnknown();
    } else {
      throw InputError(path, "is neither a session's file nor {\"session\": …, \"states\": …}");
    }
    scene.session = beside(document, scene.session);
    read.push_back(std::move(scene));
  }
  return read;
}

/// A word in braces, and what it may be.
struct BraceList {
  std::string name;
  std::vector<std::string> values;
};

std::vector<std::string> valuesOf(const Json& list, const std::string& path) {
  std::vector<std::string> values;
  const std::string known = "is not a list of numbers or texts, for {" +
                            path.substr(path.rfind('.') + 1) + "} in the name and the file";
  if (!list.is_array() || list.empty()) throw InputError(path, known);
  for (const Json& value : list) {
    if (!value.is_string() && !value.is_number()) throw InputError(path, known);
    values.push_back(value.is_string() ? value.get<std::string>() : value.dump());
  }
  return values;
}

void replaceAll(std::string& text, std::string_view word, const std::string& by) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at)) {
    text.replace(at, word.size(), by);
    at += by.size();
  }
}

/// Throws for a word in braces that nothing stands for.
void checkBraces(const std::string& text, const std::string& path,
                 const std::vector<BraceList>& lists) {
  for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1)) {
    const std::size_t end = text.find('}', at);
    const std::string word = text.substr(at, end == std::string::npos ? end : end - at + 1);
    const bool isList = std::ranges::any_of(
        lists, [&](const BraceList& list) { return word == "{" + list.name + "}"; });
    if (isList || word == sceneMark || word == frameMark) continue;
    throw InputError(path,
                     "has " + word + ", which is neither {scene}, {T}, nor a list of the test");
  }
}

/// Adds a test for each combination of the lists' values, the last list's first.
void addTests(std::vector<CampaignTest>& tests, const CampaignTest& of,
              const std::vector<BraceList>& lists, std::size_t from = 0) {
  if (from == lists.size()) {
    tests.push_back(of);
    return;
  }
  for (const std::string& value : lists[from].values) {
    CampaignTest one = of;
    replaceAll(one.name, "{" + lists[from].name + "}", value);
    replaceAll(one.file, "{" + lists[from].name + "}", value);
    addTests(tests, one, lists, from + 1);
  }
}

void readTest(const Json& object, const std::string& path, const std::string& document,
              std::vector<CampaignTest>& tests) {
  JsonReader reader(object, path);
  CampaignTest test;
  test.group = textOf(reader, "group", "");
  test.file = textOf(reader, "file");
  std::vector<BraceList> lists;
  std::string usual;
  for (const auto& [name, value] : object.items()) {
    if (name == "group" || name == "name" || name == "file") continue;
    const Json* list = reader.section(name);
    lists.push_back({name, valuesOf(*list, reader.pathOf(name))});
    if ("{" + name + "}" == sceneMark || "{" + name + "}" == frameMark)
      throw InputError(reader.pathOf(name), "has a name that stands for something else");
    usual += (usual.empty() ? "{" : " {") + name + "}";
  }
  const bool isNamed = reader.has("name");
  test.name = isNamed         ? textOf(reader, "name")
              : usual.empty() ? fs::path(test.file).stem().string()
                              : usual;
  reader.refuseUnknown();
  checkBraces(test.name, reader.pathOf("name"), lists);
  checkBraces(test.file, reader.pathOf("file"), lists);
  for (const BraceList& list : lists)
    if (test.file.find("{" + list.name + "}") == std::string::npos)
      throw InputError(reader.pathOf(list.name),
                       "is not in the file: write {" + list.name + "} where its values stand");
  if (!test.group.empty()) test.name = test.group + " " + test.name;
  test.file = beside(document, test.file);
  addTests(tests, test, lists);
}

std::vector<CampaignTest> readTests(const Json* list, const std::string& document) {
  if (list == nullptr || !list->is_array() || list->empty())
    throw InputError("tests",
                     "is not a list of tests: [{\"group\": \"HEVC\", \"name\": \"q{q}\", "
                     "\"q\": [22, 27, 32, 37], \"file\": \"coded/{scene}/q{q}.mp4\"}, …]");
  std::vector<CampaignTest> tests;
  for (std::size_t k = 0; k < list->size(); ++k)
    readTest((*list)[k], "tests[" + std::to_string(k) + "]", document, tests);
  std::set<std::string> names;
  for (const CampaignTest& test : tests)
    if (!names.insert(test.name).second)
      throw InputError("tests", "two have the name \"" + test.name + "\": give another \"name\"");
  return tests;
}

/// Reads a list of names of `what`; empty if there is none.
std::vector<std::string> readNames(const Json* list, const char* field, const std::string& what) {
  std::vector<std::string> names;
  if (list == nullptr) return names;
  const std::string known = "is not a list of names of " + what;
  if (!list->is_array()) throw InputError(field, known);
  for (const Json& name : *list) {
    if (!name.is_string()) throw InputError(field, known);
    names.push_back(name.get<std::string>());
  }
  return names;
}

std::vector<std::string> readColumns(const Json* tables) {
  if (tables == nullptr) return {};
  if (!tables->is_object())
    throw InputError("tables", "is not an object: {\"columns\": [\"mean_psnr_seen\", …]}");
  JsonReader reader(*tables, "tables");
  std::vector<std::string> columns =
      readNames(reader.section("columns"), "tables.columns", "columns of summary.csv");
  reader.refuseUnknown();
  return columns;
}

/// Reads lines scene,test,bits; the first one may be names of columns.
std::vector<CampaignRate> readRates(const std::string& file, const Campaign& campaign) {
  std::vector<CampaignRate> rates;
  const Table table = csvRows(readTextFile(file));
  for (std::size_t line = 0; line < table.size(); ++line) {
    const std::vector<std::string>& cells = table[line];
    const std::string place = "line " + std::to_string(line + 1);
    if (cells.size() == 1 && cells[0].empty()) continue;
    if (cells.size() != 3) throw InputError(place, "is not scene,test,bits");
    const std::optional<double> bits = numberOf(cells[2]);
    if (!bits && line == 0) continue;
    if (!bits || !(*bits > 0) || !std::isfinite(*bits))
      throw InputError(place, "\"" + cells[2] + "\" is not a number of bits above 0");
    if (std::ranges::find(campaign.scenes, cells[0], &CampaignScene::name) == campaign.scenes.end())
      throw InputError(place, "\"" + cells[0] + "\" is no scene of the campaign");
    if (std::ranges::find(campaign.tests, cells[1], &CampaignTest::name) == campaign.tests.end())
      throw InputError(place, "\"" + cells[1] + "\" is no test of the campaign; the first is \"" +
                                  campaign.tests.front().name + "\"");
    rates.push_back({cells[0], cells[1], *bits});
  }
  return rates;
}

Campaign read(const Json& document, const std::string& file) {
  JsonReader reader(document, "");
  Campaign campaign;
  campaign.file = file;
  campaign.scenes = readScenes(reader.section("scenes"), file);
  campaign.tests = readTests(reader.section("tests"), file);
  campaign.metrics = readNames(reader.section("metrics"), "metrics", "metrics");
  campaign.columns = readColumns(reader.section("tables"));
  const std::string rates = textOf(reader, "rates", "");
  reader.refuseUnknown();
  if (rates.empty()) return campaign;
  campaign.rateFile = beside(file, rates);
  campaign.rates =
      inFile(campaign.rateFile, [&] { return readRates(campaign.rateFile, campaign); });
  return campaign;
}

/// Whether a light field is there: a file, a folder, or the first frame of several.
bool isThere(const std::string& file) {
  try {
    const std::string first = firstFileOf(file);
    const std::size_t pattern = first.find('%');
    std::error_code none;
    return fs::exists(
        pattern == std::string::npos ? fs::path(first) : fs::path(first).parent_path(), none);
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

Campaign parseCampaign(const std::string& text, const std::string& file) {
  return inFile(file, [&] { return read(parseJson(text), file); });
}

Campaign loadCampaign(const std::string& file) {
  return parseCampaign(readTextFile(file), file);
}

SceneWork workOf(const Campaign& campaign, const CampaignScene& scene, const fs::path& output) {
  SceneWork work;
  work.session = scene.session;
  work.states = scene.states;
  work.folder = (output / scene.name).string();
  for (const CampaignTest& test : campaign.tests) {
    SceneTest one{&test, test.file};
    replaceAll(one.file, sceneMark, scene.name);
    (isThere(one.file) ? work.tests : work.missing).push_back(one);
  }
  for (const SceneTest& test : work.missing)
    work.lines.push_back(test.test->name + " is missing: " + test.file + " is not there");
  for (const auto& [test, file] : work.tests) {
    if (test->group.empty()) continue;
    auto group = std::ranges::find(work.groups, test->group, &RateGroup::name);
    if (group == work.groups.end()) group = work.groups.insert(group, {test->group, {}});
    const auto rate = std::ranges::find_if(campaign.rates, [&](const CampaignRate& given) {
      return given.scene == scene.name && given.test == test->name;
    });
    group->tests.push_back({file, rate == campaign.rates.end() ? 0 : rate->bits});
  }
  std::erase_if(work.groups, [&](const RateGroup& group) {
    if (group.tests.size() >= leastOfCurve) return false;
    work.lines.push_back(group.name + " has " + std::to_string(group.tests.size()) +
                         " test(s), but a curve needs four or more");
    return true;
  });
  return work;
}

std::vector<std::string> SceneWork::arguments(const Campaign& campaign) const {
  std::vector<std::string> all{"--report", "--session", session};
  const auto add = [&all](const std::string& option, const std::string& value) {
    all.push_back(option);
    all.push_back(value);
  };
  if (!states.empty()) add("--states", states);
  for (const SceneTest& test : tests) add("--test", test.file);
  for (const RateGroup& group : groups) {
    std::string files;
    for (const TestRate& test : group.tests) files += (files.empty() ? "" : ",") + test.test;
    add("--group", group.name + "=" + files);
    for (const TestRate& test : group.tests)
      if (test.rate > 0) add("--rate", test.test + "=" + numberText(test.rate));
  }
  if (!campaign.metrics.empty()) {
    Json names = campaign.metrics;
    add("--set", "metrics=" + names.dump());
  }
  add("--output", folder);
  return all;
}

}  // namespace hogelscope
