// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "vcg_ext/curvature/vertex_curvature.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// A measure of curvature over a mesh, in the unit of its positions.
struct CurvatureField {
  std::vector<double> value, area;  // by vertex

  /// Area-weighted; 0 where there is no area.
  double mean() const {
    double sum = 0.0, total = 0.0;
    for (std::size_t v = 0; v < value.size(); ++v) sum += value[v] * area[v], total += area[v];
    return total > 0.0 ? sum / total : 0.0;
  }

  /// The least value in the most curved part of the area, in linear time; 0 without vertices.
  double least_of_most_curved(double part) const {
    std::vector<std::pair<double, double>> order(value.size());  // value and area
    for (std::size_t v = 0; v < order.size(); ++v) order[v] = {value[v], area[v]};
    const auto area_of = [](auto begin, auto end) {
      return std::accumulate(begin, end, 0.0,
                             [](double sum, const auto& of) { return sum + of.second; });
    };
    auto begin = order.begin(), end = order.end();
    double left = (1.0 - part) * area_of(begin, end);
    while (end - begin > 1) {
      const auto middle = begin + (end - begin) / 2;
      std::nth_element(begin, middle, end);
      const double lower = area_of(begin, middle);
      if (left < lower)
        end = middle;
      else
        begin = middle, left -= lower;
    }
    return order.empty() ? 0.0 : begin->first;
  }
};

inline CurvatureField measured_field(const WorkingMesh& mesh, const CurvatureParams& params,
                                     const Parallel& parallel) {
  const std::size_t count = mesh.position.size();
  CurvatureField field{std::vector<double>(count), std::vector<double>(count)};
  parallel.for_each(static_cast<int>(count), [&](int v) {
    const VertexCurvature curvature = vertex_curvature(mesh, v);
    field.value[v] = curvature.measure(params), field.area[v] = curvature.area;
  });
  return field;
}

/// Each vertex gets the mean of its own value and its neighbours', which count by the faces that
/// they share with it: the curvature of single vertices is mostly noise. counts(u): whether u does;
/// where none does, the value stays.
template <class Counts>
void average_over_rings(const WorkingMesh& mesh, CurvatureField& field, const Parallel& parallel,
                        Counts counts) {
  const std::vector<double> value = field.value;
  parallel.for_each(static_cast<int>(value.size()), [&](int v) {
    double sum = 0.0, weight = 0.0;
    const auto add = [&](int u, double part) {
      if (counts(u)) sum += part * value[u], weight += part;
    };
    add(v, 1.0);
    for (int f : mesh.connectivity.faces_of(v))
      for (int u : mesh.connectivity.face(f))
        if (u != v) add(u, 0.5);  // inside, each neighbour is in two faces
    if (weight > 0.0) field.value[v] = sum / weight;
  });
}

/// What the parameters make of the mesh as it is. As printed, the angles on a boundary tell how the
/// boundary turns, not the surface: there only inner vertices count in the average.
inline CurvatureField curvature_field(const WorkingMesh& mesh, const CurvatureParams& params,
                                      const Parallel& parallel) {
  CurvatureField field = measured_field(mesh, params, parallel);
  if (params.curvature_of == CurvatureOf::Current) return field;
  const bool all = params.alpha_units == AlphaUnits::ScaleFree;
  average_over_rings(mesh, field, parallel,
                     [&](int u) { return all || mesh.kind[u] == VertexKind::Interior; });
  return field;
}

}  // namespace curvdecim::detail
