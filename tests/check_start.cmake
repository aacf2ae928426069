cmake_minimum_required(VERSION 3.25)
# A job loads what it uses: the program starts without VTK, Qt's widgets, OpenImageIO and OpenCV's
# codecs, a picture and a report made of PNGs need none of them, and one of a JPEG loads the codecs.
# The window starts without the codecs.
function(loaded_by output)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env LD_DEBUG=files ${PROGRAM} ${ARGN}
    OUTPUT_QUIET ERROR_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "calling init: [^\n]+" libraries "${text}")
  set(${output} "${libraries}" PARENT_SCOPE)
endfunction()
set(codecs "libOpenImageIO|libavformat|libopencv_imgcodecs|libgdal")
set(heavy "libvtk|libQt6Widgets|${codecs}")
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
loaded_by(version --version)
if(NOT version MATCHES "libtbb")
  message(FATAL_ERROR "LD_DEBUG does not tell what is loaded: ${version}")
endif()
set(render --render --session ${SOURCE}/data/table1.json --states "Fig 1" --quiet
  --set camera.res=[20,20])
loaded_by(png ${render} --output ${WORK}/png)
loaded_by(report --report --session ${SOURCE}/data/table1.json --test ${SOURCE}/data/scene.png
  --states "Fig 1" --quiet --set camera.res=[20,20] --output ${WORK}/report)
foreach(libraries "${version}" "${png}" "${report}")
  if(libraries MATCHES "${heavy}")
    message(FATAL_ERROR "${PROGRAM} loads ${CMAKE_MATCH_0}")
  endif()
endforeach()
execute_process(COMMAND ${PROGRAM} --generate scene --session ${SOURCE}/data/table1.json --quiet
  --set display.hogels=[16,16] --output ${WORK}/scene.jpg COMMAND_ERROR_IS_FATAL ANY)
loaded_by(jpeg ${render} --output ${WORK}/jpeg --set lightField.file=${WORK}/scene.jpg
  --set display.hogels=[16,16])
if(NOT jpeg MATCHES "libOpenImageIO")
  message(FATAL_ERROR "a JPEG was read without OpenImageIO")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E env LD_TRACE_LOADED_OBJECTS=1 ${WINDOW}
  OUTPUT_VARIABLE window COMMAND_ERROR_IS_FATAL ANY)
if(NOT window MATCHES "libvtk")
  message(FATAL_ERROR "the dynamic linker does not tell what is loaded: ${window}")
endif()
if(window MATCHES "${codecs}")
  message(FATAL_ERROR "${WINDOW} loads ${CMAKE_MATCH_0}")
endif()
