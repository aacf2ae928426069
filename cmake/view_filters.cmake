# The VTK module Hogelscope::ViewFilters, a shared library, and its Python module.
vtk_module_scan(MODULE_FILES ${CMAKE_CURRENT_SOURCE_DIR}/vtk/vtk.module
  PROVIDES_MODULES hogelscope_modules
  REQUIRES_MODULES required_modules
  REQUEST_MODULES Hogelscope::ViewFilters
  ENABLE_TESTS OFF)
set(BUILD_SHARED_LIBS ON)
vtk_module_build(MODULES ${hogelscope_modules} PACKAGE Hogelscope INSTALL_EXPORT Hogelscope
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  ENABLE_WRAPPING ${HOGELSCOPE_PYTHON_VTK}
  LIBRARY_DESTINATION ${CMAKE_INSTALL_LIBDIR}/hogelscope/lib CMAKE_DESTINATION ${HOGELSCOPE_CMAKE}
  HEADERS_DESTINATION ${HOGELSCOPE_HEADERS}/vtk
  HIERARCHY_DESTINATION ${CMAKE_INSTALL_LIBDIR}/vtk/hierarchy/Hogelscope
  HEADERS_COMPONENT dev TARGETS_COMPONENT program)
if(HOGELSCOPE_PYTHON_VTK)
  vtk_module_wrap_python(MODULES ${hogelscope_modules} TARGET Hogelscope::Python
    PYTHON_PACKAGE hogelscope_vtk MODULE_DESTINATION ${HOGELSCOPE_PYTHON_MODULES}
    INSTALL_HEADERS OFF BUILD_STATIC OFF COMPONENT python)
  # A private folder, found from wherever all of it is installed.
  file(RELATIVE_PATH libraries /${HOGELSCOPE_PYTHON_MODULES}/hogelscope_vtk
    /${CMAKE_INSTALL_LIBDIR}/hogelscope/lib)
  set_target_properties(hogelscope_vtkPython PROPERTIES INSTALL_RPATH "\$ORIGIN/${libraries}")
  file(WRITE ${CMAKE_BINARY_DIR}/${HOGELSCOPE_PYTHON_MODULES}/hogelscope_vtk/__init__.py
    "from .hogelscope_vtk import *  # noqa: F403\n")
  install(FILES ${CMAKE_BINARY_DIR}/${HOGELSCOPE_PYTHON_MODULES}/hogelscope_vtk/__init__.py
    DESTINATION ${HOGELSCOPE_PYTHON_MODULES}/hogelscope_vtk COMPONENT python)
endif()
unset(BUILD_SHARED_LIBS)
