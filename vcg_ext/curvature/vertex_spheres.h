// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "vcg_ext/geometry/sphere_fit.h"
#include "vcg_ext/mesh/sharp_edges.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel/parallel.h"
#include "vcg_ext/params.h"

namespace curvdecim::detail {

/// What a vertex gives to the fits around it.
struct SphereSample {
  Vector3 normal = Vector3::Zero();  // unit; zero where there is no area
  double area = 0.0;                 // a third of the faces around
  double edge = 0.0;                 // mean length of the edges around
  bool sharp = false;                // end of a sharp edge, or where several sheets meet
};

/// Weight of a point at a distance, both squared: (1 - (d/h)^2)^4 @cite guennebaud2007.
inline double kernel_weight(double distance2, double radius2) {
  const double rest = distance2 < radius2 ? 1.0 - distance2 / radius2 : 0.0;
  return rest * rest * rest * rest;
}

/// Fits an algebraic sphere to the neighbourhood of every vertex, about that vertex @cite
/// guennebaud2008. Neighbours are gathered ring by ring within the kernel's radius and end at sharp
/// edges, so that a sphere sees one side of an edge only; that of a sharp vertex sees all sides.
class VertexSpheres {
 public:
  /// feature_angle: degrees, of a sharp edge.
  VertexSpheres(const WorkingMesh& mesh, const KernelParams& kernel, double feature_angle,
                const Parallel& parallel)
      : mesh_(mesh), kernel_(kernel), parallel_(parallel), sample_(mesh.position.size()) {
    const SharpVertices is_sharp(mesh, smooth_part * feature_angle);
    parallel.for_each(static_cast<int>(sample_.size()), [&](int v) {
      sample_[v] = sample(v);
      sample_[v].sharp = mesh_.kind[v] >= VertexKind::Curve || is_sharp(v);
    });
  }

  const SphereSample& sample_of(int v) const { return sample_[v]; }

  std::vector<AlgebraicSphere> fit() const {
    std::vector<AlgebraicSphere> spheres(sample_.size());
    std::vector<Gathering> gatherings(parallel_.threads());
    parallel_.for_ranges(
        static_cast<int>(spheres.size()),
        [&](int begin, int end, int worker) {
          for (int v = begin; v < end; ++v) spheres[v] = fit(v, gatherings[worker]);
        },
        Parallel::heavy);
    return spheres;
  }

 private:
  /// Part of the feature angle: where faces turn by more, no sphere is near both.
  static constexpr double smooth_part = 0.5;
  /// The kernel shrinks where the fit is off by more than `bad` and grows where it is off by less
  /// than `good`, root of the weighted mean square to the mean edge around, each time by `step`.
  static constexpr double bad = 0.05, good = 0.005, step = 1.5;
  static constexpr int most_steps = 2;
  static constexpr int hub = 64;              // faces of a vertex that fits do not reach over
  static constexpr int most_vertices = 512;   // more tell a fit nothing, and take time
  static constexpr double least_scale = 1.1;  // of the mean edge: about the first ring

  /// Reused from vertex to vertex; every thread has its own.
  struct Gathering {
    std::vector<int> reached_in;  // by vertex: the last gathering that reached it
    int number = 0;
    std::vector<int> vertices;
  };

  struct Fit {
    AlgebraicSphere sphere;
    double residual;  // root of the weighted mean square, to the mean edge
  };

  SphereSample sample(int v) const {
    SphereSample s;
    Vector3 sum = Vector3::Zero();
    for (int f : mesh_.connectivity.faces_of(v)) {
      sum += mesh_.plane[f].area_vector();
      s.area += mesh_.plane[f].area / 3.0;
      for (int u : mesh_.connectivity.face(f))
        s.edge += (mesh_.position[u] - mesh_.position[v]).norm();
    }
    s.edge /= std::max(1, 2 * mesh_.connectivity.faces_of(v).size());
    const double length = sum.norm();
    if (length > 0.0) s.normal = sum / length;
    return s;
  }

  AlgebraicSphere fit(int v, Gathering& gathering) const {
    double scale = kernel_.kernel_scale;
    Fit best = fit(v, scale, gathering);
    if (!kernel_.adaptive_kernel) return best.sphere;
    if (best.residual < good) {
      const Fit wider = fit(v, scale * step, gathering);
      return wider.residual < good ? wider.sphere : best.sphere;
    }
    for (int i = 0; i < most_steps && best.residual > bad && scale > least_scale; ++i) {
      scale = std::max(least_scale, scale / step);
      best = fit(v, scale, gathering);
    }
    return best.sphere;
  }

  Fit fit(int v, double scale, Gathering& gathering) const {
    const double radius2 = scale * scale * sample_[v].edge * sample_[v].edge;
    gather(v, radius2, gathering);
    SphereSums sums;
    for_samples(v, radius2, gathering, [&](const Vector3& offset, const Vector3& normal, double w) {
      sums.add(offset, normal, w);
    });
    const AlgebraicSphere sphere = sums.fit();
    double square = 0.0;
    for_samples(v, radius2, gathering, [&](const Vector3& offset, const Vector3&, double w) {
      const double value = sphere.value(offset);
      square += w * value * value;
    });
    const double unit = sums.weight * sample_[v].edge * sample_[v].edge;
    return {sphere, unit > 0.0 ? std::sqrt(square / unit) : 0.0};
  }

  /// The vertices within the radius that are reached over others within it and not over sharp ones.
  void gather(int v, double radius2, Gathering& gathering) const {
    auto& [reached_in, number, vertices] = gathering;
    reached_in.resize(sample_.size(), 0);
    ++number;
    vertices.assign(1, v), reached_in[v] = number;
    for (std::size_t i = 0; i < vertices.size() && vertices.size() < most_vertices; ++i) {
      const auto faces = mesh_.connectivity.faces_of(vertices[i]);
      if (i > 0 && faces.size() > hub) continue;
      for (int f : faces)
        for (int u : mesh_.connectivity.face(f)) {
          if (reached_in[u] == number) continue;
          reached_in[u] = number;
          if (sample_[u].sharp && !sample_[v].sharp) continue;
          if ((mesh_.position[u] - mesh_.position[v]).squaredNorm() < radius2)
            vertices.push_back(u);
        }
    }
  }

  /// use(offset from v, normal, weight)
  template <class Use>
  void for_samples(int v, double radius2, const Gathering& gathering, Use use) const {
    for (int u : gathering.vertices) {
      const Vector3 offset = mesh_.position[u] - mesh_.position[v];
      use(offset, sample_[u].normal,
          sample_[u].area * kernel_weight(offset.squaredNorm(), radius2));
    }
  }

  const WorkingMesh& mesh_;
  const KernelParams& kernel_;
  const Parallel& parallel_;
  std::vector<SphereSample> sample_;  // by vertex
};

}  // namespace curvdecim::detail
