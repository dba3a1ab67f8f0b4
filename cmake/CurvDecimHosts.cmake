# SPDX-License-Identifier: GPL-3.0-or-later
# Reads hosts.txt. For each host: CURVDECIM_API_<host>, CURVDECIM_SCALAR_<host>, CURVDECIM_SUITES_<host>.
#   CURVDECIM_ALL_HOSTS       in the order of the list
#   CURVDECIM_PYMESHLAB_HOST  the one that the Python package is for

file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/hosts.txt lines REGEX "^[^#]")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/hosts.txt)

set(CURVDECIM_ALL_HOSTS "")
foreach(line IN LISTS lines)
  string(REGEX MATCHALL "[^ ]+" suites "${line}")
  list(POP_FRONT suites host api scalar)
  list(APPEND CURVDECIM_ALL_HOSTS ${host})
  set(CURVDECIM_API_${host} ${api})
  set(CURVDECIM_SCALAR_${host} ${scalar})
  set(CURVDECIM_SUITES_${host} ${suites})
  if(host MATCHES "^pymeshlab-")
    set(CURVDECIM_PYMESHLAB_HOST ${host})
  endif()
endforeach()
