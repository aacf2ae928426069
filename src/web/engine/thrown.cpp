// SPDX-License-Identifier: BSD-3-Clause
// Exceptions without unwinding, which Debian's libraries for WebAssembly do not have: one becomes
// an Error of JavaScript with the same words. No destructor runs, so the page makes a new engine
// then.
#include <cstdlib>
#include <exception>
#include <typeinfo>

__attribute__((import_module("page"), import_name("thrown"))) [[noreturn]] void pageThrown(
    const char* what);

extern "C" {

void* __cxa_allocate_exception(std::size_t size) noexcept {
  return std::malloc(size);
}

void __cxa_free_exception(void* thrown) noexcept {
  std::free(thrown);
}

/// All exceptions of the core and of the standard library have std::exception as their first base.
[[noreturn]] void __cxa_throw(void* thrown, std::type_info* /*type*/, void (* /*destroy*/)(void*)) {
  pageThrown(static_cast<std::exception*>(thrown)->what());
}

}  // extern "C"
