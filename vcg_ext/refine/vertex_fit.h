// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel/parallel.h"
#include "vcg_ext/refine/curve_samples.h"
#include "vcg_ext/refine/input_samples.h"
#include "vcg_ext/refine/mesh_samples.h"
#include "vcg_ext/refine/normal_equations.h"

namespace curvdecim::detail {

/// The steps of the vertices that lower the squared distances of all samples most, connectivity
/// and matches as they are @cite hoppe1993. Along the line to its match a sample counts in full,
/// across it not at all, so that vertices may slide.
class VertexFit {
 public:
  VertexFit(const WorkingMesh& mesh, const Parallel& parallel) : mesh_(mesh), parallel_(parallel) {}

  /// fixed: by vertex, 1 may not move.
  std::vector<Vector3> steps(const InputSamples& of_input, const MeshSamples& of_mesh,
                             std::initializer_list<const CurveSamples*> of_curves,
                             const std::vector<std::uint8_t>& fixed) const {
    NormalEquations equations(mesh_.connectivity, fixed);
    for (int begin = 0; begin < mesh_.connectivity.face_slots(); begin += block)
      add_faces(begin, std::min(mesh_.connectivity.face_slots(), begin + block), of_input, of_mesh,
                equations);
    for (int v = 0; v < mesh_.connectivity.vertex_slots(); ++v)
      add_vertex(v, of_mesh.match_of_vertex(mesh_, v), equations);
    for (const CurveSamples* of_curve : of_curves)
      for (int e = 0; e < of_curve->edge_count(); ++e)
        equations.add_edge(of_curve->edge(e), system_of_edge(*of_curve, e));
    return equations.solve(parallel_);
  }

 private:
  static constexpr int block = 1024;  // faces at once: their systems would fill the memory

  void add_faces(int begin, int end, const InputSamples& of_input, const MeshSamples& of_mesh,
                 NormalEquations& equations) const {
    std::vector<CornerSystem> systems(end - begin);
    parallel_.for_each(
        end - begin, [&](int i) { systems[i] = system_of_face(begin + i, of_input, of_mesh); },
        Parallel::heavy);
    for (int f = begin; f < end; ++f) equations.add_face(f, systems[f - begin]);
  }

  CornerSystem system_of_face(int f, const InputSamples& of_input,
                              const MeshSamples& of_mesh) const {
    const Triangle triangle = mesh_.triangle(f);
    CornerSystem system;
    for (int i : of_input.of_face(f)) add(triangle, f, of_input.match(triangle, i), system);
    for (const Match& match : of_mesh.matches(mesh_, f)) add(triangle, f, match, system);
    return system;
  }

  /// A sample that lies on its match holds the face where it is.
  void add(const Triangle& triangle, int f, const Match& match, CornerSystem& system) const {
    const Vector3 pull = match.target - at(triangle, match.at);
    if (match.distance2 > 0.0)
      system.add(match.at, Symmetric3::outer(pull, 1.0 / pull.squaredNorm()), pull, match.weight);
    else
      system.add(match.at, Symmetric3::outer(mesh_.plane[f].normal, 1.0), Vector3::Zero(),
                 match.weight);
  }

  void add_vertex(int v, const Match& match, NormalEquations& equations) const {
    const Vector3 pull = match.target - mesh_.position[v];
    if (!(match.distance2 > 0.0)) return;
    equations.add_vertex(v, Symmetric3::outer(pull, 1.0 / pull.squaredNorm()), pull, match.weight);
  }

  /// Across an edge a sample counts in both directions, beyond its ends along the line to its
  /// match. One that lies on its match holds the edge where it is.
  static CornerSystem system_of_edge(const CurveSamples& of_curve, int e) {
    const Triangle edge = of_curve.triangle(e);
    const Vector3 along = (edge[1] - edge[0]).normalized();
    const Symmetric3 across = Symmetric3::outer(along, -1.0).plus_diagonal(1.0);
    CornerSystem system;
    for (const Match& match : of_curve.of_edge(e)) {
      const bool is_off = match.distance2 > 0.0;
      const Vector3 pull = is_off ? Vector3(match.target - at(edge, match.at)) : Vector3::Zero();
      if (match.at[0] > 0.0 && match.at[1] > 0.0)
        system.add(match.at, across, across * pull, match.weight);
      else if (is_off)
        system.add(match.at, Symmetric3::outer(pull, 1.0 / pull.squaredNorm()), pull, match.weight);
    }
    return system;
  }

  const WorkingMesh& mesh_;
  const Parallel& parallel_;
};

}  // namespace curvdecim::detail
