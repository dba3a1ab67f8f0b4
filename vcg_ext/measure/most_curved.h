// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "vcg_ext/curvature/curvature_field.h"
#include "vcg_ext/measure/area_samples.h"

namespace curvdecim::detail {

inline constexpr double salient_share = 0.2;  // of the area: a fifth

/// By vertex: the angle missing from a full turn over the area around it, averaged over its ring.
inline std::vector<double> angle_defects(const WorkingMesh& mesh, const Parallel& parallel) {
  CurvatureParams defect;
  defect.curvature_kind = CurvatureKind::Gaussian;
  defect.alpha_units = AlphaUnits::ScaleFree;
  defect.curvature_of = CurvatureOf::Input;
  return curvature_field(mesh, defect, parallel).value;
}

/// The value that a part of the numbers reaches or exceeds.
inline double least_of_largest(std::vector<double> numbers, double part) {
  const auto rank = static_cast<std::ptrdiff_t>((1.0 - part) * (numbers.size() - 1));
  std::nth_element(numbers.begin(), numbers.begin() + rank, numbers.end());
  return numbers[rank];
}

/// Tells which samples lie in the part of the area that is curved most.
class MostCurved {
 public:
  MostCurved(const MeasuredSurface& surface, const AreaSamples& samples, const Parallel& parallel)
      : curvature_(samples.count()) {
    const WorkingMesh& mesh = surface.mesh();
    const std::vector<double> at_vertex = angle_defects(mesh, parallel);
    samples.for_each(parallel, [&](int i, int face, const Barycentric& weight) {
      const Face& corners = mesh.connectivity.face(surface.number_in_mesh(face));
      curvature_[i] = weight[0] * at_vertex[corners[0]] + weight[1] * at_vertex[corners[1]] +
                      weight[2] * at_vertex[corners[2]];
    });
    least_ = least_of_largest(curvature_, salient_share);
  }

  bool operator()(int sample) const { return curvature_[sample] >= least_; }

 private:
  std::vector<double> curvature_;  // by sample
  double least_ = 0.0;
};

}  // namespace curvdecim::detail
