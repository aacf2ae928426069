# What makes faults end the program instead of being used: for all that is built after this, in
# optimised builds. Sanitizers find more, and do not go together with _FORTIFY_SOURCE. The measured
# costs are in docs/measurements.md. Five hot files of core do without
# checked indices (src/CMakeLists.txt).
set(HOGELSCOPE_IS_HARDENED OFF)
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" AND CMAKE_BUILD_TYPE MATCHES "^(Release|RelWithDebInfo)$"
    AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  set(HOGELSCOPE_IS_HARDENED ON)
  include(CheckPIESupported)
  check_pie_supported(LANGUAGES C CXX)
  add_compile_options(-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=3 -fstack-protector-strong
    -fstack-clash-protection)
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    add_compile_options(-fcf-protection=full)
  endif()
  add_link_options(-Wl,-z,relro -Wl,-z,now)
endif()
