// SPDX-License-Identifier: GPL-3.0-or-later
// What a run says that ends above its target: what stood against further steps, and what to change.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "vcg_ext/collapse/collapse_plan.h"
#include "vcg_ext/mesh/seams.h"
#include "vcg_ext/mesh/tally.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/removal/removal_plan.h"
#include "vcg_ext/removal/vertex_fan.h"
#include "vcg_ext/report.h"

namespace curvdecim::detail {

/// What is said of a reason.
struct ReasonWords {
  const char* because;  ///< goes on after "steps were refused because"
  const char* advice;   ///< what allows more of them; "": nothing that is known here
};

/// What to do about the topology. limits: of a run that asks the link condition.
inline const char* topology_advice(const CollapseLimits& limits) {
  if (limits.topology_gives_way)
    return "Preserve topology is off already: what is left cannot give way further.";
  if (limits.max_error > 0.0)
    return "Maximum error keeps the topology. To go further, set it to 0 and switch off Preserve "
           "topology: then small parts, holes and handles may go.";
  return "To go further, switch off Preserve topology: then small parts, holes and handles may go.";
}

/// Words for what refuses a collapse.
inline ReasonWords words_of(Rejection reason, const CollapseLimits& limits) {
  switch (reason) {
    case Rejection::LinkCondition:
      return {"the topology could change (parts, holes, handles, places where sheets meet)",
              topology_advice(limits)};
    case Rejection::NormalFlip:
      return {"faces would lie back to back",
              "To go further, switch off Preserve normal: then faces may fold."};
    case Rejection::TriangleShape: return {"a face would lose all of its area", ""};
    case Rejection::ErrorBound:
      return {"the error could exceed Maximum error", "To go further, raise Maximum error."};
    case Rejection::HubAtRest:
      return {"a vertex of very many faces waits after a step that was refused or cost more", ""};
    case Rejection::TextureFlip:
      return {"a face would be turned over in the texture, or a chart would get larger there", ""};
    case Rejection::Crossing:
      return {"a face would cross another one",
              "To go further, switch off Prevent intersections: then faces may cross."};
    case Rejection::VertexClass:
    case Rejection::LoopSplit: break;  // of vertex removal
  }
  return {"", ""};
}

/// What to do where vertex removal itself is in the way.
inline constexpr const char* other_way_advice =
    "Vertex removal moves no vertex, and needs a loop around it that lines can part into good "
    "faces. To go further, above all on CAD parts, use Curvature-Enhanced Edge Collapse, which "
    "moves vertices.";

/// Words for what refuses the removal of a vertex.
inline ReasonWords words_of(Rejection reason, const RemovalPlan&) {
  switch (reason) {
    case Rejection::LinkCondition:
      return {
          "the topology could change (parts, holes, handles)",
          "Vertex removal always keeps the topology. To go further, use Curvature-Enhanced Edge "
          "Collapse with Preserve topology off."};
    case Rejection::NormalFlip:
      return {"a face would turn too far",
              "To go further, switch off Preserve normal, raise Largest turn of a face (up to 180 "
              "degrees), or use Curvature-Enhanced Edge Collapse, which moves vertices."};
    case Rejection::TriangleShape: return {"a face would be a sliver", other_way_advice};
    case Rejection::ErrorBound:
      return {"the error could exceed its bound",
              "To go further, raise the bound: the smaller of Maximum error and Bound on "
              "accumulated distances."};
    case Rejection::VertexClass:
      return {"the vertex is a corner that stays, or the faces around it are no fan",
              other_way_advice};
    case Rejection::LoopSplit:
      return {"no line parts the loop around the vertex", other_way_advice};
    case Rejection::TextureFlip:
    case Rejection::Crossing:
    case Rejection::HubAtRest: break;  // of edge collapse
  }
  return {"", ""};
}

/// The reasons that stood against steps, the most frequent first.
inline std::vector<Rejection> by_frequency(const Rejections& rejected) {
  std::vector<Rejection> reasons;
  for (std::size_t i = 0; i < rejected.count.size(); ++i)
    if (rejected.count[i] > 0) reasons.push_back(static_cast<Rejection>(i));
  std::stable_sort(reasons.begin(), reasons.end(),
                   [&](Rejection a, Rejection b) { return rejected[a] > rejected[b]; });
  return reasons;
}

/// " At the last try 20 steps were refused because no line parts the loop around the vertex, 3
/// because a face would turn too far." With the advice for the first reason that has one.
template <class Plan>
std::string told_reasons(const Rejections& rejected, const Plan& plan) {
  constexpr std::size_t most = 3;  // more are rare, and hide the others
  std::vector<Rejection> reasons = by_frequency(rejected);
  if (reasons.empty()) return "";
  reasons.resize(std::min(reasons.size(), most));
  std::string told = " At the last try ", advice;
  for (Rejection reason : reasons) {
    const ReasonWords words = words_of(reason, plan);
    const bool first = reason == reasons.front();
    const char* refused = rejected[reason] == 1 ? " step was refused" : " steps were refused";
    told += (first ? "" : ", ") + std::to_string(rejected[reason]) + (first ? refused : "") +
            " because " + words.because;
    if (advice.empty() && *words.advice != '\0') advice = std::string(" ") + words.advice;
  }
  return told + '.' + advice;
}

/// Says how many vertices stay, and why; nothing where none do.
template <class Stays>
std::string told_staying(const WorkingMesh& mesh, const std::string& why, Stays stays) {
  std::int64_t count = 0;
  for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v)
    count += mesh.connectivity.faces_of(v).size() > 0 && stays(v);
  if (count == 0) return "";
  return ' ' + std::to_string(count) + (count == 1 ? " vertex stays" : " vertices stay") +
         " because of " + why + '.';
}

