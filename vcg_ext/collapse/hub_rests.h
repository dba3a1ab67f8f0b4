// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "vcg_ext/collapse/collapse_operator.h"

namespace curvdecim::detail {

/// Asks the guards about edges, but lets hubs rest. A hub is a vertex of very many faces: a
/// question about an edge of it costs as much as it has faces. Once an edge of it was refused, its
/// next edges are refused unseen, until an eighth of its faces may have changed.
///
/// A rest changes with every question about the hub, so that these have to come in one order.
/// Questions about edges whose neighbourhoods share no vertex may be asked at the same time.
template <class MetricType>
class HubRests {
 public:
  using Operator = CollapseOperator<MetricType>;
  using Scratch = typename Operator::Scratch;

  HubRests(const WorkingMesh& mesh, const Operator& collapses)
      : mesh_(mesh), collapses_(collapses), left_(mesh.connectivity.vertex_slots(), 0) {}

  /// The guards' answer, as CollapseOperator::ask gives it. Leaves the edge's neighbourhood in the
  /// scratch, but for HubAtRest.
  GuardAnswer ask(Edge edge, const Candidate& candidate, Priority most, Scratch& scratch) {
    const int busier = collapses_.valence(edge.a) > collapses_.valence(edge.b) ? edge.a : edge.b;
    const bool is_hub = collapses_.is_hub(busier);
    if (is_hub && passes_over(busier)) return {Rejection::HubAtRest};
    const GuardAnswer answer = collapses_.ask(edge, candidate, most, scratch);
    if (is_hub && (answer.refusal || answer.price > 0.0)) send_to_rest(busier);
    return answer;
  }

  /// Settles the answer about the edge asked about last.
  void settle(Edge edge, GuardAnswer& answer) {
    if (answer.refusal) return;
    collapses_.settle(answer);
    const int busier = collapses_.valence(edge.a) > collapses_.valence(edge.b) ? edge.a : edge.b;
    if (answer.refusal && collapses_.is_hub(busier)) send_to_rest(busier);
  }

  /// The cheapest edge of v, to a neighbour with a higher index, that is not refused. Only some of
  /// a hub's edges are asked about.
  EdgeChoice cheapest_possible(int v, Scratch& scratch) {
    collapses_.gather_options(v, scratch);
    std::sort(scratch.options.begin(), scratch.options.end());
    if (scratch.options.size() > most_asked) scratch.options.resize(most_asked);
    EdgeChoice best;
    for (const EdgeChoice& option : scratch.options) {
      if (best < option) break;
      const Edge edge{v, option.partner};
      const auto candidate = collapses_.evaluate(edge);
      const GuardAnswer answer = ask(edge, *candidate, best.priority, scratch);
      if (!answer.refusal)
        best = std::min(best, {collapses_.priority(edge, candidate->cost + answer.price),
                               option.partner, answer.price > 0.0});
    }
    return best;
  }

  /// True if v rests; called for every edge that is passed over, until the rest is over.
  bool passes_over(int v) {
    if (left_[v] == 0) return false;
    --left_[v];
    return true;
  }

  /// True if a question about an edge of v may change a rest: v or a neighbour is a hub.
  bool near(int v) const {
    if (collapses_.is_hub(v)) return true;
    for (int f : mesh_.connectivity.faces_of(v))
      for (int u : mesh_.connectivity.face(f))
        if (collapses_.is_hub(u)) return true;
    return false;
  }

  void end_all() { std::fill(left_.begin(), left_.end(), 0); }

  void renumber(const Renumbering& numbers) { numbers.vertices(left_); }

 private:
  static constexpr int most_asked = TriangleConnectivity::hub;  // edges of a vertex in a row
  static constexpr int part = 8;  // a refused hub is asked again after this part of it

  void send_to_rest(int v) {
    constexpr int longest = std::numeric_limits<std::uint16_t>::max();
    left_[v] = static_cast<std::uint16_t>(std::min(collapses_.valence(v) / part, longest));
  }

  const WorkingMesh& mesh_;
  const Operator& collapses_;
  std::vector<std::uint16_t> left_;  // by vertex: edges still to be passed over
};

}  // namespace curvdecim::detail
