# SPDX-License-Identifier: GPL-3.0-or-later
# curvdecim_add_plugin(<target> HOST <host of hosts.txt>)
#
# Builds plugins/<host>/libfilter_curvdecim.so for one host. A plugin fits one host only: the scalar
# type, the version and the plugin interface are compiled in and checked by the host at load.
# When something is missing the host is left out with a status line, or, when the host is listed in
# CURVDECIM_REQUIRED_HOSTS, configuring fails with the same line.

set(CURVDECIM_PYMESHLAB_DIR "" CACHE PATH
    "Directory of the installed pymeshlab package; found through Python when empty")

find_package(Qt5 COMPONENTS Core Gui Widgets Xml OpenGL QUIET)
find_path(CURVDECIM_GLEW_INCLUDE_DIR GL/glew.h)  # MeshLab's mesh_model.h includes it

# Directory of the installed pymeshlab package, or "": the project's own venv, then the default Python.
function(_curvdecim_find_pymeshlab out)
  if(CURVDECIM_PYMESHLAB_DIR)
    set(${out} ${CURVDECIM_PYMESHLAB_DIR} PARENT_SCOPE)
    return()
  endif()
  if(NOT Python3_EXECUTABLE AND EXISTS ${PROJECT_SOURCE_DIR}/build/venv/bin/python)
    set(Python3_EXECUTABLE ${PROJECT_SOURCE_DIR}/build/venv/bin/python)
  endif()
  find_package(Python3 COMPONENTS Interpreter QUIET)
  execute_process(
    COMMAND ${Python3_EXECUTABLE} -c
            "import importlib.util as u; s = u.find_spec('pymeshlab'); print(s.submodule_search_locations[0] if s else '', end='')"
    OUTPUT_VARIABLE directory ERROR_QUIET)
  set(${out} "${directory}" PARENT_SCOPE)
endfunction()

# The libmeshlab-common of the host on this machine, or "" (its symbols then come from the host at load).
function(_curvdecim_find_meshlab_library program version out)
  if(program STREQUAL "pymeshlab")
    _curvdecim_find_pymeshlab(directory)
    set(directories ${directory}/lib)
  else()
    set(directories /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/meshlab /usr/lib/meshlab)
  endif()
  set(${out} "" PARENT_SCOPE)
  foreach(directory IN LISTS directories)
    set(library ${directory}/libmeshlab-common.so)
    if(EXISTS ${library})
      file(STRINGS ${library} version_text REGEX "^${version}" LIMIT_COUNT 1)
      if(version_text)
        set(${out} ${library} PARENT_SCOPE)
      endif()
    endif()
  endforeach()
endfunction()

function(_curvdecim_leave_out host reason)
  if(host IN_LIST CURVDECIM_REQUIRED_HOSTS)
    message(FATAL_ERROR "CurvDecim for ${host}: cannot be built, ${reason}")
  endif()
  message(STATUS "CurvDecim for ${host}: left out, ${reason}")
endfunction()

# What stops the plugin from being built for this host, or "".
function(_curvdecim_obstacle program version library out)
  set(obstacle "")
  if(NOT TARGET meshlab-headers-${version})
    set(obstacle "the MeshLab ${version} sources are missing (scripts/fetch-meshlab-sources, or MESHLAB_SOURCE_DIR).")
  elseif(NOT Qt5_FOUND)
    set(obstacle "the Qt 5 headers are missing (Debian: apt-get install qtbase5-dev libqt5opengl5-dev).")
  elseif(NOT CURVDECIM_GLEW_INCLUDE_DIR)
    set(obstacle "the header GL/glew.h is missing (Debian: apt-get install libglew-dev libgl-dev).")
  elseif(program STREQUAL "pymeshlab" AND NOT library)
    set(obstacle "PyMeshLab of MeshLab ${version} is not installed (pip install pymeshlab, or CURVDECIM_PYMESHLAB_DIR).")
  elseif(program STREQUAL "pymeshlab" AND NOT nlohmann_json_FOUND)
    set(obstacle "the header nlohmann/json.hpp is missing (Debian: apt-get install nlohmann-json3-dev).")
  endif()
  set(${out} "${obstacle}" PARENT_SCOPE)
endfunction()

function(_curvdecim_link_host_library target library)
  get_filename_component(directory ${library} DIRECTORY)
  # The host has the library loaded already: no run path, only where the linker finds what it needs.
  target_link_libraries(${target} PRIVATE ${library})
  target_link_options(${target} PRIVATE LINKER:-rpath-link,${directory} LINKER:--no-undefined)
endfunction()

function(_curvdecim_define_host target host version)
  set(api ${CURVDECIM_API_${host}})
  set(scalar ${CURVDECIM_SCALAR_${host}})
  if(scalar STREQUAL "double")
    set(double_suffix d)  # how a MeshLab in double precision spells its version
  endif()
  target_sources(${target} PRIVATE ${PROJECT_SOURCE_DIR}/filter_curvdecim/host/host_${api}.cpp
                                   ${PROJECT_SOURCE_DIR}/filter_curvdecim/host/host_${api}.h)
  target_compile_definitions(${target} PRIVATE CURVDECIM_HOST_API=${api} MESHLAB_SCALAR=${scalar}
                                               MESHLAB_VERSION=${version}${double_suffix} QT_PLUGIN)
endfunction()

function(curvdecim_add_plugin target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "HOST" "")
  if(NOT arg_HOST IN_LIST CURVDECIM_ALL_HOSTS)
    message(FATAL_ERROR "curvdecim_add_plugin: HOST must be one of ${CURVDECIM_ALL_HOSTS}, not '${arg_HOST}'.")
  endif()
  string(REGEX MATCH "^([a-z]+)-(.+)$" _ ${arg_HOST})
  set(program ${CMAKE_MATCH_1})
  set(version ${CMAKE_MATCH_2})
  _curvdecim_find_meshlab_library(${program} ${version} library)
  _curvdecim_obstacle(${program} ${version} "${library}" obstacle)
  if(obstacle)
    _curvdecim_leave_out(${arg_HOST} "${obstacle}")
    return()
  endif()

  set(folder ${PROJECT_SOURCE_DIR}/filter_curvdecim/host)
  add_library(${target} MODULE ${folder}/actions.cpp ${folder}/input_layer.cpp ${folder}/rich_parameters.cpp)
  _curvdecim_define_host(${target} ${arg_HOST} ${version})
  target_link_libraries(${target} PRIVATE curvdecim_parameter_table curvdecim_warnings meshlab-headers-${version}
                                          Qt5::Core Qt5::Gui Qt5::Widgets)
  target_include_directories(${target} SYSTEM PRIVATE ${Qt5Xml_INCLUDE_DIRS} ${Qt5OpenGL_INCLUDE_DIRS}
                                                      ${CURVDECIM_GLEW_INCLUDE_DIR})
  if(library)
    _curvdecim_link_host_library(${target} ${library})
  else()
    set(library "the host at load")
  endif()
  set_target_properties(${target} PROPERTIES
    AUTOMOC ON
    OUTPUT_NAME filter_curvdecim
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/plugins/${arg_HOST}
    BUILD_WITH_INSTALL_RPATH ON
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)
  install(TARGETS ${target} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/curvdecim/${arg_HOST}
          COMPONENT plugins OPTIONAL EXCLUDE_FROM_ALL)
  message(STATUS "CurvDecim for ${arg_HOST}: target ${target}, symbols from ${library}")
endfunction()
