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

  /// The part of a sample on a face of the chart of face f, its corners drawn at `corners`.
  double of(int f, const TextureTriangle& corners, const Match& match) const {
    const auto pull = input_.charts.texture_pull(mesh_, f, corners, match);
    return pull ? weight_ * match.weight * pull->squaredNorm() : 0.0;
  }

 private:
  const WorkingMesh& mesh_;
  const InputSurface& input_;
  const double weight_;
};

}  // namespace curvdecim::detail
