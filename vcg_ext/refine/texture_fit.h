// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/geometry/floating_point.h"
// clang-format off: before Eigen
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
// clang-format on

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "vcg_ext/mesh/seams.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel/parallel.h"
#include "vcg_ext/refine/input_samples.h"
#include "vcg_ext/refine/input_surface.h"
#include "vcg_ext/refine/mesh_samples.h"

namespace curvdecim::detail {

/// What the samples of one face ask of its corners in the texture: part of the normal equations of
/// a least-squares fit.
struct TextureSystem {
  std::array<std::array<double, 3>, 3> matrix{};
  std::array<Vector2, 3> force = {Vector2::Zero(), Vector2::Zero(), Vector2::Zero()};

  /// A point with these barycentric coordinates is to move by `pull`.
  void add(const Barycentric& at, const Vector2& pull, double weight) {
    for (int i = 0; i < 3; ++i) {
      force[i] += (weight * at[i]) * pull;
      for (int j = 0; j < 3; ++j) matrix[i][j] += weight * at[i] * at[j];
    }
  }
};

/// Moves texture coordinates inside charts to where the samples of the mesh and of the input, each
/// with its match, are off least @cite hoppe1999. Outlines of charts stay, and where a face would
/// turn over in the texture its corners do.
class TextureFit {
 public:
  /// mesh: without gaps in its numbers; free: by vertex, 1 if its coordinates may change.
  TextureFit(WorkingMesh& mesh, const InputSurface& input, const std::vector<std::uint8_t>& free,
             const Parallel& parallel)
      : mesh_(mesh), input_(input), parallel_(parallel), wedge_of_(free.size(), Wedges::none) {
    parallel_.for_each(static_cast<int>(free.size()), [&](int v) {
      if (free[v] != 0 && is_inside_chart(mesh_, v)) wedge_of_[v] = only_wedge(mesh_, v);
    });
  }

  void run(const InputSamples& of_input, const MeshSamples& of_mesh) {
    std::vector<TextureSystem> systems(face_count());
    parallel_.for_each(
        face_count(), [&](int f) { systems[f] = system_of_face(f, of_input, of_mesh); },
        Parallel::heavy);
    for (int v = 0; v < vertex_count(); ++v) add_vertex(v, of_mesh, systems);
    move(solved(systems));
  }

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  using Steps = Eigen::Matrix<double, Eigen::Dynamic, 2>;  // by vertex

  int face_count() const { return mesh_.connectivity.face_slots(); }
  int vertex_count() const { return mesh_.connectivity.vertex_slots(); }

  TextureSystem system_of_face(int f, const InputSamples& of_input,
                               const MeshSamples& of_mesh) const {
    const Triangle triangle = mesh_.triangle(f);
    TextureSystem system;
    for (int i : of_input.of_face(f)) add(f, of_input.match(triangle, i), system);
    for (const Match& match : of_mesh.matches(mesh_, f)) add(f, match, system);
    return system;
  }

  /// As a sample of its first face.
  void add_vertex(int v, const MeshSamples& of_mesh, std::vector<TextureSystem>& systems) const {
    const int f = *mesh_.connectivity.faces_of(v).begin();
    Match match = of_mesh.match_of_vertex(mesh_, v);
    match.at[mesh_.connectivity.corner(f, v)] = 1.0;
    add(f, match, systems[f]);
  }

  void add(int f, const Match& match, TextureSystem& system) const {
    const auto pull = input_.charts.texture_pull(mesh_, f, mesh_.texture_triangle(f), match);
    if (pull) system.add(match.at, *pull, match.weight);
  }

  /// The steps of the coordinates.
  Steps solved(const std::vector<TextureSystem>& systems) const {
    std::vector<Eigen::Triplet<double>> entries;
    Steps force = Steps::Zero(vertex_count(), 2);
    for (int f = 0; f < face_count(); ++f) {
      const Face& face = mesh_.connectivity.face(f);
      for (int i = 0; i < 3; ++i) {
        if (wedge_of_[face[i]] == Wedges::none) continue;
        force.row(face[i]) += systems[f].force[i];
        for (int j = 0; j < 3; ++j)
          if (face[i] >= face[j] && wedge_of_[face[j]] != Wedges::none)
            entries.emplace_back(face[i], face[j], systems[f].matrix[i][j]);
      }
    }
    Matrix matrix(vertex_count(), vertex_count());
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<Matrix, Eigen::Lower> solver;
    solver.setTolerance(precision);
    solver.setMaxIterations(most_iterations);
    return solver.compute(matrix).solve(force);
  }

  void move(const Steps& steps) {
    const std::vector<Vector2> before = mesh_.texture;
    for (int v = 0; v < vertex_count(); ++v)
      if (wedge_of_[v] != Wedges::none) mesh_.texture[wedge_of_[v]] += steps.row(v).transpose();
    while (take_back_turned(before)) {
    }
  }

  /// The corners of faces that are turned over. Returns whether there were such.
  bool take_back_turned(const std::vector<Vector2>& before) {
    std::vector<std::uint8_t> turned(face_count());
    parallel_.for_each(face_count(), [&](int f) { turned[f] = is_turned(f, before) ? 1 : 0; });
    bool any = false;
    for (int f = 0; f < face_count(); ++f)
      if (turned[f] != 0) {
        any = true;
        for (int wedge : mesh_.wedges.of_face(f)) mesh_.texture[wedge] = before[wedge];
      }
    return any;
  }

  bool is_turned(int f, const std::vector<Vector2>& before) const {
    const auto [a, b, c] = mesh_.wedges.of_face(f);
    return is_turned_over(texture_area({before[a], before[b], before[c]}),
                          texture_area(mesh_.texture_triangle(f)));
  }

  static constexpr double precision = 1e-3;   // of the steps: they are much smaller than faces
  static constexpr int most_iterations = 50;  // neighbours agree after a few

  WorkingMesh& mesh_;
  const InputSurface& input_;
  const Parallel& parallel_;
  std::vector<int> wedge_of_;  // by vertex; none: its coordinates stay
};

}  // namespace curvdecim::detail
