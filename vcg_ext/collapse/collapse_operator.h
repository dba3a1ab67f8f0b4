// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/collapse/collapse_observer.h"
#include "vcg_ext/collapse/edge_queue.h"
#include "vcg_ext/collapse/parts.h"
#include "vcg_ext/collapse/price_unit.h"
#include "vcg_ext/collapse/topology_operator.h"
#include "vcg_ext/collapse/vertex_pairs.h"
#include "vcg_ext/guard/attribute_guard.h"
#include "vcg_ext/guard/collapse_guards.h"
#include "vcg_ext/guard/collapse_rule.h"
#include "vcg_ext/mesh/vertex_ring.h"
#include "vcg_ext/metric/metric.h"

namespace curvdecim::detail {

/// Evaluates edges, asks the guards, does single collapses: what every schedule shares. Calls that
/// look may run at the same time, and so may collapses whose neighbourhoods share no vertex.
/// MetricType: metric/metric.h.
template <class MetricType>
class CollapseOperator {
  static_assert(require_metric<MetricType>());

 public:
  /// Reused from edge to edge; every thread has its own, on cache lines of its own.
  struct alignas(128) Scratch {
    std::vector<int> neighbors;  // of the vertex last estimated for, that may collapse with it
    std::vector<double> costs;   // of the edges to them
    EdgeNeighborhood around;     // of the edge asked about or collapsed last
    EdgeCharts charts;           // around it, where corners are told apart
    VertexRing ring;             // of the vertex last chosen for
    std::vector<EdgeChoice> options;
    std::vector<FacePlane> after;  // of the star, were the edge asked about last collapsed
    CrossingGuard::Star crossing;  // the same, where faces may not cross
  };

  CollapseOperator(WorkingMesh& mesh, MetricType& metric, const CollapseLimits& limits,
                   const PriceUnit& price_unit, CollapseObservers observers)
      : mesh_(mesh),
        metric_(metric),
        topology_(limits.keeps_topology),
        price_unit_(price_unit),
        rule_(mesh, limits),
        guards_(mesh, limits),
        classifier_(mesh.connectivity),
        observers_(std::move(observers)),
        topology_operator_(mesh, metric, guards_, observers_) {
    if (mesh.weighs_attributes()) attribute_guard_.emplace(mesh, limits.attribute_weight);
    if (const ObstaclePrice* price = guards_.obstacle_price())
      observers_.push_back(&parts_.emplace(mesh, price_unit, *price));
  }

  int valence(int v) const { return mesh_.connectivity.faces_of(v).size(); }
  bool is_hub(int v) const { return mesh_.connectivity.is_hub(v); }

  /// The pairs are contracted like edges; only one collapse at a time is possible then.
  void add_pairs(VertexPairs pairs) { pairs_ = std::move(pairs); }

  bool has_pairs() const { return pairs_.active(); }

  /// From now on every collapse is to be told of by update_around().
  void prevent_crossings(const Parallel& parallel) { guards_.prevent_crossings(parallel); }

  /// nullptr: faces may cross.
  const CrossingGuard* crossing_guard() const { return guards_.crossing_guard(); }

  /// Where faces may not cross: v has other faces now. Not while questions are asked.
  void update_around(int v) {
    if (CrossingGuard* guard = guards_.crossing_guard()) guard->update_around(v);
  }

  /// An edge of more faces is no candidate.
  void set_most_faces(int faces) { most_faces_ = faces; }

  // --- candidates -------------------------------------------------------------------------------

  /// Whether it is an edge or a pair still.
  bool exists(Edge edge) const {
    return mesh_.connectivity.has_edge(edge.a, edge.b) ||
           (pairs_.contains(edge.a, edge.b) && valence(edge.a) > 0 && valence(edge.b) > 0);
  }

