# The engine in a web page: the core, unchanged, and src/web/engine as WebAssembly, by clang 19 and
# wasi-libc, which both Debian 12 and 13 have. It is embedded in the program (src/web/page_engine.cpp).
# HOGELSCOPE_WEB is AUTO (if there is the toolchain), ON or OFF.
function(hogelscope_add_web_engine)
  set(HOGELSCOPE_WEB AUTO CACHE STRING "Build the engine for web pages: AUTO, ON or OFF")
  set(HOGELSCOPE_WEB_ENGINE "" CACHE INTERNAL "The engine for web pages")
  if(HOGELSCOPE_WEB STREQUAL "OFF" OR HOGELSCOPE_FUZZ)
    return()
  endif()

  find_program(HOGELSCOPE_WEB_COMPILER clang++-19)
  set(wasm ${HOGELSCOPE_WEB_COMPILER} --target=wasm32-wasi -stdlib=libc++)
  if(HOGELSCOPE_WEB_COMPILER)
    file(WRITE ${CMAKE_BINARY_DIR}/web/try.cpp "#include <vector>\nint main() { return std::vector<int>(1)[0]; }\n")
    execute_process(COMMAND ${wasm} -fno-exceptions ${CMAKE_BINARY_DIR}/web/try.cpp -o ${CMAKE_BINARY_DIR}/web/try.wasm
      RESULT_VARIABLE HOGELSCOPE_WEB_FAILED OUTPUT_QUIET ERROR_QUIET)
  endif()
  if(NOT HOGELSCOPE_WEB_COMPILER OR NOT HOGELSCOPE_WEB_FAILED EQUAL 0)
    if(HOGELSCOPE_WEB STREQUAL "ON")
      message(FATAL_ERROR "HOGELSCOPE_WEB needs clang-19 lld-19 libc++-19-dev-wasm32 "
        "libc++abi-19-dev-wasm32 libclang-rt-19-dev-wasm32 wasi-libc")
    endif()
    message(STATUS "The engine for web pages is left out: there is no clang 19 for WebAssembly")
    return()
  endif()

  # Sources of the rooms of core that make views, and options that the native library gives them.
  get_target_property(sources hogelscope_core SOURCES)
  list(FILTER sources INCLUDE REGEX "^core/(base|light_field|panel|optics|lens|engine)/")
  list(REMOVE_ITEM sources core/base/parallel.cpp)
  list(APPEND sources core/metrics/error_map.cpp core/metrics/squared_error.cpp web/engine/serial.cpp web/engine/thrown.cpp web/engine/engine.cpp)
  set(options -std=c++20 -O3 -DNDEBUG -msimd128 -mbulk-memory -mnontrapping-fptoint -ffp-contract=off
    -fexceptions -fignore-exceptions -fvisibility=hidden -Wno-parentheses
    -include ${CMAKE_CURRENT_SOURCE_DIR}/web/engine/no_threads.h -I${CMAKE_CURRENT_SOURCE_DIR})
  # One file for the sources of a room that have the same options: most of the compiler's time goes
  # into the standard library's headers.
  set(batches "")
  foreach(source IN LISTS sources)
    get_source_file_property(own ${source} COMPILE_OPTIONS)
    if(NOT own)
      set(own "")
    endif()
    get_source_file_property(definitions ${source} COMPILE_DEFINITIONS)
    if(definitions)
      list(APPEND own -D${definitions})
    endif()
    get_filename_component(room ${source} DIRECTORY)
    string(SHA1 batch "${room} ${own}")
    list(APPEND batches ${batch})
    set(options_${batch} ${own})
    string(APPEND text_${batch} "#include \"${source}\"\n")
  endforeach()
  list(REMOVE_DUPLICATES batches)
  set(objects "")
  foreach(batch IN LISTS batches)
    set(file ${CMAKE_BINARY_DIR}/web/${batch})
    file(CONFIGURE OUTPUT ${file}.cpp CONTENT "${text_${batch}}" @ONLY)
    add_custom_command(OUTPUT ${file}.o
      COMMAND ${wasm} ${options} ${options_${batch}} -MD -MT ${file}.o -MF ${file}.o.d
        -c ${file}.cpp -o ${file}.o
      DEPENDS ${file}.cpp ${CMAKE_CURRENT_SOURCE_DIR}/web/engine/no_threads.h
      DEPFILE ${file}.o.d COMMENT "Building a part of the engine for web pages" VERBATIM)
    list(APPEND objects ${file}.o)
  endforeach()

  set(functions hs_version hs_alloc hs_free hs_field hs_view_row hs_hash hs_reset hs_set hs_fields
    hs_render hs_compare hs_panel hs_picture hs_mask hs_width hs_why hs_focus)
  list(TRANSFORM functions PREPEND -Wl,--export=)
  set(HOGELSCOPE_WEB_ENGINE ${CMAKE_BINARY_DIR}/web/engine.wasm.gz CACHE INTERNAL "The engine for web pages")
  # Without -O, which would run wasm-opt where it is installed: the bytes would depend on that.
  add_custom_command(OUTPUT ${HOGELSCOPE_WEB_ENGINE}
    COMMAND ${wasm} -mexec-model=reactor ${objects} ${functions} -Wl,--strip-all
      -Wl,-z,stack-size=1048576 -Wl,--max-memory=4294967296 -lc++abi -o ${CMAKE_BINARY_DIR}/web/engine.wasm
    COMMAND gzip -9nfk ${CMAKE_BINARY_DIR}/web/engine.wasm
    DEPENDS ${objects} COMMENT "Linking the engine for web pages" VERBATIM)
endfunction()
