# SPDX-License-Identifier: GPL-3.0-or-later
# For pip in a repository that is built already: the build is brought up to date, and the Python package takes the
# plugin from it instead of compiling it once more.
#   CURVDECIM_BUILD   environment: the build directory, default build/ of the repository
# Sets CURVDECIM_BUILT to the directory, or to "" where it does not build the plugin for PyMeshLab from these sources.

set(CURVDECIM_BUILT "$ENV{CURVDECIM_BUILD}")
if(NOT CURVDECIM_BUILT)
  set(CURVDECIM_BUILT ${PROJECT_SOURCE_DIR}/build)
endif()
set(plugin_folder ${CURVDECIM_BUILT}/plugins/${CURVDECIM_PYMESHLAB_HOST})
set(ours "")
if(EXISTS ${CURVDECIM_BUILT}/CMakeCache.txt AND EXISTS ${plugin_folder}/libfilter_curvdecim.so)
  file(STRINGS ${CURVDECIM_BUILT}/CMakeCache.txt ours
       REGEX "^CMAKE_HOME_DIRECTORY:INTERNAL=${PROJECT_SOURCE_DIR}$")
endif()
if(NOT ours)
  set(CURVDECIM_BUILT "")
  return()
endif()

message(STATUS "CurvDecim for ${CURVDECIM_PYMESHLAB_HOST}: from ${CURVDECIM_BUILT}")
add_custom_target(plugin-${CURVDECIM_PYMESHLAB_HOST}
  COMMAND ${CMAKE_COMMAND} --build ${CURVDECIM_BUILT} --target plugin-${CURVDECIM_PYMESHLAB_HOST}
  VERBATIM)
install(PROGRAMS ${plugin_folder}/libfilter_curvdecim.so DESTINATION pymeshlab_curvdecim COMPONENT python)
install(FILES ${plugin_folder}/parameters.json DESTINATION pymeshlab_curvdecim COMPONENT python)
