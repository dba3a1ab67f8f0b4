// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include "vcg_ext/guard/crossing_guard.h"
#include "vcg_ext/mesh/seams.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel/parallel.h"
#include "vcg_ext/refine/input_samples.h"
#include "vcg_ext/refine/mesh_samples.h"
#include "vcg_ext/refine/move_guard.h"
#include "vcg_ext/refine/texture_drift.h"

namespace curvdecim::detail {

/// Flips edges where the other diagonal of the two faces lies closer to the input, measured by the
/// samples of both @cite hoppe1993. The best first; flips of one pass share no vertex.
class EdgeFlips {
 public:
  /// crossing_guard: nullptr where faces may cross.
  EdgeFlips(WorkingMesh& mesh, InputSamples& of_input, MeshSamples& of_mesh, const MoveGuard& guard,
            const TextureDrift& drift, CrossingGuard* crossing_guard)
      : mesh_(mesh),
        of_input_(of_input),
        of_mesh_(of_mesh),
        guard_(guard),
        drift_(drift),
        crossing_guard_(crossing_guard) {}

  /// near: by face, a face of the input near it. Returns the number of flips.
  int run(const std::vector<int>& near, const Parallel& parallel) {
    std::vector<Flip> flips = candidates(near, parallel);
    std::sort(flips.begin(), flips.end());
    flips = apart(flips);
    const auto is_kept = [&](const Flip& flip) { return !apply(flip); };
    flips.erase(std::remove_if(flips.begin(), flips.end(), is_kept), flips.end());
    if (flips.empty()) return 0;
    parallel.for_each(
        static_cast<int>(flips.size()), [&](int i) { match_again(flips[i], near); },
        Parallel::heavy);
    of_input_.sort_by_face(mesh_.connectivity.face_slots(), parallel);
    return static_cast<int>(flips.size());
  }

 private:
  /// A flip of the edge from a to b between f = (a, b, c) and g = (b, a, d).
  struct Flip {
    int f = -1, g = -1, a = -1, b = -1, c = -1, d = -1;
    float gain = 0.0f;

    bool operator<(const Flip& o) const {
      return std::tuple(-gain, f, g, a) < std::tuple(-o.gain, o.f, o.g, o.a);
    }
  };

  /// The two faces after a flip.
  struct Pair {
    std::array<Triangle, 2> triangle;
    std::array<FacePlane, 2> plane;

    explicit Pair(const Triangle& s, const Triangle& t)
        : triangle{s, t}, plane{face_plane(s), face_plane(t)} {}

    double shape() const {
      return std::min(shape_quality(triangle[0], plane[0].area),
                      shape_quality(triangle[1], plane[1].area));
    }
    double fold() const { return plane[0].normal.dot(plane[1].normal); }

    double distance2(const Vector3& p) const {
      double least = std::numeric_limits<double>::infinity();
      for (int i = 0; i < 2; ++i) {
        const double height = plane[i].normal.dot(p - triangle[i][0]);
        if (height * height >= least) continue;
        least = std::min(least, squared_distance(triangle[i], p));
      }
      return least;
    }

    /// Which of the two is nearer to p.
    int nearer(const Vector3& p) const {
      return squared_distance(triangle[1], p) < squared_distance(triangle[0], p) ? 1 : 0;
    }
  };

  static constexpr double worth_while = 0.98;  // of the error before
  static constexpr double least_shape_quality = 0.05;
  static constexpr double least_fold = -0.2;  // cosine between the two normals: no knife's edge
  static constexpr int least_valence = 3;     // a vertex that loses a face has more

  std::vector<Flip> candidates(const std::vector<int>& near, const Parallel& parallel) const {
    std::vector<std::array<float, 3>> gains(mesh_.connectivity.face_slots());
    parallel.for_each(
        mesh_.connectivity.face_slots(),
        [&](int f) {
          for (int i = 0; i < 3; ++i) gains[f][i] = static_cast<float>(gain(flip_of(f, i), near));
        },
        Parallel::heavy);
    std::vector<Flip> flips;
    for (int f = 0; f < mesh_.connectivity.face_slots(); ++f)
      for (int i = 0; i < 3; ++i)
        if (gains[f][i] > 0.0f) {
          flips.push_back(flip_of(f, i));
          flips.back().gain = gains[f][i];
        }
    return flips;
  }

