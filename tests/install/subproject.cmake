# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D CXX= -D GENERATOR= -D SOURCE= -D VCGLIB= -D EIGEN_DIR= -D WORK= -P subproject.cmake
# examples/project, which adds this repository as a subproject: it builds and runs, and is asked for nothing that the
# core does not need.

file(REMOVE_RECURSE ${WORK})
execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${SOURCE}/examples/project -B ${WORK} -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX}
          -DCMAKE_CXX_FLAGS=-O0  # to be quick
          -DCURVDECIM_DIR=${SOURCE} -DCURVDECIM_VCGLIB_DIR=${VCGLIB} -DEigen3_DIR=${EIGEN_DIR}
  OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/shrink ${SOURCE}/sample_meshes/torus.ply ${WORK}/small.ply
                OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)

if(NOT printed MATCHES "^([0-9]+) faces became ([0-9]+) faces\n$")
  message(FATAL_ERROR "shrink printed ${printed}")
endif()
math(EXPR half "${CMAKE_MATCH_1} / 2")
file(READ ${WORK}/small.ply written LIMIT 1000)
if(NOT CMAKE_MATCH_2 EQUAL half OR NOT written MATCHES "element face ${half}\n")
  message(FATAL_ERROR "not half of the faces: ${printed}")
endif()

file(STRINGS ${WORK}/CMakeCache.txt more REGEX "Qt5|GTest|MESHLAB|BUILD_TESTING|CURVDECIM_HOSTS|CMAKE_BUILD_TYPE:STRING=.")
if(more OR said MATCHES "MeshLab")
  message(FATAL_ERROR "more than the core was configured\n${more}\n${said}")
endif()
