cmake_minimum_required(VERSION 3.25)
# Builds programs with an installed Hogelscope, by what its package says alone: tests/install/consumer,
# and the program of the manual's page "From C++". Runs them and compares their pictures.
# Run as: cmake -D SOURCE=<repository> -D WORK=<folder> -D PREFIX=<prefix> -D COMPILER=<c++>
#   -D GENERATOR=<CMake's> -P check_consumer.cmake
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
file(REMOVE_RECURSE ${WORK})
file(COPY ${SOURCE}/tests/install/consumer DESTINATION ${WORK})
write_block(${SOURCE}/resources/manual/cpp.md cmake ${WORK}/waves/CMakeLists.txt)
write_block(${SOURCE}/resources/manual/cpp.md cpp ${WORK}/waves/waves.cpp)
foreach(name consumer waves)
  run(${CMAKE_COMMAND} -S ${WORK}/${name} -B ${WORK}/${name}/build -G ${GENERATOR}
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Release -D CMAKE_PREFIX_PATH=${PREFIX})
  run(${CMAKE_COMMAND} --build ${WORK}/${name}/build)
endforeach()

set(session ${PREFIX}/share/hogelscope/samples/table1.hogelscope)
run(${WORK}/consumer/build/consumer ${session} "Fig 4" ${WORK}/picture.png)
run(${PREFIX}/bin/hogelscope --render --quiet --session ${session} --states "Fig 4"
  --output ${WORK}/rendered)
run(${CMAKE_COMMAND} -E compare_files ${WORK}/picture.png "${WORK}/rendered/Fig 4.png")

run(${CMAKE_COMMAND} -E chdir ${WORK} ${WORK}/waves/build/waves)
run(idiff ${SOURCE}/tests/install/waves.png ${WORK}/waves.png)
