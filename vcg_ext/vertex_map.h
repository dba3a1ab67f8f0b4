// SPDX-License-Identifier: GPL-3.0-or-later
// The names under which keep_map leaves its two maps, with which what the result does not carry
// (skin weights, measurements) can be taken from the input, and back.
#pragma once

namespace curvdecim {

/// The custom attribute of a vertex of the result, of the mesh's ScalarType: the index of the
/// nearest vertex of the input, always the same one of several in one place.
inline constexpr const char* nearest_input_vertex = "nearest_input_vertex";

/// The custom attribute of the mesh, a std::vector<int>: for each vertex of the input the index of
/// the vertex of the result that it went into; -1 where none is left.
inline constexpr const char* result_vertex = "result_vertex";

}  // namespace curvdecim
