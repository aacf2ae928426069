// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/plugin_name.h"

#include <algorithm>

#include "core/base/error.h"

namespace hogelscope {

void checkPluginName(const std::string& name, const std::string& path) {
  constexpr std::size_t longest = 40;
  const auto isLetter = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto isAllowed = [&](char c) { return isLetter(c) || (c >= '0' && c <= '9') || c == '-'; };
  if (!name.empty() && name.size() <= longest && isLetter(name[0]) &&
      std::ranges::all_of(name, isAllowed))
    return;
  throw InputError(path, "\"" + name.substr(0, longest) +
                             "\" is not a plugin's name: small letters, digits and \"-\"");
}

}  // namespace hogelscope
