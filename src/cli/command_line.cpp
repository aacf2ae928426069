// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command_line.h"

#include <stdexcept>

#include "core/base/text.h"

namespace hogelscope {

const std::vector<std::string>& CommandLine::texts(std::string_view option) const {
  const auto found = options.find(option);
  if (found == options.end())
    throw std::logic_error("--" + std::string(option) + " is read by a job that does not have it");
  return found->second;
}

std::string CommandLine::text(std::string_view option, const char* otherwise) const {
  return has(option) ? texts(option).front() : otherwise;
}

std::optional<double> CommandLine::number(std::string_view option) const {
  return has(option) ? numberOf(texts(option).front()) : std::nullopt;
}

}  // namespace hogelscope