  /// Each edge comes up at its lower face; g is -1 where there is nothing to flip.
  Flip flip_of(int f, int corner) const {
    const TriangleConnectivity& connectivity = mesh_.connectivity;
    const int a = connectivity.face(f)[corner], b = connectivity.face(f)[(corner + 1) % 3],
              g = face_across(f, a, b);
    if (g < f) return {};
    return {f, g, a, b, connectivity.third_vertex(f, a, b), connectivity.third_vertex(g, a, b)};
  }

  /// How much of the error the flip takes off; 0 where the edge is not to be flipped.
  double gain(const Flip& flip, const std::vector<int>& near) const {
    if (flip.g < 0) return 0.0;
    const double before = error(flip);
    if (!(before > 0.0) || !keeps_surface(flip)) return 0.0;
    const auto [a, b, c, d] = positions(flip);
    const Pair now({a, b, c}, {b, a, d}), then({a, d, c}, {d, b, c});
    if (!keeps_shape(now, then)) return 0.0;
    const double after = error_after(flip, then, worth_while * before, near[flip.f]);
    const bool is_better = after < worth_while * before && faces_input(now, then, near[flip.f]);
    return is_better ? before - after : 0.0;
  }

  /// The one other face at the edge, if it runs the other way along it, or -1.
  int face_across(int f, int a, int b) const {
    const TriangleConnectivity& connectivity = mesh_.connectivity;
    if (connectivity.is_hub(a)) std::swap(a, b);
    int across = -1;
    for (int g : connectivity.faces_of(a)) {
      if (g == f || !connectivity.face_has(g, b)) continue;
      if (across >= 0) return -1;
      across = g;
    }
    return across >= 0 && connectivity.next_vertex(across, b) == a ? across : -1;
  }

  double error(const Flip& flip) const {
    double sum = 0.0;
    for (int f : {flip.f, flip.g}) {
      for (int i : of_input_.of_face(f)) sum += of_input_.weight(i) * of_input_.distance2(i);
      sum += of_mesh_.error(mesh_, f);
    }
    return drift_.counts() ? sum + drift(flip) : sum;
  }

  /// What is locked, seams, and the link condition @cite dey1999: no second edge from c to d.
  bool keeps_surface(const Flip& flip) const {
    const TriangleConnectivity& connectivity = mesh_.connectivity;
    if (flip.c == flip.d || is_locked(flip.f) || is_locked(flip.g)) return false;
    if (connectivity.faces_of(flip.a).size() <= least_valence ||
        connectivity.faces_of(flip.b).size() <= least_valence)
      return false;
    if (is_seam_edge(mesh_, flip.f, flip.a, flip.b) || turns_over_in_texture(flip)) return false;
    return !connectivity.has_edge(flip.c, flip.d);
  }

  bool turns_over_in_texture(const Flip& flip) const {
    if (mesh_.texture.empty()) return false;
    const auto [a, b, c, d] = in_texture(flip);
    const double before = texture_area({a, b, c}) + texture_area({b, a, d});
    return is_turned_over(before, texture_area({a, d, c})) ||
           is_turned_over(before, texture_area({d, b, c}));
  }

  /// The places of a, b, c and d.
  std::array<Vector2, 4> in_texture(const Flip& flip) const {
    const auto at = [&](int f, int v) {
      return mesh_.texture[mesh_.wedges.at(mesh_.connectivity, f, v)];
    };
    return {at(flip.f, flip.a), at(flip.f, flip.b), at(flip.f, flip.c), at(flip.g, flip.d)};
  }

  /// A face that may not change has locked corners.
  bool is_locked(int f) const {
    const auto [a, b, c] = mesh_.connectivity.face(f);
    return mesh_.locked[a] != 0 && mesh_.locked[b] != 0 && mesh_.locked[c] != 0;
  }

  std::array<Vector3, 4> positions(const Flip& flip) const {
    return {mesh_.position[flip.a], mesh_.position[flip.b], mesh_.position[flip.c],
            mesh_.position[flip.d]};
  }

  static bool keeps_shape(const Pair& now, const Pair& then) {
    const Vector3 up = now.plane[0].area_vector() + now.plane[1].area_vector();
    for (const FacePlane& plane : then.plane)
      if (!(plane.normal.dot(up) > 0.0)) return false;
    const double shape = then.shape();
    return (shape >= least_shape_quality || shape >= now.shape()) &&
           then.fold() >= std::min(least_fold, now.fold());
  }

