// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "vcg_ext/connectivity/vertex_kind.h"

namespace curvdecim {

/// What stands around a vertex that may go @cite schroeder1992.
enum class VertexClass : std::uint8_t {
  Simple,        ///< a closed fan of faces, no sharp edge
  Complex,       ///< no fan of faces that are oriented alike
  Boundary,      ///< half a fan, no sharp edge
  InteriorEdge,  ///< a closed fan with a line of two sharp edges through it
  Corner,        ///< a line of sharp edges ends here, or more than two meet
};

inline constexpr std::array<const char*, 5> vertex_class_names = {"simple", "complex", "boundary",
                                                                  "interior_edge", "corner"};

/// oriented: whether the faces around the vertex are oriented alike.
inline VertexClass class_of(VertexKind kind, bool oriented, int sharp_edges) {
  if (kind > VertexKind::Boundary || !oriented) return VertexClass::Complex;
  const bool inside = kind == VertexKind::Interior;
  if (sharp_edges == 0) return inside ? VertexClass::Simple : VertexClass::Boundary;
  return inside && sharp_edges == 2 ? VertexClass::InteriorEdge : VertexClass::Corner;
}

}  // namespace curvdecim
