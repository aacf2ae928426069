// SPDX-License-Identifier: BSD-3-Clause
#include "measure/sweep_table.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/base/random_numbers.h"
#include "core/base/text.h"
#include "core/metrics/statistics.h"
#include "io/files/atomic_file.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

namespace {

double numberAt(const Json& object, const char* name, const std::string& path) {
  const auto found = object.find(name);
  if (found == object.end()) throw InputError(path + "." + name, "is missing");
  if (!found->is_number() || !std::isfinite(found->get<double>()))
    throw InputError(path + "." + name, found->dump() + " is not a number");
  return found->get<double>();
}

void refuseOthers(const Json& object, const std::string& path,
                  std::initializer_list<std::string_view> known) {
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    const std::vector<std::string_view> names(known);
    const std::string_view nearest = nearestName(key, names);
    throw InputError(
        path + key,
        "is not known here" +
            (nearest.empty() ? std::string() : "; did you mean \"" + std::string(nearest) + "\"?"));
  }
}

bool isWhole(double value) {
  return std::floor(value) == value && std::abs(value) < 1e9;
}

void readRange(const Json& object, const std::string& path, SweepParameter& parameter) {
  refuseOthers(object, path + ".", {"from", "to", "count"});
  parameter.kind = SweepParameter::Kind::range;
  parameter.from = numberAt(object, "from", path);
  parameter.to = numberAt(object, "to", path);
  if (!(parameter.to >= parameter.from)) throw InputError(path + ".to", "is less than from");
  if (object.contains("count")) {
    const double count = numberAt(object, "count", path);
    if (!isWhole(count) || count < 1 || count > double(mostDesigns))
      throw InputError(path + ".count",
                       numberText(count) + " is not a whole number from 1 to 1000000");
    parameter.count = int(count);
  } else {
    parameter.isWhole = isWhole(parameter.from) && isWhole(parameter.to);
  }
}

SweepParameter readParameter(const std::string& name, const Json& value) {
  const std::string path = "parameters." + name;
  if (name.find('.') == std::string::npos)
    throw InputError(path, "is not section.field, such as psf.sigma");
  SweepParameter parameter;
  parameter.name = name;
  if (value.is_array() && !value.empty()) {
    for (const Json& one : value) parameter.values.push_back(one.dump());
  } else if (value.is_object() && value.contains("normal")) {
    refuseOthers(value, path + ".", {"normal"});
    const Json& normal = value["normal"];
    if (!normal.is_array() || normal.size() != 2 || !normal[0].is_number() ||
        !normal[1].is_number() || !(normal[1].get<double>() >= 0))
      throw InputError(path + ".normal", "is not [mean, deviation] with a deviation from 0 on");
    parameter.kind = SweepParameter::Kind::normal;
    parameter.from = normal[0].get<double>();
    parameter.to = normal[1].get<double>();
  } else if (value.is_object()) {
    readRange(value, path, parameter);
  } else {
    throw InputError(path,
                     "is neither a list of values nor {\"from\": …, \"to\": …, \"count\": …} nor "
                     "{\"normal\": [mean, deviation]}");
  }
  return parameter;
}

const Json& listOf(const Json& document, const char* name) {
  const Json& list = document[name];
  const bool areTexts =
      list.is_array() && std::ranges::all_of(list, [](const Json& one) { return one.is_string(); });
  if (!areTexts || list.empty())
    throw InputError(name, "is not a list of figures, such as [\"depthOfField\", \"mtf:0.05\"]");
  return list;
}

