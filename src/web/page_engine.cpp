// SPDX-License-Identifier: BSD-3-Clause
#include "web/page_files.h"

#ifdef HOGELSCOPE_WEB_ENGINE
// The assembler copies the file: a compiler takes minutes for as many numbers.
__asm__(
    ".section .rodata\n"
    "hogelscope_web_engine:\n"
    ".incbin \"" HOGELSCOPE_WEB_ENGINE
    "\"\n"
    "hogelscope_web_engine_end:\n"
    ".byte 0\n"
    ".previous\n");
extern "C" {
extern const char hogelscope_web_engine[] __attribute__((visibility("hidden")));
extern const char hogelscope_web_engine_end[] __attribute__((visibility("hidden")));
}
#endif

namespace hogelscope {

std::string_view pageEngine() {
#ifdef HOGELSCOPE_WEB_ENGINE
  return {hogelscope_web_engine, hogelscope_web_engine_end};
#else
  return {};
#endif
}

}  // namespace hogelscope
