cmake_minimum_required(VERSION 3.25)
# No comment cites a document that is not here (DESI[G]N), and every section of docs/formulas.md that
# one cites is there: `docs/formulas.md`, comma, section, ended by a punctuation mark.
file(STRINGS ${SOURCE}/docs/formulas.md headings REGEX "^## ")
list(TRANSFORM headings REPLACE "^## " "")
file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE ${SOURCE}
  ${SOURCE}/src/* ${SOURCE}/tests/*.cpp ${SOURCE}/tests/*.h ${SOURCE}/tests/*.cmake
  ${SOURCE}/tests/*.py ${SOURCE}/tests/*.sh ${SOURCE}/tests/*.txt ${SOURCE}/*.md
  ${SOURCE}/docs/*.md ${SOURCE}/resources/manual/*.md)
list(FILTER files EXCLUDE REGEX "^(build|CHANGELOG)")
set(wrong "")
set(cited 0)
foreach(file IN LISTS files)
  file(READ ${SOURCE}/${file} text)
  if(text MATCHES "DESI[G]N")
    string(APPEND wrong "${file}: cites the design, which is not here\n")
  endif()
  string(REGEX REPLACE "\n *(///?|#)? *" " " text "${text}")  # a citation may go over two lines
  string(REGEX MATCHALL "docs/formulas\\.md, [^].,:;)\"]+" citations "${text}")
  foreach(citation IN LISTS citations)
    math(EXPR cited "${cited} + 1")
    string(REPLACE "docs/formulas.md, " "" section "${citation}")
    if(NOT section IN_LIST headings)
      string(APPEND wrong "${file}: docs/formulas.md has no section \"${section}\"\n")
    endif()
  endforeach()
endforeach()
if(wrong)
  message(FATAL_ERROR "${wrong}")
elseif(cited LESS 5)
  message(FATAL_ERROR "only ${cited} citations found: the check does not see the sources")
endif()
message(STATUS "${cited} citations of docs/formulas.md")
