# What cmake --install gives, beside the plugins, the SDK and the libraries, which say it where they
# are made. Components: program (jobs, samples), window (its program, what a desktop reads, the VTK
# module's library), libraries (that programs and Python load), dev (libraries, headers, CMake
# package), sdk (the part of it that plugins need), python.
set(HOGELSCOPE_APP io.github.hogelscope.Hogelscope)
set(desktop ${PROJECT_SOURCE_DIR}/resources/desktop)

install(TARGETS hogelscope RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(TARGETS hogelscope-window RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT window)
install(TARGETS hogelscope-codecs LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/hogelscope/lib
  COMPONENT libraries)
install(FILES ${desktop}/${HOGELSCOPE_APP}.desktop
  DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT window)
install(FILES ${desktop}/${HOGELSCOPE_APP}.metainfo.xml
  DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT window)
install(FILES ${desktop}/${HOGELSCOPE_APP}.svg
  DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT window)
install(FILES ${desktop}/${HOGELSCOPE_APP}.xml
  DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT window)
install(FILES data/scene.png data/room.glb
  DESTINATION ${CMAKE_INSTALL_DATADIR}/hogelscope/samples COMPONENT program)
foreach(sample table1 room arc as_built)
  install(FILES data/${sample}.json DESTINATION ${CMAKE_INSTALL_DATADIR}/hogelscope/samples
    RENAME ${sample}.hogelscope COMPONENT program)
endforeach()
file(GLOB displays CONFIGURE_DEPENDS data/displays/*.json)
list(FILTER displays EXCLUDE REGEX library.json)
foreach(display ${displays})
  cmake_path(GET display STEM name)
  install(FILES ${display} COMPONENT program
    DESTINATION ${CMAKE_INSTALL_DATADIR}/hogelscope/samples/displays RENAME ${name}.hogelscope)
endforeach()
install(FILES data/displays/library.json data/displays/README.md COMPONENT program
  DESTINATION ${CMAKE_INSTALL_DATADIR}/hogelscope/samples/displays)

# After the rules that install headers.
foreach(component dev sdk)
  install(CODE "set(HOGELSCOPE_HEADERS ${HOGELSCOPE_HEADERS})" COMPONENT ${component})
  install(SCRIPT ${CMAKE_CURRENT_LIST_DIR}/prefix_includes.cmake COMPONENT ${component})
endforeach()

# The program itself writes its man page and completion, so they cannot be out of date.
set(made ${CMAKE_CURRENT_BINARY_DIR}/share)
find_program(HOGELSCOPE_GZIP gzip REQUIRED)
file(MAKE_DIRECTORY ${made})
add_custom_command(OUTPUT ${made}/hogelscope.1.gz ${made}/hogelscope.bash DEPENDS hogelscope VERBATIM
  COMMAND $<TARGET_FILE:hogelscope> --help completion > ${made}/hogelscope.bash
  COMMAND $<TARGET_FILE:hogelscope> --help man > ${made}/hogelscope.1
  COMMAND ${HOGELSCOPE_GZIP} -9nf ${made}/hogelscope.1
  COMMAND ${CMAKE_COMMAND} -E create_symlink hogelscope.1.gz ${made}/hogelscope-window.1.gz)
add_custom_target(hogelscope_share ALL DEPENDS ${made}/hogelscope.1.gz ${made}/hogelscope.bash)
install(FILES ${made}/hogelscope.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${made}/hogelscope-window.1.gz
  DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT window)
install(FILES ${made}/hogelscope.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  RENAME hogelscope COMPONENT program)

# What has to be built before cmake --install and cpack: neither builds anything.
add_custom_target(hogelscope_wheel DEPENDS hogelscope-codecs)  # of pyproject.toml
foreach(target hogelscope_plugin_mesh hogelscope_plugin_measured-lens hogelscope_plugin_flip
    hogelscope_plugin_ms-ssim _hogelscope
    hogelscope_python)
  if(TARGET ${target})
    add_dependencies(hogelscope_wheel ${target})
  endif()
endforeach()
add_custom_target(hogelscope_installed DEPENDS hogelscope_wheel hogelscope hogelscope-window hogelscope_share
  hogelscope_core hogelscope_io ViewFilters)
if(TARGET hogelscope_vtkPython)
  add_dependencies(hogelscope_installed hogelscope_vtkPython)
endif()
