// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/curvature/current_curvature.h"
#include "vcg_ext/curvature/curvature_field.h"
#include "vcg_ext/curvature/curvature_weight.h"
#include "vcg_ext/mesh/vertex_ring.h"
#include "vcg_ext/metric/quadric_metric.h"

namespace curvdecim::detail {

/// Quadric error times a factor that grows with the curvature at both ends @cite pellizzoni2020,
/// equation 8. The curvature is that of the current mesh, as in the paper, or that of the input,
/// which a merged vertex has by area from the two it came from. With the input's, ScaleFree gives
/// one root of the factor to the planes, so that vertices are drawn to curved places too, and the
/// other to the cost.
class CurvatureWeightedMetric {
 public:
  CurvatureWeightedMetric(const WorkingMesh& mesh, const CurvatureWeightedPlan& plan)
      : mesh_(mesh), plan_(plan), quadric_(mesh, plan.quadrics), current_(mesh) {}

  void initialize(const Parallel& parallel) {
    measure(parallel);
    quadric_.initialize(parallel, weighs_planes() ? roots(parallel) : std::vector<float>());
    if (follows_current()) current_.initialize(parallel);
  }

  // --- passes (passes/)
  // ---------------------------------------------------------------------------

  bool allows_passes() const { return weighs_planes() && quadric_.allows_passes(); }

  /// By vertex. They are the passes' until resume().
  std::vector<PassWeight> take_weights(const Parallel& parallel) {
    const auto saturation = std::exchange(saturation_, {}), area = std::exchange(area_, {});
    const std::vector<float> factor = quadric_.take_factors();
    std::vector<PassWeight> weights(saturation.size());
    parallel.for_each(static_cast<int>(weights.size()), [&](int v) {
      weights[v] = {saturation[v], area[v], factor[v]};
    });
    return weights;
  }

  /// The weight of a vertex that two have become.
  PassWeight merged(const PassWeight& keep, const PassWeight& gone) const {
    const double saturation = averaged(keep.saturation, keep.area, gone.saturation, gone.area);
    return {static_cast<float>(saturation), keep.area + gone.area,
            static_cast<float>(root(saturation))};
  }

  std::vector<SmallQuadric> remember(const Parallel& parallel) {
    measure(parallel);
    return quadric_.remember(parallel, roots(parallel));
  }

  void resume(const std::vector<SmallQuadric>& memory, const std::vector<PassWeight>& weights,
              const Parallel& parallel) {
    std::vector<float> factors(weights.size());
    saturation_.resize(weights.size()), area_.resize(weights.size());
    for (std::size_t v = 0; v < weights.size(); ++v) {
      const PassWeight& weight = weights[v];
      saturation_[v] = weight.saturation, area_[v] = weight.area, factors[v] = weight.factor;
    }
    quadric_.resume(memory, std::move(factors), parallel);
  }

  // --- costs
  // ----------------------------------------------------------------------------------------

  std::optional<Candidate> evaluate(Edge edge, Allowed allowed, const Vector3& wings) const {
    std::optional<Candidate> candidate = quadric_.evaluate(edge, allowed, wings);
    if (candidate) candidate->cost *= factor(edge);
    return candidate;
  }

  void estimate(int v, const std::vector<int>& others, std::vector<double>& costs) const {
    quadric_.estimate(v, others, costs);
    for (std::size_t i = 0; i < others.size(); ++i) costs[i] *= factor({v, others[i]});
  }

  void release(const EdgeNeighborhood& around, const std::vector<FacePlane>& after) {
    const auto [a, b] = around.edge();
    quadric_.release(around, after, weighs_planes() ? root(averaged(a, b)) : 1.0);
    if (follows_current()) current_.release(around);
  }

  void merge(const VertexMerge& merge, const EdgeNeighborhood& around) {
    if (!follows_current()) average(merge.keep, merge.gone);
    if (weighs_planes()) quadric_.set_factor(merge.keep, root(saturation_[merge.keep]));
    quadric_.merge(merge, around);
    if (!follows_current()) return;
    current_.merge(merge.keep, around);
    update(merge.keep);
    VertexRing ring;
    gather_ring(mesh_, merge.keep, ring);
    for (const RingVertex& u : ring) update(u.vertex);
  }

  void renew(int v, int source) {
    saturation_[v] = saturation_[source];
    if (v != source) area_[v] = area_[source] *= 0.5f;
    quadric_.renew(v, source);
    if (follows_current()) current_.renew(v), update(v);
  }

  void renumber(const Renumbering& numbers) {
    quadric_.renumber(numbers), current_.renumber(numbers);
    numbers.vertices(saturation_), numbers.vertices(area_);
  }

 private:
  void measure(const Parallel& parallel) {
    const CurvatureField field = curvature_field(mesh_, plan_.curvature, parallel);
    weight_ = curvature_weight(plan_.curvature, field, plan_.diagonal);
    area_.assign(field.area.begin(), field.area.end());
    saturation_.resize(field.value.size());
    parallel.for_each(static_cast<int>(saturation_.size()), [&](int v) {
      saturation_[v] = static_cast<float>(weight_.saturation(field.value[v]));
    });
  }

  bool follows_current() const { return plan_.curvature.curvature_of == CurvatureOf::Current; }

  /// Not where the curvature changes away from the merge.
  bool weighs_planes() const {
    return plan_.curvature.alpha_units == AlphaUnits::ScaleFree && !follows_current();
  }

  double factor(Edge edge) const {
    if (weighs_planes()) return 0.5 * (quadric_.factor(edge.a) + quadric_.factor(edge.b));
    return weight_.of_edge(saturation_[edge.a], saturation_[edge.b]);
  }

  double root(double saturation) const { return std::sqrt(weight_.factor(saturation)); }

  std::vector<float> roots(const Parallel& parallel) const {
    std::vector<float> roots(saturation_.size());
    parallel.for_each(static_cast<int>(roots.size()),
                      [&](int v) { roots[v] = static_cast<float>(root(saturation_[v])); });
    return roots;
  }

  void update(int v) {
    saturation_[v] =
        static_cast<float>(weight_.saturation(current_.at(v).measure(plan_.curvature)));
  }

  /// By the input's area that has gone into each.
  static double averaged(double kept, double kept_area, double gone, double gone_area) {
    const double area = kept_area + gone_area;
    return area > 0.0 ? kept + gone_area / area * (gone - kept) : kept;
  }
  double averaged(int keep, int gone) const {
    return averaged(saturation_[keep], area_[keep], saturation_[gone], area_[gone]);
  }

  void average(int keep, int gone) {
    saturation_[keep] = static_cast<float>(averaged(keep, gone));
    area_[keep] += area_[gone];
  }

  const WorkingMesh& mesh_;
  const CurvatureWeightedPlan plan_;
  QuadricMetric quadric_;
  CurrentCurvature current_;  // where it is followed
  CurvatureWeight weight_;
  std::vector<float> saturation_;  // by vertex: CurvatureWeight::saturation
  std::vector<float> area_;        // by vertex: of the input, that has gone into it
};

}  // namespace curvdecim::detail