inline std::string told_locked(const WorkingMesh& mesh) {
  return told_staying(mesh, "faces there that are not selected",
                      [&](int v) { return mesh.locked[v] != 0; });
}

/// What no removal leaves.
inline std::string told_seams(const WorkingMesh& mesh) {
  if (!mesh.wedges.exist()) return "";
  return told_staying(mesh, "seams there, of a texture or between groups of faces",
                      [&](int v) { return ends_seam(mesh, v); });
}

/// Kinds of vertices that hold each other back without a question. limits: of the run. is_all:
/// nothing else was said, advice neither.
inline std::string told_junctions(const WorkingMesh& mesh, const CollapseLimits& limits,
                                  bool is_all) {
  if (!limits.keeps_topology || limits.topology_gives_way) return "";
  const std::string told = told_staying(mesh, "sheets or parts that meet there", [&](int v) {
    return mesh.kind[v] == VertexKind::Junction && mesh.locked[v] == 0;
  });
  return told.empty() || !is_all ? told : told + ' ' + topology_advice(limits);
}

/// What a removal does not try.
inline std::string told_untried(const WorkingMesh& mesh, const RemovalPlan& plan) {
  std::string told = told_seams(mesh) + told_locked(mesh);
  const std::string hub = "more than " + std::to_string(VertexFan::longest) + " faces there";
  told += told_staying(mesh, hub, [&](int v) {
    return mesh.locked[v] == 0 && mesh.connectivity.faces_of(v).size() > VertexFan::longest;
  });
  if (plan.preserve_features)
    told +=
        " Preserve sharp edges and corners is on: nothing leaves a sharp edge, and corners stay.";
  return told;
}

/// True if a run came to an end above a target that was asked for.
inline bool ended_above(const StopCriterion& stop, const Tally& tally) {
  return tally.stopped_by == StopReason::NothingLeft ||
         (tally.stopped_by == StopReason::ErrorBound && stop.has_target());
}

/// exhausted: what a run had no more of.
inline std::string told_end(const DecimationReport& report, const char* exhausted) {
  return "Stopped at " + std::to_string(report.faces) + (report.faces == 1 ? " face" : " faces") +
         ", above the target: " + exhausted + '.';
}

/// Says why a run of collapses left more than was asked for. mesh: after it.
inline void note_stop(const Tally& tally, const CollapsePlan& plan, const WorkingMesh& mesh,
                      DecimationReport& report) {
  if (!ended_above(plan.stop, tally)) return;
  const std::string reasons = told_reasons(tally.last_look(), plan.limits);
  report.notes.push_back(told_end(report, "no edge is left that may collapse") + reasons +
                         told_junctions(mesh, plan.limits, reasons.empty()) + told_locked(mesh));
}

/// Says why a run of removals left more than was asked for. mesh: after it.
inline void note_stop(const Tally& tally, const RemovalPlan& plan, const WorkingMesh& mesh,
                      DecimationReport& report) {
  if (!ended_above(plan.stop, tally)) return;
  report.notes.push_back(told_end(report, "no vertex is left that may go") +
                         told_reasons(tally.last_look(), plan) + told_untried(mesh, plan));
}

}  // namespace curvdecim::detail
