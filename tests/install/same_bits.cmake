# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D CXX= -D PREFIX= -D VCGLIB= -D EIGEN= -D SOURCE= -D WORK= -P same_bits.cmake
# A program that knows nothing of the target's flags is compiled for a machine with fused multiply-add. There must be
# none in it, and its results must be those of any machine.

set(fused "\tvfn?m(add|sub)[0-9]")  # such an instruction, in assembly

# The assembly of a program, with the headers of ${include}.
function(compile program include out)
  execute_process(
    COMMAND ${CXX} -std=c++17 -O2 ${ARGN} -S -I ${include} -I ${SOURCE}/tests -I ${SOURCE}/examples
            -isystem ${VCGLIB} -isystem ${EIGEN} ${SOURCE}/${program} -o ${out}
    COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(results assembly out)
  execute_process(COMMAND ${CXX} ${assembly} -pthread -o ${assembly}.program COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${assembly}.program OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
  set(${out} "${printed}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

# Without the pragma there are some: the compiler would use them, and the check would see them.
file(COPY ${PREFIX}/include/vcg_ext DESTINATION ${WORK}/without_pragma)
set(pragma_header ${WORK}/without_pragma/vcg_ext/geometry/floating_point.h)
file(READ ${pragma_header} text)
string(REGEX REPLACE "#pragma (GCC|clang)[^\n]*" "" without_pragma "${text}")
if(without_pragma STREQUAL text)
  message(FATAL_ERROR "vcg_ext/geometry/floating_point.h has no pragma")
endif()
file(WRITE ${pragma_header} "${without_pragma}")
compile(examples/decimate.cpp ${WORK}/without_pragma ${WORK}/without_pragma.s -march=haswell)
file(STRINGS ${WORK}/without_pragma.s found REGEX ${fused} LIMIT_COUNT 1)
if(NOT found)
  message(FATAL_ERROR "no fused multiply-add without the pragma: this test would not see one")
endif()

compile(tests/install/print_bits.cpp ${PREFIX}/include ${WORK}/haswell.s -march=haswell)
file(STRINGS ${WORK}/haswell.s found REGEX ${fused})
if(found)
  list(LENGTH found count)
  message(FATAL_ERROR "${count} fused multiply-adds")
endif()

# Where Eigen was read before, the pragma would come too late.
execute_process(
  COMMAND ${CXX} -std=c++17 -march=haswell -DVCGLIB_FIRST -fsyntax-only -I ${PREFIX}/include -I ${SOURCE}/tests
          -I ${SOURCE}/examples -isystem ${VCGLIB} -isystem ${EIGEN} ${SOURCE}/tests/install/print_bits.cpp
  RESULT_VARIABLE refused ERROR_VARIABLE message)
if(NOT refused OR NOT message MATCHES "include CurvDecim before Eigen")
  message(FATAL_ERROR "vcglib before the core was not refused\n${message}")
endif()

file(STRINGS /proc/cpuinfo runs_here REGEX "avx2.*fma|fma.*avx2" LIMIT_COUNT 1)
if(runs_here)
  compile(tests/install/print_bits.cpp ${PREFIX}/include ${WORK}/plain.s)
  results(${WORK}/haswell.s found)
  results(${WORK}/plain.s expected)
  if(NOT found STREQUAL expected)
    message(FATAL_ERROR "with -march=haswell\n${found}\nand without\n${expected}")
  endif()
endif()