void readSampling(const Json& document, SweepTable& table) {
  const bool isGrid = !document.contains("sampling") || document["sampling"] == "grid";
  if (!isGrid && document["sampling"] != "latin-hypercube")
    throw InputError("sampling",
                     document["sampling"].dump() + " is neither grid nor latin-hypercube");
  table.sampling = isGrid ? SweepSampling::grid : SweepSampling::latinHypercube;
  if (document.contains("seed")) {
    const double seed = numberAt(document, "seed", "table");
    if (!isWhole(seed) || seed < 0) throw InputError("seed", "is not a whole number from 0 on");
    table.seed = std::uint64_t(seed);
  }
  if (isGrid) {
    if (document.contains("count"))
      throw InputError("count",
                       "is of a Latin hypercube; ranges of a grid have counts of their own");
    for (const SweepParameter& parameter : table.parameters) {
      if (parameter.kind == SweepParameter::Kind::normal)
        throw InputError(
            "parameters." + parameter.name,
            "is normal, which a grid cannot be: say \"sampling\": \"latin-hypercube\"");
      if (parameter.kind == SweepParameter::Kind::range && parameter.count == 0 &&
          !parameter.isWhole)
        throw InputError("parameters." + parameter.name + ".count", "is missing");
    }
    return;
  }
  if (!document.contains("count")) throw InputError("count", "is missing: how many designs");
  const double count = numberAt(document, "count", "table");
  if (!isWhole(count) || count < 1 || count > double(mostDesigns))
    throw InputError("count", numberText(count) + " is not a whole number from 1 to 1000000");
  table.count = int(count);
}

/// Reads the limits of good units: a number is the least that a figure may be.
void readPass(const Json& pass, const std::string& where, SweepTable& table) {
  if (!pass.is_object()) throw InputError(where, "is not an object, such as {\"psnr:design\": 30}");
  for (const auto& [figure, value] : pass.items()) {
    const std::string path = where + "." + figure;
    if (std::ranges::find(table.figures, figure) == table.figures.end())
      throw InputError(path, "is none of the figures");
    SweepLimit limit{figure};
    if (value.is_number()) {
      limit.least = value.get<double>();
    } else if (value.is_object() && !value.empty()) {
      refuseOthers(value, path + ".", {"min", "max"});
      if (value.contains("min")) limit.least = numberAt(value, "min", path);
      if (value.contains("max")) limit.most = numberAt(value, "max", path);
    } else {
      throw InputError(path, "is neither a number nor {\"min\": …, \"max\": …}");
    }
    table.pass.push_back(limit);
  }
}

void readSolve(const Json& solve, SweepTable& table) {
  if (!solve.is_object())
    throw InputError("solve",
                     "is not an object, such as {\"parameter\": \"twin.random.shift.sigma\", "
                     "\"yield\": 0.95, \"pass\": {\"psnr:design\": 30}}");
  refuseOthers(solve, "solve.", {"parameter", "yield", "pass", "from", "to"});
  if (!solve.contains("parameter") || !solve["parameter"].is_string())
    throw InputError("solve.parameter", "is missing: the name of what is solved for");
  SweepSolve read{solve["parameter"].get<std::string>(), numberAt(solve, "yield", "solve"), {}, {}};
  if (!(read.yield > 0 && read.yield < 1))
    throw InputError("solve.yield", numberText(read.yield) + " is not between 0 and 1");
  if (solve.contains("from")) read.from = numberAt(solve, "from", "solve");
  if (solve.contains("to")) read.to = numberAt(solve, "to", "solve");
  if (!table.pass.empty())
    throw InputError("pass", "is for a sweep without solve, which has a pass of its own");
  if (!solve.contains("pass")) throw InputError("solve.pass", "is missing: limits of good units");
  readPass(solve["pass"], "solve.pass", table);
  if (table.pass.empty()) throw InputError("solve.pass", "has no limit");
  table.solve = read;
}

std::size_t gridCount(const SweepParameter& parameter) {
  if (parameter.kind == SweepParameter::Kind::list) return parameter.values.size();
  return parameter.count > 0 ? std::size_t(parameter.count)
                             : std::size_t(parameter.to - parameter.from) + 1;
}

/// Returns value k of n of a grid. Whole numbers at whole steps stay whole, as a seed must be.
std::string gridValue(const SweepParameter& parameter, std::size_t k, std::size_t n) {
  if (parameter.kind == SweepParameter::Kind::list) return parameter.values[k];
  if (n > 1 && k == n - 1) return numberText(parameter.to);
  const double steps = n > 1 ? double(n - 1) : 1;
  return numberText(parameter.from + double(k) * (parameter.to - parameter.from) / steps);
}

