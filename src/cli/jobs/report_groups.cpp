// SPDX-License-Identifier: BSD-3-Clause
#include "cli/jobs/report_groups.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parameters.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

void refuseUnknown(const std::string& test, const std::string& flag,
                   const std::vector<TestSize>& tests) {
  std::vector<std::string_view> names;
  for (const TestSize& one : tests) {
    if (one.test == test) return;
    names.push_back(one.test);
  }
  const std::string_view nearest = nearestName(test, names);
  throw InputError(
      "command line", flag,
      "\"" + test + "\" is not given as --test" +
          (nearest.empty() ? std::string() : "; did you mean " + std::string(nearest) + "?"));
}

/// Parses FILE=bpp; FILE may contain "=".
std::vector<TestRate> parseRates(const std::vector<std::string>& texts,
                                 const std::vector<TestSize>& tests) {
  std::vector<TestRate> rates;
  for (const std::string& text : texts) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos)
      throw InputError("command line", "--rate",
                       "\"" + text + "\" is not FILE=BITS, such as test.jpg=0.5");
    const TestRate rate{text.substr(0, equals), 0};
    const std::string number = text.substr(equals + 1);
    double value = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (error != std::errc() || end != number.data() + number.size() || !(value > 0) ||
        !std::isfinite(value))
      throw InputError("command line", "--rate",
                       "\"" + number + "\" is not a number of bits above 0");
    refuseUnknown(rate.test, "--rate", tests);
    for (const TestRate& other : rates)
      if (other.test == rate.test)
        throw InputError("command line", "--rate", "gives " + rate.test + " two rates");
    rates.push_back({rate.test, value});
  }
  return rates;
}

double fileBits(const TestSize& test) {
  double bytes = 0;
  std::error_code error;
  for (const fs::path& file : test.files) {
    const std::uintmax_t size = fs::file_size(file, error);
    if (!error) bytes += double(size);
  }
  if (!(bytes > 0))
    throw InputError("command line", "--group",
                     test.test + " has no size of its own; give --rate " + test.test + "=BITS");
  return 8 * bytes;
}

double findRate(const std::string& test, const std::vector<TestRate>& rates,
                const std::vector<TestSize>& tests) {
  for (const TestRate& rate : rates)
    if (rate.test == test) return rate.rate;
  const auto size = std::find_if(tests.begin(), tests.end(),
                                 [&](const TestSize& one) { return one.test == test; });
  return fileBits(*size) / size->directionalPixels;
}

/// Parses NAME=FILE,FILE,…; the rates are not known yet.
RateGroup parseGroup(const std::string& text, const std::vector<TestSize>& tests) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError("command line", "--group", "\"" + text + "\" is not NAME=FILE,FILE,FILE,FILE");
  RateGroup group{text.substr(0, equals), {}};
  for (std::size_t from = equals + 1; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    const std::string test = text.substr(from, to - from);
    refuseUnknown(test, "--group " + group.name, tests);
    for (const TestRate& other : group.tests)
      if (other.test == test)
        throw InputError("command line", "--group " + group.name, "has " + test + " twice");
    group.tests.push_back({test, 0});
    from = to + 1;
  }
  if (group.tests.size() < 4)
    throw InputError("command line", "--group " + group.name,
                     "has " + std::to_string(group.tests.size()) +
                         " light field(s), but a rate-distortion curve needs four or more");
  return group;
}

}  // namespace

std::vector<RateGroup> rateGroups(const CommandLine& line, const std::vector<TestSize>& tests) {
  if (!line.has("group") && line.has("rate"))
    throw InputError("command line", "--rate",
                     "is for --group NAME=FILE,FILE,…, of which there is none");
  const std::vector<TestRate> rates = parseRates(line.texts("rate"), tests);
  std::vector<RateGroup> groups;
  for (const std::string& text : line.texts("group")) {
    groups.push_back(parseGroup(text, tests));
    for (TestRate& test : groups.back().tests) test.rate = findRate(test.test, rates, tests);
    for (std::size_t k = 0; k + 1 < groups.size(); ++k)
      if (groups[k].name == groups.back().name)
        throw InputError("command line", "--group " + groups[k].name, "is given twice");
  }
  return groups;
}

}  // namespace hogelscope
