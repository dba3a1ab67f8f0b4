// SPDX-License-Identifier: GPL-3.0-or-later
// The same bits on every machine. A fused multiply-add rounds once where the source rounds twice,
// and a compiler may fuse where the machine can. From here on it may not, whatever its flags; a
// CMake target gives the flag as well (cmake/CurvDecimCore.cmake).
#pragma once

#if defined(__clang__)
#pragma clang fp contract(off)
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#else
#error "CurvDecim uses the vectors of GCC and Clang; compile it with one of them."
#endif

// What was read before keeps its own rule, and of vcglib and Eigen that is the compiler's.
#if defined(__FMA__) && defined(EIGEN_CORE_H) && !defined(CURVDECIM_CONTRACTION_IS_OFF)
#error "Results would differ by machine: include CurvDecim before Eigen, or link CurvDecim::core."
#endif

#ifdef __FAST_MATH__
#error "-ffast-math changes results from machine to machine; compile CurvDecim without it."
#endif
