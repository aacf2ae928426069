# Run by cmake --install after all headers are there: sources include "core/…" and "io/…", which other
# projects have, too, so installed headers include each other as "hogelscope/core/…".
file(GLOB_RECURSE headers "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/${HOGELSCOPE_HEADERS}/*.h")
foreach(header IN LISTS headers)
  file(READ "${header}" text)
  string(REGEX REPLACE "#include \"(capture|core|io)/" "#include \"hogelscope/\\1/" prefixed "${text}")
  string(REPLACE "#include \"sdk/hogelscope/" "#include \"hogelscope/" prefixed "${prefixed}")
  if(NOT prefixed STREQUAL text)
    file(WRITE "${header}" "${prefixed}")
  endif()
endforeach()
