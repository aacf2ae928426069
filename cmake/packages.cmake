# Debian packages by CPack (packaging/deb.sh): hogelscope, hogelscope-window, libhogelscope-dev and,
# where there is something for Python, python3-hogelscope. The window is a package of its own since
# it alone needs VTK: 29 packages in Debian 12, a third of the disk in Debian 13. The revision sorts
# before those that Debian would give.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME hogelscope)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGE_CONTACT "The Hogelscope authors <hogelscope@example.org>")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
  GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
# Of each package: its name, and the install components in it.
set(hogelscope_packages "program:hogelscope:program,libraries" "window:hogelscope-window:window"
  "dev:libhogelscope-dev:dev,sdk")
if(HOGELSCOPE_PYTHON_VTK OR TARGET _hogelscope)
  list(APPEND hogelscope_packages "python:python3-hogelscope:python")
endif()
set(documents ${CMAKE_BINARY_DIR}/debian)
configure_file(${PROJECT_SOURCE_DIR}/packaging/debian/changelog.in ${documents}/changelog.Debian
  @ONLY)
execute_process(COMMAND ${HOGELSCOPE_GZIP} -9nf ${documents}/changelog.Debian
  COMMAND_ERROR_IS_FATAL ANY)
set(CPACK_COMPONENTS_ALL "")
foreach(package IN LISTS hogelscope_packages)
  string(REPLACE ":" ";" package ${package})
  list(POP_FRONT package group name components)
  install(FILES ${documents}/changelog.Debian.gz ${PROJECT_SOURCE_DIR}/packaging/debian/copyright
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${group}-documents EXCLUDE_FROM_ALL)
  string(REPLACE "," ";" components ${components})
  foreach(component IN LISTS components ITEMS ${group}-documents)
    string(TOUPPER ${component} upper)
    set(CPACK_COMPONENT_${upper}_GROUP ${group})
    list(APPEND CPACK_COMPONENTS_ALL ${component})
  endforeach()
endforeach()

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Of the VTK module.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR}/lib/hogelscope/lib)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_RELEASE 0hogelscope1)

set(this_version "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
set(same_program "hogelscope ${this_version}")
set(same_window "hogelscope-window ${this_version}")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME hogelscope)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "${same_window}")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS ffmpeg)  # videos of animations
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "simulated viewing of light field displays
Hogelscope shows what a viewer, or a camera with a real lens, would see in
front of a light field display that does not exist yet. It takes the content
and geometry of the display, a camera with its lens distortion, and the light
leakage of the display, gives the picture that the camera would take, and
compares such pictures over many camera positions.

This package has the program for batch jobs, its plugins and sample sessions.
The window is in the package hogelscope-window.")

set(CPACK_DEBIAN_WINDOW_PACKAGE_NAME hogelscope-window)
set(CPACK_DEBIAN_WINDOW_PACKAGE_SECTION science)
set(CPACK_DEBIAN_WINDOW_PACKAGE_DEPENDS "${same_program}")
set(CPACK_DEBIAN_WINDOW_PACKAGE_RECOMMENDS "libgl1-mesa-dri, qt6-qpa-plugins")
# hogelscope 0.1 had the window's files.
set(CPACK_DEBIAN_WINDOW_PACKAGE_BREAKS "hogelscope (<< 0.2.0)")
set(CPACK_DEBIAN_WINDOW_PACKAGE_REPLACES "hogelscope (<< 0.2.0)")
set(CPACK_DEBIAN_WINDOW_DESCRIPTION "simulated viewing of light field displays - window
The desktop application of Hogelscope: the simulated view beside a 3-D scene of
the display and its cameras, reports, measures and comparisons.

This package has the window, its desktop entry, and the library of the VTK
module, which programs in C++ and Python use too.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libhogelscope-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS OFF)
string(CONCAT CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "${same_program}, ${same_window}, libavcodec-dev, libavformat-dev, "
 "libavutil-dev, libhdf5-dev, libopencv-dev, libopenexr-dev, libopenimageio-dev, libspng-dev, libswscale-dev, libtbb-dev, libvtk9-dev, libxxhash-dev, libyaml-dev, libzstd-dev, "
 "nlohmann-json3-dev, openimageio-tools, pkgconf")
set(CPACK_DEBIAN_DEV_DESCRIPTION "simulated viewing of light field displays - development files
Headers, static libraries and the CMake package of Hogelscope: the renderer,
the readers of light fields and sessions, the VTK module, and the SDK for
plugins.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-hogelscope)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
string(CONCAT CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${same_program}, ${same_window}, "
 "python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}), "
 "python3 (<< ${Python3_VERSION_MAJOR}.${next_minor}), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-vtk9")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/debian/python/postinst
  ${PROJECT_SOURCE_DIR}/packaging/debian/python/prerm)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "simulated viewing of light field displays - Python module
Renders and compares simulated views of light fields that are numpy arrays,
files, or stores larger than memory.")

include(CPack)
