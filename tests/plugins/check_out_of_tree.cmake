cmake_minimum_required(VERSION 3.25)
# Checks the SDK as a stranger uses it: installs it, builds a copy of plugins/example with it and the plugin
# of the manual's tutorial, and asks the program for the results, the tutorial's picture among them.
# Run as: cmake -D SOURCE=<repository> -D BUILD=<build folder> -D COMPILER=<c++> -D GENERATOR=<CMake's>
#   -D PROGRAM=<hogelscope> -P check_out_of_tree.cmake

set(work ${BUILD}/tests/out_of_tree)
file(REMOVE_RECURSE ${work})
file(COPY ${SOURCE}/plugins/example DESTINATION ${work})

function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE out ERROR_VARIABLE out RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " line)
    message(FATAL_ERROR "${line}\n${out}")
  endif()
  set(out "${out}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --component sdk --prefix ${work}/prefix)
file(GLOB_RECURSE installed RELATIVE ${work}/prefix ${work}/prefix/*)
list(LENGTH installed count)
if(NOT count EQUAL 6)  # three headers, three files of CMake
  message(FATAL_ERROR "the component sdk has other files than it should: ${installed}")
endif()
# The tutorial's blocks of code: ```cmake, ```cpp, ```json.
file(READ ${SOURCE}/resources/manual/plugins.md manual)
foreach(block cmake:stripes/CMakeLists.txt cpp:stripes/stripes.cpp json:stripes.json)
  string(REGEX REPLACE ":.*" "" kind ${block})
  string(REGEX REPLACE ".*:" "" file ${block})
  if(NOT manual MATCHES "```${kind}\n([^`]*)```")
    message(FATAL_ERROR "resources/manual/plugins.md has no block of ${kind}")
  endif()
  file(WRITE ${work}/${file} "${CMAKE_MATCH_1}")
endforeach()

foreach(name example stripes)
  run(${CMAKE_COMMAND} -S ${work}/${name} -B ${work}/${name}/build -G ${GENERATOR}
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_PREFIX_PATH=${work}/prefix)
  run(${CMAKE_COMMAND} --build ${work}/${name}/build)
  run(${PROGRAM} --plugins --plugins-path ${work}/${name}/build/plugins-1)
  if(NOT out MATCHES "\n${name} +1\\.0 +content +[^\n]*/out_of_tree/${name}/build/plugins-1/${name}\n")
    message(FATAL_ERROR "the plugin that was built outside is not listed:\n${out}")
  endif()
endforeach()

run(${PROGRAM} --render --session ${work}/stripes.json --output ${work}/out
  --plugins-path ${work}/stripes/build/plugins-1)
run(${PROGRAM} --info ${work}/out/front.png)
if(NOT out MATCHES "400×400 px")
  message(FATAL_ERROR "the tutorial's picture is not there:\n${out}")
endif()
