// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <tuple>

#include "vcg_ext/field.h"

namespace curvdecim {

/// What distances between two surfaces are told in.
enum class RelativeTo {
  MeshUnit,   ///< the meshes' own unit of length
  Diagonal,   ///< per cent of the diagonal of the original's bounding box
  Tolerance,  ///< multiples of the tolerance
};
constexpr auto labels(RelativeTo) { return std::array{"MeshUnit", "Diagonal", "Tolerance"}; }

/// How the error of a simplification is measured.
struct ErrorParams {
  int sample_num = 0;  ///< on each surface; 0: 100,000, or one a vertex of the original if more
  RelativeTo relative_to = RelativeTo::MeshUnit;
  double tolerance = 0.0;     ///< the share of the surface beyond it is told; 0: none
  bool save_quality = false;  ///< writes to each vertex how far the other surface is
  int threads = 0;            ///< 0: all cores; the result does not depend on it

  static constexpr auto fields() {
    using P = ErrorParams;
    return std::tuple(Field("sample_num", &P::sample_num, between(0.0, most_samples, "samples")),
                      Field("relative_to", &P::relative_to),
                      Field("tolerance", &P::tolerance, at_least(0.0, length_unit)),
                      Field("save_quality", &P::save_quality),
                      Field("threads", &P::threads, at_least(0.0, "threads")));
  }

 private:
  static constexpr double most_samples = 1e9;  // they are counted in 32 bits
};

}  // namespace curvdecim
