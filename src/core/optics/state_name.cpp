// SPDX-License-Identifier: BSD-3-Clause
// Names of camera states: NAME.png and NAME.mask.png are files.
#include "core/optics/state_name.h"

#include <algorithm>
#include <locale>
#include <optional>
#include <string_view>

#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

namespace {

/// Decodes UTF-8; none if the text is not UTF-8.
std::optional<std::u32string> decoded(const std::string& text) {
  std::u32string characters;
  for (std::size_t at = 0; at < text.size();) {
    const Character next = characterAt(text, at);
    if (!next.point) return std::nullopt;
    characters += *next.point;
    at += next.bytes;
  }
  return characters;
}

/// Whether Windows reserves the name for a device, with any extension.
bool isDevice(const std::u32string& folded) {
  std::u32string base = folded.substr(0, folded.find(U'.'));
  base.erase(base.find_last_not_of(U' ') + 1);
  for (const char32_t* name : {U"con", U"prn", U"aux", U"nul", U"conin$", U"conout$"})
    if (base == name) return true;
  const bool isPort = base.starts_with(U"com") || base.starts_with(U"lpt");
  return isPort && base.size() == 4 &&
         std::u32string_view(U"0123456789¹²³").find(base[3]) != std::u32string_view::npos;
}

/// Returns a locale that knows the case of all letters, or the C locale, for ASCII, if it is
/// missing.
const std::locale& unicodeLocale() {
  static const std::locale locale = [] {
    try {
      return std::locale("C.UTF-8");
    } catch (const std::runtime_error&) {
      return std::locale::classic();
    }
  }();
  return locale;
}

}  // namespace

std::u32string caseFolded(const std::string& name) {
  auto characters = decoded(name);
  if (!characters) return {name.begin(), name.end()};
  const auto& letters = std::use_facet<std::ctype<wchar_t>>(unicodeLocale());
  // Some small letters, such as σ and ς, share a capital.
  for (char32_t& c : *characters) c = char32_t(letters.tolower(letters.toupper(wchar_t(c))));
  return *characters;
}

void checkStateName(const std::string& name, const std::string& path) {
  constexpr std::size_t longest = 200;
  const auto refuse = [&](const std::string& why) { throw InputError(path + ".name", why); };
  if (name.empty()) refuse("is missing: every state has a name of its own");
  if (name.size() > longest) refuse("is longer than 200 bytes");
  const auto characters = decoded(name);
  if (!characters) refuse("is not UTF-8");
  if (std::ranges::any_of(*characters, isControl))
    refuse("has a control character or one that changes the direction of writing");
  const std::string shown = "\"" + name + "\" ";
  if (name.find_first_of("/\\") != std::string::npos)
    refuse(shown + "has a slash; it names the picture's file");
  if (name.front() == '.') refuse(shown + "begins with a dot; it names the picture's file");
  if (name.front() == ' ' || name.back() == ' ' || name.back() == '.')
    refuse(shown + "begins or ends with a space, or ends with a dot; it names the picture's file");
  const std::u32string folded = caseFolded(name);
  if (folded.ends_with(U".mask")) refuse(shown + "ends with .mask, which names the masks");
  if (isDevice(folded))
    refuse(shown + "is a device's name on Windows; it names the picture's file");
}

}  // namespace hogelscope
