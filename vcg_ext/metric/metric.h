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

// The calls, each on a metric M as the collapses make it.

template <class M>
using InitializeCall = decltype(std::declval<M&>().initialize(std::declval<const Parallel&>()));

/// allowed: where the kinds of the ends let the vertex lie; OntoA and OntoB: at this end, to the
/// bit. wings: sum of the area vectors of the faces at the edge. nullopt: the edge stays.
template <class M>
using EvaluateCall = decltype(std::declval<const M&>().evaluate(
    std::declval<Edge>(), std::declval<Allowed>(), std::declval<const Vector3&>()));

/// About the costs of the edges from v to others, each of which may collapse to anywhere; they only
/// choose what is evaluated. costs: to be resized.
template <class M>
using EstimateCall = decltype(std::declval<const M&>().estimate(
    std::declval<int>(), std::declval<const std::vector<int>&>(),
    std::declval<std::vector<double>&>()));

template <class M>
using ReleaseCall = decltype(std::declval<M&>().release(
    std::declval<const EdgeNeighborhood&>(), std::declval<const std::vector<FacePlane>&>()));

template <class M>
using MergeCall = decltype(std::declval<M&>().merge(std::declval<const VertexMerge&>(),
                                                    std::declval<const EdgeNeighborhood&>()));

/// What the metric has by vertex or by face gets the new numbers: numbers.vertices(array).
template <class M>
using RenumberCall = decltype(std::declval<M&>().renumber(std::declval<const Renumbering&>()));

/// True if a metric of type M has the call, and it gives a Result.
template <template <class> class Call, class Result, class M, class = void>
struct HasCall : std::false_type {};
template <template <class> class Call, class Result, class M>
struct HasCall<Call, Result, M, std::void_t<Call<M>>> : std::is_same<Call<M>, Result> {};

/// Compiles for a metric only, and names the call that another type lacks.
template <class M>
constexpr bool require_metric() {
  static_assert(HasCall<InitializeCall, void, M>::value, "void initialize(const Parallel&)");
  static_assert(HasCall<EvaluateCall, std::optional<Candidate>, M>::value,
                "optional<Candidate> evaluate(Edge, Allowed, const Vector3& wings) const");
  static_assert(HasCall<EstimateCall, void, M>::value,
                "void estimate(int v, const vector<int>& others, vector<double>& costs) const");
  static_assert(HasCall<ReleaseCall, void, M>::value,
                "void release(const EdgeNeighborhood&, const vector<FacePlane>& after)");
  static_assert(HasCall<MergeCall, void, M>::value,
                "void merge(const VertexMerge&, const EdgeNeighborhood&)");
  static_assert(HasCall<RenumberCall, void, M>::value, "void renumber(const Renumbering&)");
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
