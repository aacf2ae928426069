// SPDX-License-Identifier: BSD-3-Clause
// The codecs of the programs and of the Python module, in place of io/codecs/codecs.cpp: they load
// them when they are first needed. Lazily bound, since most of the 230 libraries' functions are
// never called. What is loaded has no state, so nothing is there twice.
#include <dlfcn.h>
#include <link.h>

#include <filesystem>
#include <system_error>

#include "core/base/error.h"
#include "io/images/codecs.h"

namespace hogelscope {

namespace {

namespace fs = std::filesystem;

/// Of the program or module that this is linked into; read at its start, since a relative path is
/// of the current folder.
const fs::path ownFolder = [] {
  Dl_info symbol{};
  void* own = nullptr;  // a program's name is empty
  const auto function = reinterpret_cast<void*>(&codecs);
  const bool isModule = ::dladdr1(function, &symbol, &own, RTLD_DL_LINKMAP) != 0 &&
                        *static_cast<link_map*>(own)->l_name != '\0';
  std::error_code error;
  return fs::canonical(isModule ? symbol.dli_fname : "/proc/self/exe", error).parent_path();
}();

}  // namespace

const Codecs& codecs() {
  static const Codecs& loaded = []() -> const Codecs& {
    // Not by the search path, which sanitizers hide.
    const fs::path file = (ownFolder / HOGELSCOPE_CODECS).lexically_normal();
    void* library = ::dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (library == nullptr) throw InputError("codecs", "cannot be loaded", ::dlerror());
    using Entry = const Codecs* (*)();
    const auto entry = reinterpret_cast<Entry>(::dlsym(library, "hogelscopeCodecs"));
    if (entry == nullptr) throw InputError("codecs", "cannot be loaded", ::dlerror());
    return *entry();
  }();
  return loaded;
}

}  // namespace hogelscope
