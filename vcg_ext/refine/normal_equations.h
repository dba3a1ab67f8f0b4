// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "vcg_ext/connectivity/triangle_connectivity.h"
#include "vcg_ext/geometry/symmetric3.h"
#include "vcg_ext/parallel.h"

namespace curvdecim {

/// What the samples of one face, or of one boundary edge, ask of its corners: part of the normal
/// equations of a least-squares fit.
struct CornerSystem {
  std::array<Symmetric3, 6> matrix;  // of the corner pairs 00 01 02 11 12 22
  std::array<Vector3, 3> force = {Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};

  static int pair(int i, int j) {
    constexpr int number[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    return number[i][j];
  }

  /// A point with these barycentric coordinates is to move by `pull`, of which `m` counts.
  void add(const std::array<double, 3>& at, const Symmetric3& m, const Vector3& pull,
           double weight) {
    for (int i = 0; i < 3; ++i) {
      force[i] += (weight * at[i]) * pull;
      for (int j = i; j < 3; ++j)
        if (at[i] * at[j] != 0.0) matrix[pair(i, j)] += m * (weight * at[i] * at[j]);
    }
  }
};

/// The normal equations of all corners, for the steps of the vertices.
class NormalEquations {
 public:
  struct EdgeSystem {
    int a, b;
    CornerSystem system;
  };

  std::vector<CornerSystem> of_face;
  std::vector<EdgeSystem> of_edge;   // of the boundary
  std::vector<Symmetric3> diagonal;  // by vertex: what is asked of it alone, in solve() of all
  std::vector<Vector3> force;        // likewise

  /// fixed: by vertex, 1 may not move.
  NormalEquations(const TriangleConnectivity& connectivity, const std::vector<std::uint8_t>& fixed)
      : of_face(connectivity.face_slots()),
        diagonal(connectivity.vertex_slots()),
        force(connectivity.vertex_slots(), Vector3::Zero()),
        connectivity_(connectivity),
        fixed_(fixed) {}

  /// Some steps of the conjugate gradient method: far enough that neighbours know of each other;
  /// the samples are matched anew before an exact solution would be worth its time.
  std::vector<Vector3> solve(const Parallel& parallel) {
    collect(parallel);
    std::vector<Vector3> x(force.size(), Vector3::Zero()), direction, image(force.size());
    precondition(direction, parallel);
    double height = dot(force, direction);
    for (int step = 0; step < steps && height > 0.0; ++step) {
      multiply(direction, image, parallel);
      const double bend = dot(direction, image);
      if (!(bend > 0.0)) break;
      const double length = height / bend;
      for (std::size_t v = 0; v < x.size(); ++v)
        x[v] += length * direction[v], force[v] -= length * image[v];
      precondition(scaled_force_, parallel);
      const double next = dot(force, scaled_force_);
      for (std::size_t v = 0; v < x.size(); ++v)
        direction[v] = scaled_force_[v] + (next / height) * direction[v];
      height = next;
    }
    return x;
  }

 private:
  static constexpr int steps = 5;
  static constexpr double slack = 1e-4;  // of the trace: lets vertices slide along the surface

  /// From faces and edges to vertices.
  void collect(const Parallel& parallel) {
    parallel.for_each(static_cast<int>(force.size()), [&](int v) {
      for (int f : connectivity_.faces_of(v)) add_corner(of_face[f], connectivity_.corner(f, v), v);
    });
    for (const EdgeSystem& edge : of_edge) {
      add_corner(edge.system, 0, edge.a);
      add_corner(edge.system, 1, edge.b);
    }
    for (std::size_t v = 0; v < force.size(); ++v) {
      diagonal[v] = diagonal[v].plus_diagonal(slack * diagonal[v].trace());
      if (is_held(static_cast<int>(v))) force[v].setZero();
    }
  }

  void add_corner(const CornerSystem& system, int corner, int v) {
    diagonal[v] += system.matrix[CornerSystem::pair(corner, corner)];
    force[v] += system.force[corner];
  }

  /// A vertex that may not move, or that no sample asks anything of.
  bool is_held(int v) const { return fixed_[v] != 0 || !(diagonal[v].trace() > 0.0); }

  void precondition(std::vector<Vector3>& result, const Parallel& parallel) const {
    result.resize(force.size());
    parallel.for_each(static_cast<int>(force.size()), [&](int v) {
      result[v] =
          is_held(v) ? Vector3(Vector3::Zero()) : Factorization3(diagonal[v]).solve(force[v]);
    });
  }

  void multiply(const std::vector<Vector3>& x, std::vector<Vector3>& result,
                const Parallel& parallel) const {
    parallel.for_each(static_cast<int>(x.size()), [&](int v) {
      result[v] = diagonal[v] * x[v];
      for (int f : connectivity_.faces_of(v)) {
        const int i = connectivity_.corner(f, v);
        for (int j = 0; j < 3; ++j)
          if (j != i)
            result[v] += of_face[f].matrix[CornerSystem::pair(i, j)] * x[connectivity_.face(f)[j]];
      }
    });
    for (const EdgeSystem& edge : of_edge) {
      const Symmetric3& between = edge.system.matrix[CornerSystem::pair(0, 1)];
      result[edge.a] += between * x[edge.b];
      result[edge.b] += between * x[edge.a];
    }
    for (std::size_t v = 0; v < x.size(); ++v)
      if (is_held(static_cast<int>(v))) result[v].setZero();
  }

  /// In the order of the vertices, whatever the number of threads.
  static double dot(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
    double sum = 0.0;
    for (std::size_t v = 0; v < a.size(); ++v) sum += a[v].dot(b[v]);
    return sum;
  }

  const TriangleConnectivity& connectivity_;
  const std::vector<std::uint8_t>& fixed_;
  std::vector<Vector3> scaled_force_;
};

}  // namespace curvdecim