  /// What v may merge with: its neighbours, and its partners in pairs.
  void gather_mates(int v, VertexRing& mates) const {
    gather_ring(mesh_, v, mates);
    if (mates.empty()) return;
    for (int u : pairs_.of(v))
      if (valence(u) > 0 && !mesh_.connectivity.has_edge(u, v))
        mates.push_back({u, Vector3::Zero()});
  }

  /// nullopt: its faces, the kinds of its ends, or the metric, forbid it.
  std::optional<Candidate> evaluate(Edge edge) const {
    return evaluate(edge, wings_of(mesh_, edge));
  }

  /// Onto its ends, the cheaper one first, where it may collapse to anywhere.
  std::vector<Candidate> onto_ends(Edge edge) const {
    std::vector<Candidate> ends;
    if (rule_(edge) != Allowed::Anywhere || has_too_many_faces(edge)) return ends;
    for (const Allowed end : {Allowed::OntoA, Allowed::OntoB})
      if (auto candidate = metric_.evaluate(edge, end, wings_of(mesh_, edge))) {
        candidate->cost *= importance(edge);
        ends.push_back(*candidate);
      }
    if (ends.size() == 2 && ends[1].cost < ends[0].cost) std::swap(ends[0], ends[1]);
    return ends;
  }

  /// The edge between v and its neighbour, as a choice of its lower vertex; none where it may not
  /// collapse.
  EdgeChoice choice(int v, const RingVertex& neighbor) const {
    const Edge edge{std::min(v, neighbor.vertex), std::max(v, neighbor.vertex)};
    const std::optional<Candidate> candidate = evaluate(edge, neighbor.wings);
    if (!candidate) return {};
    return {priority(edge, candidate->cost), edge.b};
  }

  Priority priority(Edge edge, double cost) const {
    return {cost, (mesh_.position[edge.a] - mesh_.position[edge.b]).squaredNorm()};
  }

  /// The cheapest edge of v to a neighbour with a higher index.
  EdgeChoice cheapest(int v, Scratch& scratch) const {
    gather_options(v, scratch);
    if (scratch.options.empty()) return {};
    return *std::min_element(scratch.options.begin(), scratch.options.end());
  }

  /// The same by estimates, where edges may collapse to anywhere.
  EdgeChoice about_cheapest(int v, Scratch& scratch) const {
    if (is_hub(v) || !rule_.is_free(v) || !gather_free_neighbors(v, scratch.neighbors))
      return cheapest(v, scratch);
    metric_.estimate(v, scratch.neighbors, scratch.costs);
    EdgeChoice best;
    for (std::size_t i = 0; i < scratch.neighbors.size(); ++i) {
      const Edge edge{v, scratch.neighbors[i]};
      best = std::min(best, {priority(edge, scratch.costs[i] * importance(edge)), edge.b});
    }
    return best;
  }

  /// The edges of v to neighbours with a higher index, as options in the scratch.
  void gather_options(int v, Scratch& scratch) const {
    scratch.options.clear();
    gather_mates(v, scratch.ring);
    for (const RingVertex& u : scratch.ring) {
      if (u.vertex < v) continue;
      if (const EdgeChoice option = choice(v, u); option.exists())
        scratch.options.push_back(option);
    }
  }

  /// The guards' answer, were the edge collapsed so. Leaves its neighbourhood in the scratch.
  /// One that is dearer than `most` is of no use: whether faces would cross is not asked then.
  GuardAnswer ask(Edge edge, const Candidate& candidate, Priority most, Scratch& scratch) const {
    const GuardAnswer answer = ask_around(edge, candidate, scratch);
    if (answer.refusal || answer.obstacle.exists() ||
        most < priority(edge, candidate.cost + answer.price) ||
        guards_.keeps_apart(scratch.around, candidate.position, scratch.after, scratch.crossing))
      return answer;
    return {Rejection::Crossing};
  }

