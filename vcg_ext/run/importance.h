// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "vcg_ext/curvature/curvature_field.h"
#include "vcg_ext/curvature/curvature_weight.h"
#include "vcg_ext/parallel/timetable.h"
#include "vcg_ext/params.h"

namespace curvdecim::detail {

inline constexpr Timetable importance_times{200.0, 100.0, 0.0, 20.0};  // of a face

/// By vertex, what the parameters ask for. diagonal: of the bounding box, in the mesh's unit.
inline std::vector<double> importance_of(const WorkingMesh& mesh, const ImportanceParams& params,
                                         double diagonal, const Parallel& parallel) {
  const bool as_factor = params.output == ImportanceOf::Factor;
  CurvatureParams shown = params;
  if (!as_factor) shown.alpha_units = AlphaUnits::ModelUnits;  // the curvature as such
  CurvatureField field;
  parallel.progress().along(0.0, 1.0, [&] { field = curvature_field(mesh, shown, parallel); });
  const CurvatureWeight weight = curvature_weight(shown, field, diagonal);
  const double unit = params.curvature_kind == CurvatureKind::Gaussian ? 1.0 / (diagonal * diagonal)
                                                                       : 1.0 / diagonal;
  std::vector<double> importance;
  importance.reserve(field.value.size());
  for (double k : field.value)
    importance.push_back(as_factor ? weight.factor(weight.saturation(k)) : k * unit);
  return importance;
}

}  // namespace curvdecim::detail
