// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "vcg_ext/geometry/closest_point.h"
#include "vcg_ext/guard/link_condition.h"
#include "vcg_ext/guard/patch_distance.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::detail {

/// A guaranteed bound on the two-sided distance to the input. Every collapse maps the old faces
/// around the edge one to one onto the new ones @cite cohen1997; what a point has moved in all is
/// at most the sum of what each collapse moved it, and every face carries the largest sum in it.
class ErrorBound {
 public:
  using Patch = PatchDistance::Patch;

  /// limit: in the unit of the working mesh; 0 for none.
  ErrorBound(const WorkingMesh& mesh, double limit)
      : limit_(limit), of_face_(limit > 0.0 ? mesh.plane.size() : 0, 0.0) {}

  bool active() const { return limit_ > 0.0; }

  /// The bound of the new faces, were the edge collapsed to x.
  double after(const WorkingMesh& mesh, const EdgeNeighborhood& around, const Vector3& x) const {
    double before = 0.0;
    for (const auto* faces : {&around.wings(), &around.star()})
      for (int f : *faces) before = std::max(before, of_face_[f]);
    return before + moved(mesh, around, x);
  }

  /// How far the collapse moves a point at most.
  static double moved(const WorkingMesh& mesh, const EdgeNeighborhood& around, const Vector3& x) {
    const Vector3 &a = mesh.position[around.edge().a], &b = mesh.position[around.edge().b];
    const double linear =
        std::max((a - x).norm(), (b - x).norm());  // a and b go to x, the rest follows
    if (mesh.connectivity.is_hub(around.edge().a) || mesh.connectivity.is_hub(around.edge().b))
      return linear;  // to look closer takes the square of the faces
    if (around.wings().size() == 2 && !keeps_outline(mesh, around.edge(), x)) return linear;
    Patch after;
    for (int f : around.star()) after.push_back(triangle_after(mesh, f, around.edge(), x));
    const double along =
        around.wings().size() == 2 ? inner(mesh, around, after, x) : outer(mesh, around, after, x);
    return std::min(linear, along);
  }

  bool allows(double bound) const { return bound <= limit_; }
  void set_limit(double limit) { limit_ = limit; }

  void set(const EdgeNeighborhood& around, double bound) {
    for (int f : around.star()) of_face_[f] = bound;
  }

  void renumber(const Renumbering& numbers) { numbers.faces(of_face_); }

 private:
  /// False where an edge that is none of the boundary takes an end off it.
  static bool keeps_outline(const WorkingMesh& mesh, Edge edge, const Vector3& x) {
    const auto keeps = [&](int v) {
      return mesh.kind[v] == VertexKind::Interior || mesh.position[v] == x;
    };
    return keeps(edge.a) && keeps(edge.b);
  }

  static double inner(const WorkingMesh& mesh, const EdgeNeighborhood& around, Patch after,
                      const Vector3& x) {
    Patch before;
    for (const auto* faces : {&around.wings(), &around.star()})
      for (int f : *faces) before.push_back(mesh.triangle(f));
    drop_flat(before), drop_flat(after);
    return PatchDistance::bound(before, after, x).value_or(HUGE_VAL);
  }

  /// On the boundary p a b q becomes p x q: first a and b go to the nearest points of their new
  /// edges and the point of ab nearest to x goes to x, then the outlines agree.
  static double outer(const WorkingMesh& mesh, const EdgeNeighborhood& around, const Patch& after,
                      const Vector3& x) {
    const auto [a, b] = around.edge();
    const int p = boundary_neighbor(mesh, around, a), q = boundary_neighbor(mesh, around, b);
    if (around.wings().size() != 1 || p < 0 || q < 0) return HUGE_VAL;
    const Vector3 to_a = nearest_on(x, mesh.position[p], mesh.position[a]);
    const Vector3 to_b = nearest_on(x, mesh.position[q], mesh.position[b]);
    const Vector3 split = nearest_on(mesh.position[a], mesh.position[b], x);
    Patch before;
    for (int f : around.star())
      before.push_back(triangle_with(mesh, f, mesh.connectivity.face_has(f, a) ? a : b,
                                     mesh.connectivity.face_has(f, a) ? to_a : to_b));
    before.push_back(half_wing(mesh, around, b, x, a, to_a));
    before.push_back(half_wing(mesh, around, a, x, b, to_b));
    const double slide = std::max(
        {(to_a - mesh.position[a]).norm(), (to_b - mesh.position[b]).norm(), (split - x).norm()});
    drop_flat(before);
    return slide + PatchDistance::bound(before, after, x).value_or(HUGE_VAL);
  }

  /// A triangle without area lies on an edge of its neighbours, which stand for it: one of the
  /// input with a vertex on an edge, or at a slid vertex that has come to a corner of the outline.
  static void drop_flat(Patch& patch) {
    constexpr double rounding = 1e-12;  // of the squared edges
    const auto flat = [](const Triangle& t) {
      return !(area_vector(t).norm() > rounding * sum_of_squared_edges(t));
    };
    patch.erase(std::remove_if(patch.begin(), patch.end(), flat), patch.end());
  }

  static Triangle triangle_with(const WorkingMesh& mesh, int f, int v, const Vector3& at) {
    Triangle t = mesh.triangle(f);
    t[mesh.connectivity.corner(f, v)] = at;
    return t;
  }

  /// The wing with one end of the edge at x and the other slid.
  static Triangle half_wing(const WorkingMesh& mesh, const EdgeNeighborhood& around, int end_at_x,
                            const Vector3& x, int slid, const Vector3& to) {
    const int wing = around.wings()[0];
    Triangle t = mesh.triangle(wing);
    t[mesh.connectivity.corner(wing, end_at_x)] = x;
    t[mesh.connectivity.corner(wing, slid)] = to;
    return t;
  }

  static Vector3 nearest_on(const Vector3& a, const Vector3& b, const Vector3& p) {
    const Triangle t{a, b, a};
    return at(t, closest_on_edge(t, 0, p));
  }

  /// The neighbour of v along the boundary, away from the edge; -1 if that is not one vertex.
  static int boundary_neighbor(const WorkingMesh& mesh, const EdgeNeighborhood& around, int v) {
    int found = -1;
    for (int f : mesh.connectivity.faces_of(v))
      for (int u : mesh.connectivity.face(f)) {
        if (u == v || u == around.edge().a || u == around.edge().b) continue;
        if (!is_singular_edge(mesh.connectivity, v, u)) continue;
        if (found >= 0 && found != u) return -1;
        found = u;
      }
    return found;
  }

  double limit_;
  std::vector<double> of_face_;
};

}  // namespace curvdecim::detail
