// SPDX-License-Identifier: BSD-3-Clause
#include "cli/jobs.h"

#include <algorithm>
#include <ranges>

namespace hogelscope {

namespace {

bool isIn(const std::vector<std::string_view>& names, const Flag& flag) {
  return std::ranges::find(names, flag.name) != names.end() ||
         (!flag.with.empty() && std::ranges::find(names, flag.with) != names.end());
}

}  // namespace

bool accepts(const Job* job, const Flag& flag) {
  if (job == nullptr) return flag.isForWindow;
  return isIn(job->takes, flag) || isIn(job->needs, flag) ||
         std::ranges::find(job->own, flag.name, &Flag::name) != job->own.end();
}

bool needs(const Job* job, const Flag& flag) {
  return job != nullptr && isIn(job->needs, flag);
}

bool mayNameFile(std::string_view value) {
  return std::ranges::any_of(std::views::split(value, '|'), [](const auto& part) {
    const std::string_view word(part.begin(), part.end());
    return word == "LF" || word == "PATH" || word.starts_with("FILE") || word == "TABLE.json";
  });
}

std::vector<const Job*> jobsOf(const Flag& flag) {
  std::vector<const Job*> owners;
  for (const Job& job : jobs())
    if (accepts(&job, flag)) owners.push_back(&job);
  std::ranges::stable_partition(owners, [&](const Job* job) { return job->name != flag.lastJob; });
  return owners;
}

std::string optionsOf(const std::vector<const Job*>& owners) {
  std::string text;
  for (const Job* const job : owners)
    text += (text.empty() ? "--" : ", --") + std::string(job->name);
  return text;
}

}  // namespace hogelscope
