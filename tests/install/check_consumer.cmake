cmake_minimum_required(VERSION 3.25)
# Builds tests/install/consumer and plugins/example against the installed prefix, runs the first and
# lists the second.
# Run as: cmake -D SOURCE=<repository> -D BUILD=<build folder> -D PREFIX=<prefix> -D COMPILER=<c++>
#   -D GENERATOR=<CMake's> -P check_consumer.cmake
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
set(work ${BUILD}/tests/consumer)
file(REMOVE_RECURSE ${work})
file(COPY ${SOURCE}/tests/install/consumer ${SOURCE}/plugins/example DESTINATION ${work})
foreach(name consumer example)
  run(${CMAKE_COMMAND} -S ${work}/${name} -B ${work}/${name}/build -G ${GENERATOR}
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Release -D CMAKE_PREFIX_PATH=${PREFIX})
  run(${CMAKE_COMMAND} --build ${work}/${name}/build)
endforeach()
run(${work}/consumer/build/consumer ${PREFIX}/share/hogelscope/samples/table1.hogelscope "Fig 4"
  ${work}/picture.png)
run(${CMAKE_COMMAND} -E compare_files ${work}/picture.png "${PREFIX}/built/Fig 4.png")
run(${PREFIX}/bin/hogelscope --plugins --plugins-path ${work}/example/build/plugins-1)
if(NOT out MATCHES "\nexample +1\\.0 +content ")
  message(FATAL_ERROR "the plugin that was built outside is not listed:\n${out}")
endif()
