// SPDX-License-Identifier: BSD-3-Clause
#include "io/documents/votes_file.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

namespace {

constexpr const char* votesVersion = "hogelscope votes";
constexpr std::size_t mostTrials = 100000;
constexpr double mostNumber = 1e9;  // milliseconds are 11 days

void requireList(const Json* list, const std::string& path, const char* what) {
  if (list == nullptr || !list->is_array()) throw InputError(path, std::string("is not ") + what);
}

std::array<std::string, 2> readShown(const Json* shown, const std::string& path) {
  constexpr const char* what = "a list of two names";
  requireList(shown, path, what);
  const Json& list = *shown;
  if (list.size() != 2 || !list[0].is_string() || !list[1].is_string() || list[0] == list[1])
    throw InputError(path, std::string("is not ") + what);
  return {list[0].get<std::string>(), list[1].get<std::string>()};
}

VotesTrial::Point readPoint(const Json& list, const std::string& path) {
  const bool isPoint = list.is_array() && list.size() == 5 &&
                       std::ranges::all_of(list, [](const Json& one) { return one.is_number(); });
  if (!isPoint || !(list[1] == 0 || list[1] == 1))
    throw InputError(path, "is not [milliseconds, 0 or 1, x, y, z]");
  const auto at = [&](std::size_t k) {
    const auto value = list[k].get<double>();
    if (!(std::abs(value) <= mostNumber)) throw InputError(path, "has a number beyond 1e9");
    return value;
  };
  return {at(0), int(at(1)), {at(2), at(3), at(4)}};
}

VotesTrial readTrial(const Json& object, const std::string& path) {
  VotesTrial trial;
  JsonReader reader(object, path);
  describe(reader, trial);
  trial.shown = readShown(reader.section("shown"), reader.pathOf("shown"));
  if (const Json* points = reader.section("path"); points != nullptr) {
    requireList(points, reader.pathOf("path"), "a list of points");
    for (std::size_t k = 0; k < points->size(); ++k)
      trial.path.push_back(
          readPoint((*points)[k], reader.pathOf("path") + "[" + std::to_string(k) + "]"));
  }
  reader.refuseUnknown();
  for (const char* const needed : {"state", "vote"})
    if (!reader.has(needed)) throw InputError(reader.pathOf(needed), "is missing");
  return trial;
}

}  // namespace

void describe(ParameterVisitor& v, VotesHead& p) {
  auto& [page, method, viewer] = p;
  v.group("votes", "The votes of one viewer.");
  v.field("page", page, "A hash of the page.");
  v.field("method", method, "pairs or dsis.");
  v.field("viewer", viewer, "Who voted.");
}

void describe(ParameterVisitor& v, VotesScreen& p) {
  auto& [width, distance, pixels] = p;
  v.group("screen", "The viewer's screen.");
  v.field("width", width, {.min = 1e-3, .max = 100, .mayBeLeftOut = true}, "m", "Its width.");
  v.field("distance", distance, {.min = 1e-3, .max = 100, .mayBeLeftOut = true}, "m",
          "From the eyes.");
  v.field("pixels", pixels, {.min = 1, .max = 1000000}, "px", "Across and down.");
}

void describe(ParameterVisitor& v, VotesTrial& p) {
  auto& [state, vote, seconds, shown, path] = p;  // the lists are read by hand
  v.group("trials", "A question and its answer.");
  v.field("state", state, "The camera state.");
  v.field("vote", vote, {.min = 0, .max = 5}, "", "The answer.");
  v.field("seconds", seconds, {.min = 0, .max = 1e6}, "s", "How long it took.");
}

bool isVotes(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string::npos && text[begin] == '{' &&
         text.find("\"" + std::string(votesVersion) + "\"") != std::string::npos;
}

VotesFile parseVotes(const std::string& text) {
  const Json document = parseJson(text);
  VotesFile votes;
  JsonReader reader(document, "");
  const Json* version = reader.section(votesVersion);
  if (version == nullptr)
    throw InputError(votesVersion, "is missing: this is no file of votes, which a page saves");
  if (*version != 1) throw InputError(votesVersion, valueText(*version) + " is not 1");
  describe(reader, votes.head);
  readSection(reader, "screen", votes.screen);
  const Json* const found = reader.section("trials");
  requireList(found, "trials", "a list of answers");
  const Json& trials = *found;
  reader.refuseUnknown();
  auto& [head, screen, read] = votes;
  if (head.viewer.empty()) throw InputError("viewer", "is missing or empty");
  if (!head.method.empty() && head.method != "pairs" && head.method != "dsis")
    throw InputError("method", valueText(head.method) + " is not pairs or dsis");
  if (trials.size() > mostTrials)
    throw InputError("trials", "has more than " + std::to_string(mostTrials) + " answers");
  for (std::size_t k = 0; k < trials.size(); ++k)
    read.push_back(readTrial(trials[k], "trials[" + std::to_string(k) + "]"));
  return votes;
}

Trace traceOf(const VotesFile& votes) {
  Trace trace{.points = {}, .holds = true};
  double before = 0;
  for (std::size_t k = 0; k < votes.trials.size(); ++k) {
    double last = 0;
    for (const auto& [milliseconds, shown, eye] : votes.trials[k].path) {
      const std::string path = "trials[" + std::to_string(k) + "].path";
      if (!(eye.z > 0)) throw InputError(path, "leaves the side before the panel: z is above 0");
      if (!(milliseconds >= last)) throw InputError(path, "has times that fall");
      last = milliseconds;
      trace.points.push_back({before + last / 1000, eye});
    }
    before += last / 1000;
  }
  if (trace.points.size() < 2 || !(trace.points.back().time > 0))
    throw InputError("trials", "have no ways of the eye");
  return trace;
}

}  // namespace hogelscope
