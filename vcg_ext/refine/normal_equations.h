// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/geometry/symmetric3.h"
#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

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

/// What ties corner 0 to 1, 1 to 2 and 2 to 0, in single precision: steps need no more.
class CornerTies {
 public:
  CornerTies() = default;
  explicit CornerTies(const CornerSystem& system) {
    for (int i = 0; i < 3; ++i) {
      const Symmetric3& m = system.matrix[CornerSystem::pair(i, (i + 1) % 3)];
      values_[i] = {float(m.xx), float(m.xy), float(m.xz), float(m.yy), float(m.yz), float(m.zz)};
    }
  }

  /// The tie of corner i and the one after it.
  Symmetric3 with_next(int i) const {
    const auto [xx, xy, xz, yy, yz, zz] = values_[i];
    return {xx, xy, xz, yy, yz, zz};
  }

 private:
  std::array<std::array<float, 6>, 3> values_{};
};

/// The normal equations of all corners, for the steps of the vertices.
class NormalEquations {
 public:
  /// fixed: by vertex, 1 may not move.
  NormalEquations(const TriangleConnectivity& connectivity, const std::vector<std::uint8_t>& fixed)
      : connectivity_(connectivity),
        fixed_(fixed),
        face_ties_(connectivity.face_slots()),
        diagonal_(connectivity.vertex_slots()),
        force_(connectivity.vertex_slots(), Vector3::Zero()) {}

  /// A face asks this of its corners.
  void add_face(int f, const CornerSystem& system) {
    face_ties_[f] = CornerTies(system);
    for (int i = 0; i < 3; ++i) add_corner(system, i, connectivity_.face(f)[i]);
  }

  /// So does an edge of the boundary, as corners 0 and 1.
  void add_edge(Edge edge, const CornerSystem& system) {
    edge_ties_.push_back({edge, system.matrix[CornerSystem::pair(0, 1)]});
    add_corner(system, 0, edge.a), add_corner(system, 1, edge.b);
  }

  /// A vertex is to move by `pull`, of which `m` counts.
  void add_vertex(int v, const Symmetric3& m, const Vector3& pull, double weight) {
    diagonal_[v] += m * weight;
    force_[v] += weight * pull;
  }

  /// Some steps of the conjugate gradient method: far enough that neighbours know of each other;
  /// the samples are matched anew before an exact solution would be worth its time.
  std::vector<Vector3> solve(const Parallel& parallel) {
    hold();
    std::vector<Vector3> x(force_.size(), Vector3::Zero()), direction, image(force_.size());
    precondition(direction, parallel);
    double height = dot(force_, direction);
    for (int step = 0; step < steps && height > 0.0; ++step) {
      multiply(direction, image, parallel);
      const double bend = dot(direction, image);
      if (!(bend > 0.0)) break;
      const double length = height / bend;
      for (std::size_t v = 0; v < x.size(); ++v)
        x[v] += length * direction[v], force_[v] -= length * image[v];
      precondition(scaled_force_, parallel);
      const double next = dot(force_, scaled_force_);
      for (std::size_t v = 0; v < x.size(); ++v)
        direction[v] = scaled_force_[v] + (next / height) * direction[v];
      height = next;
    }
    return x;
  }

 private:
  static constexpr int steps = 5;
  static constexpr double slack = 1e-4;  // of the trace: lets vertices slide along the surface

  void add_corner(const CornerSystem& system, int corner, int v) {
    diagonal_[v] += system.matrix[CornerSystem::pair(corner, corner)];
    force_[v] += system.force[corner];
  }

  void hold() {
    for (std::size_t v = 0; v < force_.size(); ++v) {
      diagonal_[v] = diagonal_[v].plus_diagonal(slack * diagonal_[v].trace());
      if (is_held(static_cast<int>(v))) force_[v].setZero();
    }
  }

  /// A vertex that may not move, or that no sample asks anything of.
  bool is_held(int v) const { return fixed_[v] != 0 || !(diagonal_[v].trace() > 0.0); }

  void precondition(std::vector<Vector3>& result, const Parallel& parallel) const {
    result.resize(force_.size());
    parallel.for_each(static_cast<int>(force_.size()), [&](int v) {
      result[v] =
          is_held(v) ? Vector3(Vector3::Zero()) : Factorization3(diagonal_[v]).solve(force_[v]);
    });
  }

  void multiply(const std::vector<Vector3>& x, std::vector<Vector3>& result,
                const Parallel& parallel) const {
    parallel.for_each(static_cast<int>(x.size()), [&](int v) {
      result[v] = diagonal_[v] * x[v];
      for (int f : connectivity_.faces_of(v)) {
        const int i = connectivity_.corner(f, v), next = (i + 1) % 3, last = (i + 2) % 3;
        const Face& face = connectivity_.face(f);
        result[v] += face_ties_[f].with_next(i) * x[face[next]];
        result[v] += face_ties_[f].with_next(last) * x[face[last]];
      }
    });
    for (const auto& [edge, tie] : edge_ties_) {
      result[edge.a] += tie * x[edge.b];
      result[edge.b] += tie * x[edge.a];
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
  std::vector<CornerTies> face_ties_;                   // by face
  std::vector<std::pair<Edge, Symmetric3>> edge_ties_;  // of the boundary
  std::vector<Symmetric3> diagonal_;                    // by vertex
  std::vector<Vector3> force_, scaled_force_;           // by vertex
};

}  // namespace curvdecim::detail
