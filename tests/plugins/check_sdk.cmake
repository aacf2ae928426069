cmake_minimum_required(VERSION 3.25)
# Checks that the SDK's headers are those of their number: a plugin that was built with others must not be
# loaded, and the number is all that tells.
# Run as: cmake -D SOURCE=<repository> -P check_sdk.cmake

set(headers src/sdk/hogelscope/plugin.h src/core/base/parameters.h src/core/base/geometry.h)
set(all "")
foreach(header ${headers})
  file(READ ${SOURCE}/${header} text)
  string(APPEND all "${text}")
endforeach()
string(SHA256 sum "${all}")
if(NOT all MATCHES "uint32_t abi = ([0-9]+);")
  message(FATAL_ERROR "src/sdk/hogelscope/plugin.h has no line \"constexpr std::uint32_t abi = N;\"")
endif()
set(found "abi ${CMAKE_MATCH_1} sha256 ${sum}")
file(READ ${CMAKE_CURRENT_LIST_DIR}/sdk.sha256 kept)
string(STRIP "${kept}" kept)
if(NOT found STREQUAL kept)
  list(JOIN headers ", " names)
  message(FATAL_ERROR "the plugin SDK has changed (${names}):\n  it was ${kept}\n  it is  ${found}\n"
    "Raise abi in src/sdk/hogelscope/plugin.h by one, unless only comments have changed. Then run this test "
    "again and write the line \"it is\" into tests/plugins/sdk.sha256. Plugins have to be built again.")
endif()
message(STATUS "${found}")
