// SPDX-License-Identifier: GPL-3.0-or-later
// Results that several filters have.
#pragma once

#include <cmath>
#include <initializer_list>
#include <iomanip>
#include <sstream>
#include <string>

#include "filter_curvdecim/table/filter.h"
#include "filter_curvdecim/table/joined.h"
#include "vcg_ext/report.h"
#include "vcg_ext/run/grouped.h"

namespace curvdecim::glue {

template <class R, class P>
ResultRow<R, P> stopped_by_result(const std::string& when = "") {
  return enum_result<R, P>("stopped_by", "why it ended" + when, &R::stopped_by);
}

/// What every decimation tells first.
template <class R, class P>
ResultRows<R, P> count_results() {
  return {result<R, P>("faces_before", "faces", "those of the input", &R::faces_before),
          result<R, P>("faces", "faces", "those of the result", &R::faces),
          result<R, P>("vertices_before", "vertices", "those of the input", &R::vertices_before),
          result<R, P>("vertices", "vertices", "those of the result", &R::vertices),
          stopped_by_result<R, P>()};
}

template <class R, class P>
ResultRow<R, P> max_error_result(const std::string& when = "") {
  return result<R, P>("max_error", length_unit,
                      "no point of either surface is further than this from the other" + when,
                      &R::max_error);
}

/// The row of max_error in filters that know it only where a bound is given.
template <class R, class P>
ResultRow<R, P> bound_result() {
  const auto bounded = [](const R&, const P& params) { return params.max_error > 0.0; };
  return only_if(bounded, max_error_result<R, P>("; only with `MaxError`"));
}

/// What gave way where the topology is not preserved.
template <class R, class P>
ResultRows<R, P> topology_results() {
  const auto gives_way = [](const R&, const P& params) {
    return !params.preserve_topology && !(params.max_error > 0.0);
  };
  const std::string when = "; not with `PreserveTopology`";
  return {only_if(gives_way, result<R, P>("parts_removed", "parts", "pieces that vanished" + when,
                                          &R::parts_removed)),
          only_if(gives_way, result<R, P>("holes_closed", "holes", "small holes that closed" + when,
                                          &R::holes_closed)),
          only_if(gives_way,
                  result<R, P>("handles_cut", "handles",
                               "handles, tunnels and necks that were cut" + when, &R::handles_cut)),
          only_if(gives_way, result<R, P>("junctions_parted", "vertices",
                                          "where three or more sheets met that came apart" + when,
                                          &R::junctions_parted)),
          only_if(gives_way, result<R, P>("largest_removed", length_unit,
                                          "diameter of the largest of these when it went" + when,
                                          &R::largest_removed))};
}

/// What the detector counts where faces may not cross.
template <class R, class P>
ResultRow<R, P> crossing_result() {
  const auto is_asked = [](const R&, const P& params) { return params.prevent_intersections; };
  return only_if(is_asked, result<R, P>("crossing", "faces",
                                        "those of the result that cross or touch others beside "
                                        "their neighbours, as they did in the input; only with "
                                        "`PreventIntersections`",
                                        &R::crossing));
}

template <class R, class P>
ResultRow<R, P> cost_last_result(const std::string& meaning) {
  return result<R, P>("cost_last", "for a mesh of diagonal 1", meaning, &R::cost_last);
}

inline const char* meaning_of(Rejection reason) {
  switch (reason) {
    case Rejection::LinkCondition: return "refused because the topology would have changed";
    case Rejection::NormalFlip: return "refused because a face would have turned too far";
    case Rejection::TriangleShape:
      return "refused because a face would have become a needle or a cap";
    case Rejection::ErrorBound: return "refused because the error would have exceeded a bound";
    case Rejection::HubAtRest:
      return "refused unasked, at a vertex of very many faces where one was refused before";
    case Rejection::TextureFlip:
      return "refused because a face would have been turned over in its texture, or a chart had "
             "become larger there";
    case Rejection::VertexClass: return "refused because the vertex is complex, or a corner";
    case Rejection::LoopSplit: return "refused because no line parts the loop around the vertex";
    case Rejection::Crossing: return "refused because a face would have crossed another one";
  }
  return "";
}

/// How many steps were refused, by reason.
template <class R, class P>
ResultRows<R, P> rejection_results(const std::string& steps,
                                   std::initializer_list<Rejection> reasons) {
  ResultRows<R, P> rows;
  for (Rejection reason : reasons)
    rows.push_back({{std::string("rejected_") + label_of(reason), steps, meaning_of(reason)},
                    [reason](const R& report, const P&) { return report.rejected[reason]; }});
  return rows;
}

template <class R, class P>
ResultRow<R, P> seconds_result() {
  return result<R, P>("seconds", "s", "wall time", &R::seconds);
}

/// What every edge collapse tells last.
template <class R, class P>
ResultRows<R, P> collapse_results() {
  return joined<ResultRow<R, P>>(
      {{crossing_result<R, P>(), cost_last_result<R, P>("the cost of the last collapse")},
       rejection_results<R, P>(
           "collapses", {Rejection::LinkCondition, Rejection::NormalFlip, Rejection::TriangleShape,
                         Rejection::ErrorBound, Rejection::HubAtRest, Rejection::TextureFlip,
                         Rejection::Crossing}),
       {seconds_result<R, P>()}});
}

/// "5,804 faces became 1,160 in 0.012 s."; empty where the shape did not change.
inline std::string headline_of(const DecimationReport& report, const Changes& changed) {
  if (!changed.shape) return "";
  std::ostringstream seconds;
  if (report.seconds < 10.0)
    seconds << std::setprecision(2) << report.seconds;
  else
    seconds << std::llround(report.seconds);
  return detail::grouped(report.faces_before) + " faces became " + detail::grouped(report.faces) +
         " in " + seconds.str() + " s.";
}

/// Every decimation that does something takes faces or vertices away.
inline Changes change_of_shape(const DecimationReport& report) {
  return {report.faces != report.faces_before || report.vertices != report.vertices_before, false};
}

}  // namespace curvdecim::glue