  /// The same without a look at what lies beyond the neighbourhood.
  GuardAnswer ask_around(Edge edge, const Candidate& candidate, Scratch& scratch) const {
    scratch.around.gather(mesh_.connectivity, edge);
    GuardAnswer answer = guards_.ask(scratch.around, candidate.position, scratch.after);
    if (!answer.refusal && attribute_guard_) ask_attributes(edge, candidate, scratch, answer);
    if (answer.price > 0.0) answer.price = importance(edge) * price_unit_(answer.price);
    return answer;
  }

  /// Settles what was left open of an answer, if it has to be known: the collapse was asked about
  /// last, and is to be done.
  void settle(GuardAnswer& answer) const {
    if (!answer.refusal && !answer.obstacle.exists()) guards_.settle(answer);
  }

  // --- collapse ---------------------------------------------------------------------------------

  /// Called before collapses with numbers below `count`.
  void make_room(int count) {
    for (CollapseObserver* observer : observers_) observer->make_room(count);
  }

  struct Done {
    int keep, gone;
    Removed removed;  // still to be counted
  };

  /// Collapses the edge asked about last, as the guards allowed it.
  Done collapse(const Candidate& candidate, double error_bound, int number, Scratch& scratch) {
    const EdgeNeighborhood& around = scratch.around;
    assert(scratch.after.size() == around.star().size());
    const VertexMerge done = merge_of(around.edge(), candidate, mesh_.position);
    guards_.accept(around, error_bound);
    metric_.release(around, scratch.after);
    if (mesh_.wedges.exist() && !attribute_guard_) scratch.charts.gather(mesh_, around, done);
    for (CollapseObserver* observer : observers_)
      observer->before(mesh_, around, scratch.charts, done, number);
    if (mesh_.wedges.exist()) merge_wedges(mesh_, around, scratch.charts);
    mesh_.note_merge(done.gone, done.keep);
    mesh_.position[done.keep] = candidate.position;
    Removed removed = mesh_.connectivity.collapse(done.keep, done.gone);
    if (!topology_) removed += remove_duplicates(around);
    mesh_.kind[done.keep] = std::max(mesh_.kind[done.keep], mesh_.kind[done.gone]);
    if (!mesh_.importance.empty())
      mesh_.importance[done.keep] +=
          done.t * (mesh_.importance[done.gone] - mesh_.importance[done.keep]);
    if (pairs_.active()) follow(done, around);
    for (std::size_t i = 0; i < around.star().size(); ++i)
      mesh_.plane[around.star()[i]] = scratch.after[i];
    if (!mesh_.on_seam.empty()) mesh_.on_seam[done.keep] |= mesh_.on_seam[done.gone];
    metric_.merge(done, around);
    if (is_on_seam(mesh_, done.keep)) follow_seams(done, around);
    return {done.keep, done.gone, removed};
  }

  /// How the error is bounded: guard/collapse_bound.h.
  CollapseBound& bound() { return guards_.bound(); }

  void renumber(const Renumbering& numbers) {
    mesh_.renumber(numbers), metric_.renumber(numbers), guards_.renumber(numbers);
    for (CollapseObserver* observer : observers_) observer->renumber(numbers);
  }

  // --- what gives way, one at a time ------------------------------------------------------------

  /// Those that may vanish; nullptr: none may.
  Parts* parts() { return parts_ ? &*parts_ : nullptr; }

  void remove(const Part& part, Tally& tally) { topology_operator_.remove(part, tally); }

  /// The obstacle to the edge's collapse gives way. Returns the vertices that have other faces now;
  /// none: it is not possible here. next_number: of the next collapse; moves on.
  std::vector<int> clear(Edge edge, const Obstacle& obstacle, int& next_number, Tally& tally) {
    return topology_operator_.clear(edge, obstacle, next_number, tally);
  }

 private:
  std::optional<Candidate> evaluate(Edge edge, const Vector3& wings) const {
    const std::optional<Allowed> allowed = rule_(edge);
    if (!allowed || has_too_many_faces(edge)) return std::nullopt;
    std::optional<Candidate> candidate = metric_.evaluate(edge, *allowed, wings);
    if (candidate) candidate->cost *= importance(edge);
    return candidate;
  }

