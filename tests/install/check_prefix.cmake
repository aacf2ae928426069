cmake_minimum_required(VERSION 3.25)
# Installs into an empty prefix and checks that all is there, and works there: the program finds its
# plugins, and renders the installed sample.
# Run as: cmake -D SOURCE=<repository> -D BUILD=<build folder> -D PREFIX=<empty> -D LIBRARIES=lib
#   -P check_prefix.cmake
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
file(REMOVE_RECURSE ${PREFIX})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} --strip)  # as packages are
set(app io.github.hogelscope.Hogelscope)
set(missing "")
foreach(file bin/hogelscope bin/hogelscope-window ${LIBRARIES}/hogelscope/plugins-3/measured-lens/plugin.json
    ${LIBRARIES}/hogelscope/plugins-3/ms-ssim/ms-ssim.so ${LIBRARIES}/hogelscope/lib/libhogelscope_vtk.so
    ${LIBRARIES}/libhogelscope_core.a ${LIBRARIES}/libhogelscope_codecs.a ${LIBRARIES}/libhogelscope_io.a
    ${LIBRARIES}/cmake/Hogelscope/HogelscopeConfig.cmake include/hogelscope-1/hogelscope/plugin.h
    include/hogelscope-1/hogelscope/core/engine/renderer.h include/hogelscope-1/hogelscope/io/scene/view_source.h
    include/hogelscope-1/vtk/vtkHogelSessionView.h share/applications/${app}.desktop
    share/metainfo/${app}.metainfo.xml share/icons/hicolor/scalable/apps/${app}.svg
    share/mime/packages/${app}.xml share/man/man1/hogelscope.1.gz share/man/man1/hogelscope-window.1.gz
    share/bash-completion/completions/hogelscope share/hogelscope/samples/room.hogelscope)
  if(NOT EXISTS ${PREFIX}/${file})
    string(APPEND missing "  ${file}\n")
  endif()
endforeach()
if(missing)
  message(FATAL_ERROR "cmake --install does not give\n${missing}")
endif()
set(program ${PREFIX}/bin/hogelscope)
run(${program} --plugins)
if(NOT out MATCHES "\nms-ssim +[^\n]*tests/prefix/${LIBRARIES}/hogelscope/plugins-3/ms-ssim\n")
  message(FATAL_ERROR "the installed program does not find its plugins:\n${out}")
endif()
run(${program} --help man)
file(WRITE ${PREFIX}/man "${out}")
run(gzip -dc ${PREFIX}/share/man/man1/hogelscope.1.gz)
file(READ ${PREFIX}/man expected)
if(NOT out STREQUAL expected)
  message(FATAL_ERROR "the installed man page is not what the program says")
endif()
run(${program} --render --quiet --session ${PREFIX}/share/hogelscope/samples/table1.hogelscope
  --states "Fig 4" --output ${PREFIX}/installed)
run(${BUILD}/bin/hogelscope --render --quiet --session ${SOURCE}/data/table1.json
  --states "Fig 4" --output ${PREFIX}/built)
run(${CMAKE_COMMAND} -E compare_files "${PREFIX}/installed/Fig 4.png" "${PREFIX}/built/Fig 4.png")
run(${program} --render --quiet --session ${PREFIX}/share/hogelscope/samples/table1.hogelscope
  --states "Fig 4" --format tif --output ${PREFIX}/codecs)
execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=DISPLAY --unset=WAYLAND_DISPLAY ${program}
  ERROR_VARIABLE error RESULT_VARIABLE status)
if(NOT status EQUAL 2 OR NOT error MATCHES "there is no display server")
  message(FATAL_ERROR "the installed program does not become the window's: ${status}, ${error}")
endif()
# Each package is an installation of its own: jobs need nothing of the window's.
foreach(component program libraries)
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX}/jobs --component ${component})
endforeach()
file(GLOB_RECURSE files RELATIVE ${PREFIX}/jobs ${PREFIX}/jobs/*)
if(files MATCHES "hogelscope-window|libhogelscope_vtk|share/(applications|icons|metainfo|mime)")
  message(FATAL_ERROR "the package of jobs has the window's ${CMAKE_MATCH_0}")
endif()
run(${PREFIX}/jobs/bin/hogelscope --render --quiet --session ${PREFIX}/jobs/share/hogelscope/samples/table1.hogelscope
  --states "Fig 4" --output ${PREFIX}/jobs/views)
run(${CMAKE_COMMAND} -E compare_files "${PREFIX}/jobs/views/Fig 4.png" "${PREFIX}/built/Fig 4.png")
execute_process(COMMAND ${PREFIX}/jobs/bin/hogelscope ${SOURCE}/data/table1.json ERROR_VARIABLE error RESULT_VARIABLE status)
if(NOT status EQUAL 2 OR NOT error MATCHES "^hogelscope: [^\n]*/hogelscope-window: [^\n]*package hogelscope-window[^\n]*\n$")
  message(FATAL_ERROR "without the window the program does not name its package: ${status}, ${error}")
endif()