std::vector<Design> gridOf(const SweepTable& table) {
  std::vector<std::size_t> counts;
  std::size_t all = 1;
  for (const SweepParameter& parameter : table.parameters) {
    counts.push_back(gridCount(parameter));
    if (counts.back() > mostDesigns / all)
      throw InputError("parameters", "make more than 1000000 designs");
    all *= counts.back();
  }
  std::vector<Design> designs;
  for (std::size_t index = 0; index < all; ++index) {
    Design design(counts.size());
    std::size_t rest = index;
    for (std::size_t p = counts.size(); p-- > 0;) {
      design[p] = gridValue(table.parameters[p], rest % counts[p], counts[p]);
      rest /= counts[p];
    }
    designs.push_back(std::move(design));
  }
  return designs;
}

std::vector<Design> hypercubeOf(const SweepTable& table) {
  const auto count = std::size_t(table.count);
  std::vector<Design> designs(count, Design(table.parameters.size()));
  RandomNumbers random(table.seed);
  std::vector<std::size_t> order(count);
  for (std::size_t p = 0; p < table.parameters.size(); ++p) {
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t k = count; k > 1; --k)  // Fisher and Yates
      std::swap(order[k - 1], order[std::size_t(random.unit() * double(k))]);
    for (std::size_t k = 0; k < count; ++k)
      designs[k][p] = table.parameters[p].at((double(order[k]) + random.unit()) / double(count));
  }
  return designs;
}

}  // namespace

bool areUnits(const SweepTable& table) {
  return std::ranges::any_of(table.parameters, [&table](const SweepParameter& parameter) {
    return parameter.kind == SweepParameter::Kind::normal || parameter.name.ends_with(".seed") ||
           (table.sampling == SweepSampling::latinHypercube && parameter.name.starts_with("twin."));
  });
}

std::string SweepParameter::at(double share) const {
  const auto step = [share](std::size_t n) {
    return std::min(std::size_t(share * double(n)), n - 1);
  };
  if (kind == Kind::list) return values[step(values.size())];
  if (kind == Kind::normal) return numberText(from + to * normalQuantile(share));
  if (isWhole) return numberText(from + double(step(std::size_t(to - from) + 1)));
  if (count > 0) return gridValue(*this, step(std::size_t(count)), std::size_t(count));
  return numberText(from + share * (to - from));
}

SweepTable parseSweepTable(const std::string& text) {
  const Json document = parseJson(text);
  if (!document.is_object()) throw InputError("table", "is not an object: { \"parameters\": … }");
  refuseOthers(document, "",
               {"parameters", "sampling", "count", "seed", "figures", "pareto", "pass", "solve"});
  SweepTable table;
  if (!document.contains("parameters") || !document["parameters"].is_object() ||
      document["parameters"].empty())
    throw InputError("parameters", "is missing: an object, such as {\"psf.sigma\": [0.5, 1]}");
  for (const auto& [name, value] : document["parameters"].items())
    table.parameters.push_back(readParameter(name, value));
  readSampling(document, table);
  if (!document.contains("figures")) throw InputError("figures", "is missing");
  for (const Json& figure : listOf(document, "figures"))
    table.figures.push_back(figure.get<std::string>());
  if (document.contains("pass")) readPass(document["pass"], "pass", table);
  if (document.contains("solve")) readSolve(document["solve"], table);
  if (!document.contains("pareto")) return table;
  if (!document["pareto"].is_object())
    throw InputError("pareto", "is not an object, such as {\"depthOfField\": \"max\"}");
  for (const auto& [figure, goal] : document["pareto"].items()) {
    if (std::ranges::find(table.figures, figure) == table.figures.end())
      throw InputError("pareto." + figure, "is none of the figures");
    if (goal != "max" && goal != "min")
      throw InputError("pareto." + figure, goal.dump() + " is neither \"max\" nor \"min\"");
    table.pareto.push_back({figure, goal == "max" ? 1 : -1});
  }
  return table;
}

SweepTable loadSweepTable(const std::filesystem::path& file) {
  return inFile(file.string(), [&] { return parseSweepTable(readTextFile(file)); });
}

std::vector<Design> designsOf(const SweepTable& table) {
  return table.sampling == SweepSampling::grid ? gridOf(table) : hypercubeOf(table);
}

std::vector<std::string> overridesOf(const SweepTable& table, const Design& design) {
  std::vector<std::string> overrides;
  for (std::size_t p = 0; p < design.size(); ++p)
    overrides.push_back(table.parameters[p].name + "=" + design[p]);
  return overrides;
}

}  // namespace hogelscope
