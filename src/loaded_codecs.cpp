// SPDX-License-Identifier: BSD-3-Clause
// The codecs of the program hogelscope, in place of io/codecs/codecs.cpp: it loads them when they
// are first needed. Lazily bound, since most of the 230 libraries' functions are never called.
#include <dlfcn.h>

#include <filesystem>

#include "core/base/error.h"
#include "io/images/codecs.h"

namespace hogelscope {

const Codecs& codecs() {
  static const Codecs& loaded = []() -> const Codecs& {
    namespace fs = std::filesystem;
    // Not by the program's search path, which sanitizers hide.
    const fs::path file =
        (fs::read_symlink("/proc/self/exe").parent_path() / HOGELSCOPE_CODECS).lexically_normal();
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
