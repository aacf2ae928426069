cmake_minimum_required(VERSION 3.25)
# Checks the SDK as a stranger uses it: builds a copy of plugins/example with it and the plugin of the
# manual's tutorial, and asks the program for the results, the tutorial's picture among them.
# Run as: cmake -D SOURCE=<repository> -D WORK=<folder> -D COMPILER=<c++> -D GENERATOR=<CMake's>
#   -D PROGRAM=<hogelscope> (-D BUILD=<build folder, whose SDK is installed first> | -D PREFIX=<where it is>)
#   -P check_out_of_tree.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../install/run.cmake)

file(REMOVE_RECURSE ${WORK})
file(COPY ${SOURCE}/plugins/example DESTINATION ${WORK})
if(NOT PREFIX)
  set(PREFIX ${WORK}/prefix)
  run(${CMAKE_COMMAND} --install ${BUILD} --component sdk --prefix ${PREFIX})
  file(GLOB_RECURSE installed RELATIVE ${PREFIX} ${PREFIX}/*)
  list(LENGTH installed count)
  if(NOT count EQUAL 6)  # three headers, three files of CMake
    message(FATAL_ERROR "the component sdk has other files than it should: ${installed}")
  endif()
endif()
set(tutorial ${SOURCE}/resources/manual/plugins.md)
write_block(${tutorial} cmake ${WORK}/stripes/CMakeLists.txt)
write_block(${tutorial} cpp ${WORK}/stripes/stripes.cpp)
write_block(${tutorial} json ${WORK}/stripes.json)

foreach(name example stripes)
  run(${CMAKE_COMMAND} -S ${WORK}/${name} -B ${WORK}/${name}/build -G ${GENERATOR}
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_PREFIX_PATH=${PREFIX})
  run(${CMAKE_COMMAND} --build ${WORK}/${name}/build)
  run(${PROGRAM} --plugins --plugins-path ${WORK}/${name}/build/plugins-3)
  if(NOT out MATCHES "\n${name} +1\\.0 +content +[^\n]*/${name}/build/plugins-3/${name}\n")
    message(FATAL_ERROR "the plugin that was built outside is not listed:\n${out}")
  endif()
endforeach()

run(${PROGRAM} --render --session ${WORK}/stripes.json --output ${WORK}/out
  --plugins-path ${WORK}/stripes/build/plugins-3)
run(${PROGRAM} --info ${WORK}/out/front.png)
if(NOT out MATCHES "400×400 px")
  message(FATAL_ERROR "the tutorial's picture is not there:\n${out}")
endif()