  bool has_too_many_faces(Edge edge) const {
    return mesh_.kind[edge.a] >= VertexKind::Curve && mesh_.kind[edge.b] >= VertexKind::Curve &&
           mesh_.connectivity.edge_valence(edge.a, edge.b) > most_faces_;
  }

  /// The charts of the collapse, in the scratch, and what it does to what they carry.
  void ask_attributes(Edge edge, const Candidate& candidate, Scratch& scratch,
                      GuardAnswer& answer) const {
    scratch.charts.gather(mesh_, scratch.around, merge_of(edge, candidate, mesh_.position));
    const auto price = attribute_guard_->price(scratch.around, scratch.charts);
    if (price)
      answer.price += *price;
    else
      answer = {Rejection::TextureFlip};
  }

  double importance(Edge edge) const {
    return mesh_.importance.empty() ? 1.0 : mesh_.importance[edge.a] + mesh_.importance[edge.b];
  }

  /// The neighbours with a higher index, each from the face that it follows v in: where faces are
  /// not oriented alike some are missed, others come twice. False if one of them is not free.
  bool gather_free_neighbors(int v, std::vector<int>& neighbors) const {
    neighbors.clear();
    for (int f : mesh_.connectivity.faces_of(v)) {
      const int u = mesh_.connectivity.next_vertex(f, v);
      if (u < v) continue;
      if (!rule_.is_free(u)) return false;
      if (!rule_.pinches({v, u})) neighbors.push_back(u);
    }
    return true;
  }

  /// Parts that touch make junctions, and seams that close none: the kinds are told anew. A locked
  /// vertex has no pairs.
  void follow(const VertexMerge& done, const EdgeNeighborhood& around) {
    pairs_.merge(done.keep, done.gone);
    if (mesh_.locked[done.keep]) pairs_.forget(done.keep);
    const auto classify = [&](int v) {
      mesh_.kind[v] = classifier_.classify(v);
      update_seam(mesh_, v);
    };
    classify(done.keep);
    for (int v : around.thirds()) classify(v);
    for (int f : around.star())
      for (int v : mesh_.connectivity.face(f))
        if (v != TriangleConnectivity::dead && v != done.keep) classify(v);
  }

  /// A chart may have vanished, or come to touch itself.
  void follow_seams(const VertexMerge& done, const EdgeNeighborhood& around) {
    update_seam(mesh_, done.keep);
    for (int v : around.thirds()) update_seam(mesh_, v);
  }

  /// Where the link condition was not asked for, faces may have fallen onto each other.
  Removed remove_duplicates(const EdgeNeighborhood& around) {
    TriangleConnectivity& connectivity = mesh_.connectivity;
    Removed removed;
    for (int f : around.star()) {
      if (!connectivity.alive(f)) continue;
      const Face& face = connectivity.face(f);
      for (int g : around.star())
        if (g > f && connectivity.alive(g) && connectivity.face_has(g, face[0]) &&
            connectivity.face_has(g, face[1]) && connectivity.face_has(g, face[2]))
          removed += connectivity.remove_face(g);
    }
    return removed;
  }

  WorkingMesh& mesh_;
  MetricType& metric_;
  const bool topology_;
  int most_faces_ = std::numeric_limits<int>::max();
  const PriceUnit price_unit_;
  const CollapseRule rule_;
  CollapseGuards guards_;
  std::optional<AttributeGuard> attribute_guard_;  // where they count
  VertexPairs pairs_;
  VertexClassifier classifier_;  // where there are pairs
  CollapseObservers observers_;
  TopologyOperator<MetricType> topology_operator_;
  std::optional<Parts> parts_;  // where the topology gives way
};

}  // namespace curvdecim::detail
