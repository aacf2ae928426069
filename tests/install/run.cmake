# run(COMMAND ...): fails with the command's output; else `out` is that output.
function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE out ERROR_VARIABLE out RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " line)
    message(FATAL_ERROR "${line}\n${out}")
  endif()
  set(out "${out}" PARENT_SCOPE)
endfunction()

# write_block(PAGE KIND FILE): writes a manual's first block of code of a kind (cmake, cpp, json).
function(write_block page kind file)
  file(READ ${page} text)
  if(NOT text MATCHES "```${kind}\n([^`]*)```")
    message(FATAL_ERROR "${page} has no block of ${kind}")
  endif()
  file(WRITE ${file} "${CMAKE_MATCH_1}")
endfunction()