  bool faces_input(const Pair& now, const Pair& then, int hint) const {
    const auto facing = [&](const Triangle& t) { return guard_.facing(t, hint); };
    const double before = std::min(facing(now.triangle[0]), facing(now.triangle[1]));
    return guard_.faces_input(then.triangle[0], before, hint) &&
           guard_.faces_input(then.triangle[1], before, hint);
  }

  /// Ends early where it is more than `most`.
  double error_after(const Flip& flip, const Pair& then, double most, int hint) const {
    double sum = 0.0;
    for (int f : {flip.f, flip.g})
      for (int i : of_input_.of_face(f)) {
        sum += of_input_.weight(i) * then.distance2(of_input_.point(i));
        if (sum >= most) return sum;
      }
    for (int i = 0; i < 2; ++i) {
      MeshSamples::OfFace samples;
      of_mesh_.match_face(then.triangle[i], then.plane[i], hint, samples);
      sum += of_mesh_.error(samples, then.plane[i].area);
      if (sum >= most) return sum;
    }
    return drift_.counts() ? sum + drift_after(flip, then) : sum;
  }

  /// In the texture.
  double drift(const Flip& flip) const {
    double sum = 0.0;
    for (int f : {flip.f, flip.g})
      for (int i : of_input_.of_face(f))
        sum += drift_.of(f, mesh_.texture_triangle(f), of_input_.match(mesh_.triangle(f), i));
    return sum;
  }

  double drift_after(const Flip& flip, const Pair& then) const {
    const auto [a, b, c, d] = in_texture(flip);
    const std::array<TextureTriangle, 2> texture = {{{a, d, c}, {d, b, c}}};
    double sum = 0.0;
    for (int f : {flip.f, flip.g})
      for (int i : of_input_.of_face(f)) {
        const int nearer = then.nearer(of_input_.point(i));
        sum += drift_.of(flip.f, texture[nearer], of_input_.match(then.triangle[nearer], i));
      }
    return sum;
  }

  std::vector<Flip> apart(const std::vector<Flip>& flips) const {
    std::vector<Flip> chosen;
    std::vector<std::uint8_t> taken(mesh_.connectivity.vertex_slots(), 0);
    for (const Flip& flip : flips) {
      const std::array<int, 4> corners = {flip.a, flip.b, flip.c, flip.d};
      if (std::any_of(corners.begin(), corners.end(), [&](int v) { return taken[v] != 0; }))
        continue;
      for (int v : corners) taken[v] = 1;
      chosen.push_back(flip);
    }
    return chosen;
  }

  /// False, and nothing is done, where faces would cross that may not.
  bool apply(const Flip& flip) {
    if (crossing_guard_ && !crossing_guard_->allows(changed_by(flip))) return false;
    if (mesh_.wedges.exist()) mesh_.wedges.flip(mesh_.connectivity, flip.f, flip.g, flip.a, flip.b);
    mesh_.connectivity.flip(flip.f, flip.g, flip.a, flip.b);
    mesh_.update_plane(flip.f), mesh_.update_plane(flip.g);
    if (crossing_guard_) crossing_guard_->update(flip.f), crossing_guard_->update(flip.g);
    return true;
  }

  /// The corners are in the order in which they will be.
  CrossingGuard::Star changed_by(const Flip& flip) const {
    CrossingGuard::Star changed;
    const auto add = [&](int f, int from, int to) {
      Triangle t = mesh_.triangle(f);
      t[mesh_.connectivity.corner(f, from)] = mesh_.position[to];
      changed.add(f, t);
    };
    add(flip.f, flip.b, flip.d), add(flip.g, flip.a, flip.c);
    return changed;
  }

  void match_again(const Flip& flip, const std::vector<int>& near) {
    of_input_.match_among(mesh_, flip.f, flip.g);
    for (int f : {flip.f, flip.g}) of_mesh_.match_face(mesh_, f, near[f]);
  }

  WorkingMesh& mesh_;
  InputSamples& of_input_;
  MeshSamples& of_mesh_;
  const MoveGuard& guard_;
  const TextureDrift& drift_;
  CrossingGuard* const crossing_guard_;
};

}  // namespace curvdecim::detail
