# The VTK module Hogelscope::ViewFilters, a shared library, and its Python module; then the same
# filters and the 3-D scene for the programs.
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
  HEADERS_COMPONENT dev TARGETS_COMPONENT window)
if(HOGELSCOPE_PYTHON_VTK)
  vtk_module_wrap_python(MODULES ${hogelscope_modules} TARGET Hogelscope::Python
    PYTHON_PACKAGE hogelscope_vtk MODULE_DESTINATION ${HOGELSCOPE_PYTHON_MODULES}
    INSTALL_HEADERS OFF BUILD_STATIC OFF COMPONENT python)
  # A private folder, found from wherever all of it is installed.
  file(RELATIVE_PATH libraries /${HOGELSCOPE_PYTHON_MODULES}/hogelscope_vtk
    /${CMAKE_INSTALL_LIBDIR}/hogelscope/lib)
  target_compile_options(hogelscope_vtkPython PRIVATE -w)  # VTK writes its code
  set_target_properties(hogelscope_vtkPython PROPERTIES INSTALL_RPATH "\$ORIGIN/${libraries}")
  file(WRITE ${CMAKE_BINARY_DIR}/${HOGELSCOPE_PYTHON_MODULES}/hogelscope_vtk/__init__.py
    "from .hogelscope_vtk import *  # noqa: F403\n")
  install(FILES ${CMAKE_BINARY_DIR}/${HOGELSCOPE_PYTHON_MODULES}/hogelscope_vtk/__init__.py
    DESTINATION ${HOGELSCOPE_PYTHON_MODULES}/hogelscope_vtk COMPONENT python)
endif()
unset(BUILD_SHARED_LIBS)

# Without an export macro, since they are static.
add_library(hogelscope_views STATIC
  vtk/line_picker.cxx
  vtk/vtkCameraFrustumSource.cxx
  vtk/vtkHogelDisplaySource.cxx
  vtk/vtkHogelFieldSource.cxx
  vtk/vtkHogelViewFilter.cxx)
target_include_directories(hogelscope_views PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/vtk
  ${CMAKE_CURRENT_BINARY_DIR}/vtk)
target_compile_definitions(hogelscope_views PUBLIC HOGELSCOPE_VTK_STATIC_DEFINE)
foreach(target ViewFilters hogelscope_views)  # VTK's macros for errors name the file
  target_compile_options(${target} PRIVATE -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/= -Wno-pedantic)
endforeach()
target_link_libraries(hogelscope_views PUBLIC hogelscope_core VTK::CommonCore VTK::CommonDataModel
  VTK::CommonExecutionModel VTK::CommonMath)

# The data of the 3-D scene and its export, which need more of VTK.
add_library(hogelscope_scene STATIC vtk/scene_data.cxx vtk/scene_export.cxx vtk/state_atlas.cxx)
target_link_libraries(hogelscope_scene PUBLIC hogelscope_views hogelscope_io VTK::RenderingCore
  PRIVATE VTK::FiltersCore VTK::FiltersSources VTK::IOExport VTK::IOXML VTK::RenderingOpenGL2)
target_compile_options(hogelscope_scene PRIVATE -Wno-pedantic)  # vtkTypeMacro(…);
vtk_module_autoinit(TARGETS hogelscope_scene MODULES VTK::RenderingOpenGL2)
