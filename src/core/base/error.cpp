// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/error.h"

#include "core/base/text.h"

namespace hogelscope {

namespace {

std::string joined(const std::string& file, const std::string& what, const std::string& why) {
  std::string line;
  for (const std::string& part : {file, what, why}) {
    if (part.empty()) continue;
    if (!line.empty()) line += ": ";
    line += printable(part);
  }
  return line;
}

}  // namespace

InputError::InputError(std::string file, std::string what, std::string why)
    : std::runtime_error(joined(file, what, why)),
      m_file(std::move(file)),
      m_what(std::move(what)),
      m_why(std::move(why)) {}

InputError InputError::in(const std::string& file) const {
  return m_file.empty() ? InputError(file, m_what, m_why) : *this;
}

}  // namespace hogelscope
