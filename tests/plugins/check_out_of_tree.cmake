cmake_minimum_required(VERSION 3.25)
# Checks the SDK as a stranger uses it: installs it, builds a copy of plugins/example with it, and asks the
# program for the result.
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
run(${CMAKE_COMMAND} -S ${work}/example -B ${work}/build -G ${GENERATOR}
  -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Release -D CMAKE_PREFIX_PATH=${work}/prefix)
run(${CMAKE_COMMAND} --build ${work}/build)
run(${PROGRAM} --plugins --plugins-path ${work}/build/plugins-1)
if(NOT out MATCHES "\nexample +1\\.0 +content +[^\n]*/tests/out_of_tree/build/plugins-1/example\n")
  message(FATAL_ERROR "the plugin that was built outside is not listed:\n${out}")
endif()
message(STATUS "${out}")
