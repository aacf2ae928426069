# The 200 programs and libraries of a build are linked by mold or gold, where one is installed and the
# user names no other: ld takes two minutes of processor time for them, gold a tenth of that.
include(CheckLinkerFlag)
if(NOT CMAKE_EXE_LINKER_FLAGS MATCHES "-fuse-ld=")
  foreach(linker mold gold)
    check_linker_flag(CXX -fuse-ld=${linker} HOGELSCOPE_LINKS_WITH_${linker})
    if(HOGELSCOPE_LINKS_WITH_${linker})
      add_link_options(-fuse-ld=${linker})
      break()
    endif()
  endforeach()
endif()
