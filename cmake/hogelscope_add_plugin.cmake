# hogelscope_add_plugin(NAME mesh VERSION 1.0 SOURCES mesh.cpp LIBRARIES embree KINDS content)
# Builds PLUGINS/NAME/NAME.so, where PLUGINS is plugins-3 of the build folder, and writes plugin.json beside it:
# what the program reads before it loads the library. KINDS: content, lens, metric. The target is
# hogelscope_plugin_NAME. Works in the source tree and, after find_package(Hogelscope), outside of it: the
# headers come from the target Hogelscope::plugin.

# Run as a script after linking, since only then the library's size is known.
if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  file(SIZE "${LIBRARY}" bytes)
  cmake_path(GET LIBRARY FILENAME file)
  cmake_path(REPLACE_FILENAME LIBRARY plugin.json OUTPUT_VARIABLE json)
  string(REPLACE "," "\", \"" kinds "${KINDS}")
  file(WRITE "${json}" "{
  \"name\": \"${NAME}\",
  \"version\": \"${VERSION}\",
  \"kinds\": [\"${kinds}\"],
  \"abi\": ${ABI},
  \"build\": \"${BUILD}\",
  \"file\": \"${file}\",
  \"bytes\": ${bytes}
}
")
  return()
endif()

set(HOGELSCOPE_ADD_PLUGIN_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

# Sets `abi` and `build` of the caller to what the compiler makes of the SDK's header.
function(hogelscope_read_plugin_abi)
  get_target_property(folders Hogelscope::plugin INTERFACE_INCLUDE_DIRECTORIES)
  list(TRANSFORM folders PREPEND "-I")
  separate_arguments(flags NATIVE_COMMAND "${CMAKE_CXX_FLAGS}")
  set(probe ${CMAKE_CURRENT_BINARY_DIR}/plugin_abi.cpp)
  file(WRITE ${probe} "#include <hogelscope/plugin.h>\nplugin_build HOGELSCOPE_PLUGIN_BUILD\n")
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} ${flags} -std=c++20 ${folders} -E -P ${probe}
    OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCH "uint32_t abi = ([0-9]+);" found "${text}")
  set(abi "${CMAKE_MATCH_1}" PARENT_SCOPE)
  string(REGEX MATCH "plugin_build ([^\n]+)" found "${text}")
  string(REGEX REPLACE "[\" ]" "" build "${CMAKE_MATCH_1}")
  set(build "${build}" PARENT_SCOPE)
endfunction()

function(hogelscope_add_plugin)
  cmake_parse_arguments(ARG "" "NAME;VERSION" "SOURCES;LIBRARIES;KINDS" ${ARGN})
  set(target hogelscope_plugin_${ARG_NAME})
  set(folder ${CMAKE_BINARY_DIR}/plugins-3/${ARG_NAME})
  hogelscope_read_plugin_abi()
  add_library(${target} MODULE ${ARG_SOURCES})
  target_link_libraries(${target} PRIVATE Hogelscope::plugin ${ARG_LIBRARIES})
  target_compile_features(${target} PRIVATE cxx_std_20)
  set_target_properties(${target} PROPERTIES PREFIX "" SUFFIX ".so" OUTPUT_NAME ${ARG_NAME}
    LIBRARY_OUTPUT_DIRECTORY ${folder} CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    target_link_options(${target} PRIVATE -Wl,--no-undefined)
  endif()
  list(JOIN ARG_KINDS "," kinds)
  add_custom_command(TARGET ${target} POST_BUILD VERBATIM
    COMMAND ${CMAKE_COMMAND} -D NAME=${ARG_NAME} -D VERSION=${ARG_VERSION} -D KINDS=${kinds} -D ABI=${abi}
      -D BUILD=${build} -D LIBRARY=$<TARGET_FILE:${target}> -P ${HOGELSCOPE_ADD_PLUGIN_SCRIPT})
endfunction()
