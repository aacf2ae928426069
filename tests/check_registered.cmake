cmake_minimum_required(VERSION 3.25)
# Checks that every tests/FOLDER/test_NAME.cpp or .py is built and run: lists by hand can forget one.
# Run as: cmake -D TESTS=<folder> -D REGISTERED=core/test_a.cpp,io/test_b.cpp -P check_registered.cmake

string(REPLACE "," ";" registered "${REGISTERED}")
file(GLOB_RECURSE files RELATIVE ${TESTS} ${TESTS}/*/test_*.cpp ${TESTS}/*/test_*.py)
list(LENGTH files count)
if(count LESS 50)
  message(FATAL_ERROR "only ${count} tests found under ${TESTS}")
endif()
list(REMOVE_ITEM files ${registered})
if(files)
  list(JOIN files "\n  " text)
  message(FATAL_ERROR "tests that no CMakeLists.txt registers:\n  ${text}")
endif()
message(STATUS "${count} tests are registered")
