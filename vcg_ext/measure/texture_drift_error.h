// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "vcg_ext/error_report.h"
#include "vcg_ext/measure/area_samples.h"
#include "vcg_ext/measure/fixed_blocks.h"
#include "vcg_ext/measure/texture_atlas.h"

namespace curvdecim::detail {

/// A surface and the texture coordinates of its faces; empty: it has no texture.
struct TexturedSurface {
  const MeasuredSurface& surface;
  const std::vector<FaceWedges>& wedges;
};

/// By samples of the simplified surface: how far each is from where the original shows what is
/// drawn there. In the box of diagonal 1.
inline TextureDriftError texture_drift(const TexturedSurface& original,
                                       const TexturedSurface& simplified,
                                       const AreaSamples& samples, const Parallel& parallel) {
  constexpr double not_drawn = -1.0, nowhere = -2.0;
  const TextureAtlas atlas(original.surface, original.wedges, parallel);
  std::vector<double> drift(samples.count());
  samples.for_each(parallel, [&](int i, int face, const Barycentric& weight) {
    const FaceWedges& wedges = simplified.wedges[face];
    drift[i] = !is_drawn(wedges)
                   ? not_drawn
                   : atlas.drift(at(wedges, weight), at(simplified.surface.triangle(face), weight))
                         .value_or(nowhere);
  });
  const int count = samples.count();
  const auto share_where = [&](auto holds) {
    return sum_of(count, parallel, [&](int i) { return holds(drift[i]) ? 1.0 : 0.0; });
  };
  const double known = share_where([](double d) { return d >= 0.0; });
  const double squares =
      sum_of(count, parallel, [&](int i) { return drift[i] > 0.0 ? drift[i] * drift[i] : 0.0; });
  return {known > 0.0 ? std::sqrt(squares / known) : 0.0,
          largest_of(count, parallel, [&](int i) { return drift[i]; }),
          share_where([](double d) { return d == nowhere; }) / count};
}

}  // namespace curvdecim::detail
