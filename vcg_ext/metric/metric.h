// SPDX-License-Identifier: GPL-3.0-or-later
// What a metric is: it tells what an edge costs and where the merged vertex goes, and keeps what it
// knows about the vertices up to date. examples/own_metric.cpp adds one from outside.
//
//   call                          when                                    threads
//   initialize(parallel)          once, on the mesh before any collapse   on one, may use all
//   evaluate(edge, allowed, ...)  often                                   several at a time
//   estimate(v, others, costs)    often                                   several at a time
//   release(around, after)        just before a collapse                  several at a time
//   merge(merge, around)          just after it                           several at a time
//   renew(v, source)              after v's faces became others           on one
//   renumber(numbers)             between collapses                       on one
//
// Collapses at the same time share no vertex of their neighbourhoods: release and merge may read
// the faces around the edge's two ends and their vertices, and write what belongs to these
// vertices.
//
// What has changed: at release the mesh is as it was, and `after` has the planes that the faces of
// around.star() will have. At merge the position, the connectivity, the kinds and the planes are
// the new ones; the faces of around.wings() are gone.
//
// Costs are compared with each other only. They are at least 0, and 0 where nothing is lost; they
// do not depend on the number of threads or on the order of the calls.
#pragma once

#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "vcg_ext/geometry/vector3.h"
#include "vcg_ext/mesh/edge_neighborhood.h"
#include "vcg_ext/mesh/renumbering.h"
#include "vcg_ext/mesh/vertex_kind.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// A collapse that could be done.
struct Candidate {
  double cost;
  Vector3 position;
  double t;  // 0..1: where along the edge attributes are taken from
};

/// What the collapse of an edge merges; position: by vertex. The vertex that does not move stays,
/// if there is one, so that it keeps its bits.
inline VertexMerge merge_of(Edge edge, const Candidate& candidate,
                            const std::vector<Vector3>& position) {
  const bool keep_b = candidate.position == position[edge.b];
  const int keep = keep_b ? edge.b : edge.a, gone = keep_b ? edge.a : edge.b;
  const double t = keep_b ? 1.0 - candidate.t : candidate.t;
  return {keep, gone, position[keep], position[gone], candidate.position, t};
}

/// Compiles for a metric only: another type lacks a call that is named here, or gives another
/// result.
template <class M>
constexpr bool require_metric() {
  using std::declval, std::is_same_v;
  const auto* const_metric = static_cast<const M*>(nullptr);
  static_assert(is_same_v<void, decltype(declval<M&>().initialize(declval<const Parallel&>()))>);
  // allowed: where the kinds of the ends let the vertex lie; OntoA and OntoB: at this end, to the
  // bit. wings: sum of the area vectors of the faces at the edge. nullopt: the edge stays.
  static_assert(is_same_v<std::optional<Candidate>,
                          decltype(const_metric->evaluate(Edge(), Allowed(), Vector3()))>);
  // About the costs of the edges from v to others, each of which may collapse to anywhere; they
  // only choose what is evaluated. costs: to be resized.
  static_assert(is_same_v<void, decltype(const_metric->estimate(int(), std::vector<int>(),
                                                                declval<std::vector<double>&>()))>);
  static_assert(is_same_v<void, decltype(declval<M&>().release(EdgeNeighborhood(),
                                                               std::vector<FacePlane>()))>);
  static_assert(is_same_v<void, decltype(declval<M&>().merge(declval<const VertexMerge&>(),
                                                             EdgeNeighborhood()))>);
  // Where the topology gave way: v has other faces now, some or all of which belonged to source
  // before; v may be source itself.
  static_assert(is_same_v<void, decltype(declval<M&>().renew(int(), int()))>);
  // What the metric has by vertex or by face gets the new numbers: numbers.vertices(array).
  static_assert(is_same_v<void, decltype(declval<M&>().renumber(declval<const Renumbering&>()))>);
  return true;
}

}  // namespace curvdecim::detail

/// The words that a metric from outside is written in.
namespace curvdecim::metric_api {

using detail::Allowed;
using detail::Candidate;
using detail::Edge;
using detail::EdgeNeighborhood;
using detail::FacePlane;
using detail::Parallel;
using detail::Renumbering;
using detail::Vector3;
using detail::VertexMerge;
using detail::WorkingMesh;

}  // namespace curvdecim::metric_api
