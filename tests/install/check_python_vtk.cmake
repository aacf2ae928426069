cmake_minimum_required(VERSION 3.25)
# Runs vtk_view.py by Debian's Python with the installed module.
# Run as: cmake -D PREFIX=<prefix> -D MODULES=<Python's folder in it> -D PYTHON=<python3>
#   -P check_python_vtk.cmake
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
execute_process(COMMAND ${PYTHON} -c "import vtkmodules.vtkCommonCore, numpy" RESULT_VARIABLE status
  OUTPUT_QUIET ERROR_QUIET)
if(NOT status EQUAL 0)
  message("python3-vtk9 is not installed")
  return()
endif()
set(ENV{PYTHONPATH} ${PREFIX}/${MODULES})
run(${PYTHON} -B ${CMAKE_CURRENT_LIST_DIR}/vtk_view.py
  ${PREFIX}/share/hogelscope/samples/table1.hogelscope "Fig 4" "${PREFIX}/built/Fig 4.png")
message(STATUS "${out}")
