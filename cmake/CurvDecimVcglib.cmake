# SPDX-License-Identifier: GPL-3.0-or-later
# vcglib is the project's own, because the mesh type is: it is in an include directory already, or
# CURVDECIM_VCGLIB_DIR names its folder. Read in a subproject, and by find_package.

set(CURVDECIM_VCGLIB_DIR "" CACHE PATH "Folder of vcglib, in which vcg/ is; empty: the project knows it")

# With CURVDECIM_VCGLIB_DIR: gives its headers to the target, and makes CurvDecim::ply, the one source file that
# vcglib's reader and writer of PLY files need beside the headers. Sets ${problem} to what is wrong, or to "".
function(curvdecim_use_vcglib target problem)
  set(${problem} "" PARENT_SCOPE)
  if(NOT CURVDECIM_VCGLIB_DIR)
    return()
  endif()
  if(NOT EXISTS ${CURVDECIM_VCGLIB_DIR}/vcg/complex/complex.h)
    set(${problem} "CURVDECIM_VCGLIB_DIR: ${CURVDECIM_VCGLIB_DIR} is not vcglib (it has no vcg/complex/complex.h)."
        PARENT_SCOPE)
    return()
  endif()
  target_include_directories(${target} SYSTEM INTERFACE $<BUILD_INTERFACE:${CURVDECIM_VCGLIB_DIR}>)
  if(NOT TARGET CurvDecim::ply)
    add_library(curvdecim_ply STATIC EXCLUDE_FROM_ALL ${CURVDECIM_VCGLIB_DIR}/wrap/ply/plylib.cpp)
    set_target_properties(curvdecim_ply PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_link_libraries(curvdecim_ply PUBLIC ${target})
    add_library(CurvDecim::ply ALIAS curvdecim_ply)
  endif()
endfunction()
