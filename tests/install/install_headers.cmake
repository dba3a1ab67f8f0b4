# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D BUILD=<build> -D SOURCE=<source> -D PREFIX=<new folder> -P install_headers.cmake
# Installs the core, and checks that every header came along, and nothing that names the folders it came from.

file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} --component core
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

file(GLOB_RECURSE headers RELATIVE ${SOURCE} ${SOURCE}/vcg_ext/*.h)
file(GLOB_RECURSE installed RELATIVE ${PREFIX}/include ${PREFIX}/include/*)
list(SORT headers)
list(SORT installed)
if(NOT headers STREQUAL installed)
  message(FATAL_ERROR "installed are\n${installed}\nand not\n${headers}")
endif()

file(GLOB_RECURSE package_files ${PREFIX}/share/*.cmake)
foreach(file IN LISTS package_files)
  file(STRINGS ${file} lines)
  foreach(folder IN ITEMS ${BUILD} ${SOURCE})
    string(FIND "${lines}" ${folder} place)
    if(NOT place EQUAL -1)
      message(FATAL_ERROR "${file} names ${folder}")
    endif()
  endforeach()
endforeach()
