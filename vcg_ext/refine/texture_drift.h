// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/refine/input_surface.h"
#include "vcg_ext/refine/match.h"

namespace curvdecim::detail {

/// How far off samples of the input are in the texture of the mesh, as part of an error.
class TextureDrift {
 public:
  /// attribute_weight: of squared lengths in the texture, in the surface's unit, against those of
  /// the surface.
  TextureDrift(const WorkingMesh& mesh, const InputSurface& input, double attribute_weight)
      : mesh_(mesh), input_(input), weight_(attribute_weight * mesh.texture_scale2) {}

  bool counts() const { return weight_ > 0.0; }

  /// Of a sample with a match on a face of the chart of face f, the texture of which is `texture`.
  double of(int f, const TextureTriangle& texture, const Match& match) const {
    const auto there = input_.charts.texture_for(mesh_, f, match.input_face, match.on_input);
    if (!there) return 0.0;
    return weight_ * match.weight * (*there - interpolated(texture, match.at)).squaredNorm();
  }

 private:
  const WorkingMesh& mesh_;
  const InputSurface& input_;
  const double weight_;
};

}  // namespace curvdecim::detail
