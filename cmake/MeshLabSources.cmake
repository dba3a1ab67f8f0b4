# SPDX-License-Identifier: GPL-3.0-or-later
# Finds unpacked MeshLab sources and makes one target per version, meshlab-headers-<version>,
# that carries the include directories of MeshLab and of the vcglib that belongs to it.
# Sets CURVDECIM_NEWEST_MESHLAB to the newest version found; vcg_ext is the core with its vcglib, for tests and
# benchmarks.

set(MESHLAB_SOURCE_DIR "" CACHE STRING
    "MeshLab checkout(s) with vcglib, separated by ';'; wins over build/meshlab/<version>")

function(_curvdecim_vcglib_of source_dir out)
  foreach(vcglib IN ITEMS ${source_dir}/src/vcglib ${source_dir}/vcglib)
    if(EXISTS ${vcglib}/vcg/complex/complex.h)
      set(${out} ${vcglib} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "No vcglib in the MeshLab sources ${source_dir}: "
                      "in a git checkout run `git submodule update --init`.")
endfunction()

function(_curvdecim_add_meshlab source_dir)
  if(NOT EXISTS ${source_dir}/ML_VERSION OR NOT EXISTS ${source_dir}/src/common)
    message(FATAL_ERROR "MESHLAB_SOURCE_DIR: ${source_dir} is not a MeshLab source tree "
                        "(it has no ML_VERSION or no src/common).")
  endif()
  file(STRINGS ${source_dir}/ML_VERSION version LIMIT_COUNT 1)
  string(STRIP "${version}" version)
  if(TARGET meshlab-headers-${version})
    return()
  endif()
  _curvdecim_vcglib_of(${source_dir} vcglib)
  add_library(meshlab-headers-${version} INTERFACE)
  target_include_directories(meshlab-headers-${version} SYSTEM INTERFACE ${source_dir}/src ${vcglib})
  set_property(GLOBAL APPEND PROPERTY CURVDECIM_MESHLAB_VERSIONS ${version})
  message(STATUS "MeshLab ${version} sources: ${source_dir}")
endfunction()

foreach(checkout IN LISTS MESHLAB_SOURCE_DIR)
  get_filename_component(checkout "${checkout}" ABSOLUTE)
  _curvdecim_add_meshlab(${checkout})
endforeach()

file(GLOB fetched_version_files ${PROJECT_SOURCE_DIR}/build/meshlab/*/ML_VERSION)
foreach(version_file IN LISTS fetched_version_files)
  get_filename_component(fetched ${version_file} DIRECTORY)
  _curvdecim_add_meshlab(${fetched})
endforeach()

get_property(versions GLOBAL PROPERTY CURVDECIM_MESHLAB_VERSIONS)
list(SORT versions COMPARE NATURAL ORDER DESCENDING)
list(POP_FRONT versions CURVDECIM_NEWEST_MESHLAB)
if(NOT CURVDECIM_NEWEST_MESHLAB)
  list(GET CURVDECIM_ALL_HOSTS 0 host)
  string(REGEX REPLACE "^[a-z]+-" "" version ${host})
  list(JOIN CURVDECIM_SUITES_${host} " " suites)
  message(FATAL_ERROR "No MeshLab sources found. Run `scripts/fetch-meshlab-sources ${version} ${suites}`, "
                      "or name a MeshLab checkout in MESHLAB_SOURCE_DIR: -DMESHLAB_SOURCE_DIR=<directory> "
                      "for cmake, the environment variable for scripts/ and pip.")
endif()

add_library(vcg_ext INTERFACE)
target_link_libraries(vcg_ext INTERFACE curvdecim_core meshlab-headers-${CURVDECIM_NEWEST_MESHLAB})
