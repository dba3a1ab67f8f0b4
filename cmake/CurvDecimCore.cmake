# SPDX-License-Identifier: GPL-3.0-or-later
# Targets for the header-only core:
#   curvdecim_core      include directory, Eigen, threads and the flags every user of the core needs;
#                       CurvDecim::core, as find_package gives it
#   CurvDecim::ply      where CURVDECIM_VCGLIB_DIR is given: what reading and writing PLY files takes
#   curvdecim_warnings  the warnings our own sources are free of

if(NOT TARGET Eigen3::Eigen)  # the project around this one may have brought it
  find_package(Eigen3 REQUIRED NO_MODULE)
endif()
find_package(Threads REQUIRED)

add_library(curvdecim_core INTERFACE)
add_library(CurvDecim::core ALIAS curvdecim_core)
target_include_directories(curvdecim_core INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
target_compile_features(curvdecim_core INTERFACE cxx_std_17)
# A fused multiply-add rounds once instead of twice: results would differ from machine to machine.
target_compile_options(curvdecim_core INTERFACE -ffp-contract=off)
# Nobody reads errno after a square root, and without it four are computed side by side.
target_compile_options(curvdecim_core INTERFACE -fno-math-errno)
# Vectors of three doubles: packets of two cost more in shuffling than they save (measured: 1.2 times).
target_compile_definitions(curvdecim_core INTERFACE EIGEN_DONT_VECTORIZE CURVDECIM_CONTRACTION_IS_OFF)
target_link_libraries(curvdecim_core INTERFACE Eigen3::Eigen Threads::Threads)

include(${CMAKE_CURRENT_LIST_DIR}/CurvDecimVcglib.cmake)
curvdecim_use_vcglib(curvdecim_core _curvdecim_problem)
if(_curvdecim_problem)
  message(FATAL_ERROR "${_curvdecim_problem}")
endif()

add_library(curvdecim_warnings INTERFACE)
target_compile_options(curvdecim_warnings INTERFACE -Wall -Wextra -Wshadow)
