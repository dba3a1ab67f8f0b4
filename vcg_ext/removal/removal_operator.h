// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/guard/face_guard.h"
#include "vcg_ext/guard/step_bound.h"
#include "vcg_ext/queue/priority.h"
#include "vcg_ext/removal/average_plane.h"
#include "vcg_ext/removal/loop_triangulation.h"
#include "vcg_ext/removal/removal_observer.h"
#include "vcg_ext/removal/removal_plan.h"
#include "vcg_ext/removal/vertex_fan.h"

namespace curvdecim::detail {

/// Whether a vertex may go, and what that costs.
struct RemovalAnswer {
  std::optional<Rejection> refusal;  ///< nullopt: it may
  double cost = 0.0;
  double error = 0.0;  ///< how far the new faces would be from the input, at most
  double moved = 0.0;  ///< how far they would be from the old ones, at most
};

/// Evaluates vertices, asks the guards, removes: what both criteria share. Calls that look may run
/// at the same time.
class RemovalOperator {
 public:
  /// Reused from vertex to vertex; every thread has its own.
  struct Scratch {
    Scratch(const WorkingMesh& mesh, const RemovalPlan& plan)
        : triangulation(mesh, plan.aspect_ratio_min) {}

    VertexFan fan;
    LoopPart part;
    LoopTriangulation triangulation;
    std::vector<NewFace> faces;
    std::vector<FacePlane> planes;  // of them
  };

  /// What the paper's distance tells, before the loop is triangulated.
  struct Estimate {
    double distance;  ///< accumulated, times the importance
    Priority priority;
  };

  RemovalOperator(WorkingMesh& mesh, FeatureEdges lines, const RemovalPlan& plan,
                  RemovalObservers observers)
      : mesh_(mesh),
        plan_(plan),
        lines_(std::move(lines)),
        face_guard_(mesh, plan.faces),
        error_(mesh.position.size(), 0.0),
        spent_(mesh.position.size(), 0.0),
        observers_(std::move(observers)) {}

  /// From now on the distance to the input is measured. bound: has begun with the mesh.
  void measure_with(SurfaceBound& bound) { bound_.emplace(bound); }

  // --- candidates -------------------------------------------------------------------------------

  VertexClass class_at(int v, VertexFan& fan) const {
    const bool oriented = is_hub(v) || fan.gather(mesh_.connectivity, v);
    return class_of(mesh_.kind[v], oriented, lines_.edges_at(v));
  }

  /// By the distance to the average plane, to the nearest line between two neighbours where that is
  /// less, as on a straight ridge, or to the boundary or feature line through v. nullopt: v stays.
  std::optional<Estimate> estimate(int v, VertexFan& fan) const {
    if (mesh_.locked[v] || is_hub(v)) return std::nullopt;
    const VertexClass is = class_of(mesh_.kind[v], true, lines_.edges_at(v));
    if (stays(v, is)) return std::nullopt;
    AveragePlane plane;  // v is the origin
    Spokes spokes;
    for (int f : mesh_.connectivity.faces_of(v)) {
      const auto [a, b] = spokes_of(f, v);
      plane.add({Vector3::Zero(), a, b}, mesh_.plane[f].area_vector(), mesh_.plane[f].area);
      spokes.push(a);
    }
    const bool inside = mesh_.kind[v] == VertexKind::Interior;
    double distance = 0.0;
    if (inside && is != VertexClass::InteriorEdge) {
      distance = std::min(plane.distance(Vector3::Zero()), distance_to_chords(spokes));
    } else {
      if (!inside && !fan.gather(mesh_.connectivity, v)) return std::nullopt;
      distance = line_weight(v) * line_at(v, fan).distance;
    }
    distance = significant(distance, plane.area());
    const double cost = spent_[v] + distance * distance * plane.area();
    return Estimate{importance(v) * (error_[v] + distance), {importance(v) * cost, plane.area()}};
  }

  /// Leaves the new faces in the scratch.
  RemovalAnswer evaluate(int v, Scratch& scratch) const {
    if (is_hub(v)) return {Rejection::LoopSplit};
    const VertexClass is = class_at(v, scratch.fan);
    if (stays(v, is)) return {Rejection::VertexClass};
    if (mesh_.kind[v] == VertexKind::Boundary) return along_boundary(v, scratch);
    if (is != VertexClass::InteriorEdge) return across(v, scratch);
    const RemovalAnswer answer = along_line(v, scratch);
    return answer.refusal && lines_.edges_at(v, EdgeMark::Held) == 0 ? across(v, scratch) : answer;
  }

  /// Settles whether the removal evaluated last stays within the bound of the distance.
  void settle(RemovalAnswer& answer, const Scratch& scratch) {
    if (!bound_ || answer.refusal) return;
    set_change(scratch, bound_->change());
    const auto distance = bound_->known(answer.moved) ? bound_->measure(mesh_) : std::nullopt;
    if (!distance) answer = {Rejection::ErrorBound};
    answer.error = distance.value_or(0.0);
  }

  Priority priority(int v, const RemovalAnswer& answer) const {
    return {importance(v) * answer.cost, 0.0};
  }

  double importance(int v) const { return mesh_.importance.empty() ? 1.0 : mesh_.importance[v]; }

  // --- removal ----------------------------------------------------------------------------------

  /// Removes the vertex evaluated last. Its neighbours take over what it was off.
  Removed remove(const RemovalAnswer& answer, const Scratch& scratch) {
    const VertexFan& fan = scratch.fan;
    if (bound_) bound_->accept(mesh_);
    for (RemovalObserver* observer : observers_) observer->before(mesh_, fan, scratch.faces);
    if (mesh_.wedges.exist()) hand_over_wedges(scratch.faces);
    if (mesh_.merges.exists()) note_merge(fan);
    std::vector<Face> now(fan.faces().size(), dead_face);
    for (std::size_t i = 0; i < scratch.faces.size(); ++i) {
      const NewFace& face = scratch.faces[i];
      now[std::find(fan.faces().begin(), fan.faces().end(), face.slot) - fan.faces().begin()] =
          face.corners;
      mesh_.plane[face.slot] = scratch.planes[i];
      lines_.set(face.slot, face.marks);
    }
    for (int u : fan.loop()) {
      error_[u] = std::max(error_[u], answer.error);
      spent_[u] += answer.cost / static_cast<double>(fan.loop().size());
    }
    return mesh_.connectivity.replace(fan.faces(), now);
  }

 private:
  static constexpr Face dead_face = {TriangleConnectivity::dead, TriangleConnectivity::dead,
                                     TriangleConnectivity::dead};

  /// The new edge that a vertex on a line leaves.
  struct Line {
    int from, to;
    Vector3 foot;     // of the vertex
    double distance;  // of the vertex from its foot
  };

  void set_change(const Scratch& scratch, SurfaceChange& change) const {
    change.gone = scratch.fan.faces(), change.now.clear();
    for (const NewFace& face : scratch.faces)
      change.now.push_back({face.slot, triangle_of(mesh_.position, face.corners)});
  }

  /// A vertex that goes counts as merged with the nearest one around it.
  void note_merge(const VertexFan& fan) {
    const Vector3& x = mesh_.position[fan.vertex()];
    const auto distance2 = [&](int u) { return (mesh_.position[u] - x).squaredNorm(); };
    const auto nearest = std::min_element(fan.loop().begin(), fan.loop().end(), [&](int u, int w) {
      return distance2(u) < distance2(w);
    });
    mesh_.note_merge(fan.vertex(), *nearest);
  }

  /// A corner of a new face has the wedge that its vertex has on this side of a seam.
  void hand_over_wedges(const std::vector<NewFace>& faces) {
    std::vector<Face> now(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (int k = 0; k < 3; ++k)
        now[i][k] = mesh_.wedges.at(mesh_.connectivity, faces[i].source[k], faces[i].corners[k]);
    for (std::size_t i = 0; i < faces.size(); ++i) mesh_.wedges.set_face(faces[i].slot, now[i]);
  }

  bool is_hub(int v) const { return mesh_.connectivity.faces_of(v).size() > VertexFan::longest; }

  /// A corner of lines that nothing may leave, or where such a line ends.
  bool stays(int v, VertexClass is) const {
    if (is == VertexClass::Simple) return false;
    const int held = lines_.edges_at(v, EdgeMark::Held);
    return is == VertexClass::Complex || held == 1 || (held > 0 && is == VertexClass::Corner);
  }

  /// From a vertex to its neighbours.
  struct Spokes {
    std::array<Vector3, VertexFan::longest> to;
    int count = 0;

    void push(const Vector3& spoke) { to[count++] = spoke; }
  };

  /// To the other corners of f, in its order.
  std::array<Vector3, 2> spokes_of(int f, int v) const {
    const Face& face = mesh_.connectivity.face(f);
    const int at = mesh_.connectivity.corner(f, v);
    return {mesh_.position[face[(at + 1) % 3]] - mesh_.position[v],
            mesh_.position[face[(at + 2) % 3]] - mesh_.position[v]};
  }

  /// How far a vertex inside is from the nearest line between two neighbours around it.
  static double distance_to_chords(const Spokes& spokes) {
    double least2 = HUGE_VAL;
    for (int i = 0; i < spokes.count; ++i)
      for (int j = 0; j < i; ++j) {
        const Vector3 &a = spokes.to[i], &b = spokes.to[j];
        if (a.dot(b) < 0.0)
          least2 = std::min(least2, a.cross(b).squaredNorm() / (a - b).squaredNorm());
      }
    return std::sqrt(least2);
  }

  /// What a distance to a boundary or feature line counts.
  double line_weight(int v) const {
    return mesh_.kind[v] == VertexKind::Boundary && !plan_.preserve_boundary
               ? 0.0
               : plan_.boundary_weight;
  }

  /// fan: for the boundary only.
  Line line_at(int v, const VertexFan& fan) const {
    constexpr double from_end = 1.0 / 16.0;  // of the edge: faces at the foot keep an area
    Line line{};
    if (mesh_.kind[v] == VertexKind::Boundary)
      line.from = fan.loop().front(), line.to = fan.loop().back();
    else
      line.from = lines_.ends_at(v)[0], line.to = lines_.ends_at(v)[1];
    const Vector3 &a = mesh_.position[line.from], along = mesh_.position[line.to] - a;
    const double t = along.dot(mesh_.position[v] - a) / along.squaredNorm();
    line.foot = a + (t > from_end ? std::min(t, 1.0 - from_end) : from_end) * along;
    line.distance = (mesh_.position[v] - line.foot).norm();
    return line;
  }

  /// All of the loop at once.
  RemovalAnswer across(int v, Scratch& scratch) const {
    begin(scratch);
    scratch.part.cut(scratch.fan, 0, faces_in(scratch.fan), mesh_.position[v]);
    return answer(v, fill(v, 0.0, scratch), 0.0);
  }

  RemovalAnswer along_boundary(int v, Scratch& scratch) const {
    const Line line = line_at(v, scratch.fan);
    begin(scratch);
    scratch.part.cut(scratch.fan, 0, faces_in(scratch.fan), line.foot);
    return answer(v, fill(v, line.distance, scratch), line.distance);
  }

  /// Both sides of the line by themselves.
  RemovalAnswer along_line(int v, Scratch& scratch) const {
    const VertexFan& fan = scratch.fan;
    const Line line = line_at(v, fan);
    const int all = faces_in(fan), from = fan.place_of(line.from), to = fan.place_of(line.to);
    begin(scratch);
    scratch.part.cut(fan, from, (to - from + all) % all, line.foot);
    Filled both = fill(v, line.distance, scratch);
    if (both.refusal) return {both.refusal};
    scratch.part.cut(fan, to, (from - to + all) % all, line.foot);
    const Filled other = fill(v, line.distance, scratch);
    both = {other.refusal, std::max(both.step, other.step), std::max(both.error, other.error)};
    return answer(v, both, line.distance);
  }

  static int faces_in(const VertexFan& fan) { return static_cast<int>(fan.faces().size()); }

  static void begin(Scratch& scratch) { scratch.faces.clear(), scratch.planes.clear(); }

  struct Filled {
    std::optional<Rejection> refusal;
    double step = 0.0, error = 0.0;
  };

  /// slide: how far the vertex is from its line.
  RemovalAnswer answer(int v, const Filled& filled, double slide) const {
    if (filled.refusal) return {filled.refusal};
    if (plan_.max_sum > 0.0 && filled.error > plan_.max_sum) return {Rejection::ErrorBound};
    double area = 0.0;
    for (int f : mesh_.connectivity.faces_of(v)) area += mesh_.plane[f].area;
    const double distance = filled.step + line_weight(v) * significant(slide, area);
    return {std::nullopt, spent_[v] + distance * distance * area, filled.error,
            filled.step + slide};
  }

  /// Appends the new faces of the part, if no guard refuses them.
  Filled fill(int v, double slide, Scratch& scratch) const {
    using Outcome = LoopTriangulation::Outcome;
    const LoopPart& part = scratch.part;
    std::optional<Rejection> refusal;
    const auto accept = [&](const LoopTriangle& t) {
      const int side = loop_side(part, t);
      if (side < 0) return true;
      const auto& corner = part.corners;
      const Triangle after =
          triangle_of(mesh_.position, {corner[t[0]], corner[t[1]], corner[t[2]]});
      const auto reason = face_guard_.refusal(part.faces[side], after, face_plane(after));
      if (reason) refusal = reason;
      return !reason;
    };
    LoopTriangulation& filling = scratch.triangulation;
    const Outcome outcome = filling.run(part, error_, error_[v] + slide, accept);
    if (outcome == Outcome::EdgeExists) return {Rejection::LinkCondition};
    if (outcome == Outcome::NoSplit) return {refusal.value_or(Rejection::LoopSplit)};
    append_faces(
        part, filling.triangles(), [&](int f) { return lines_.mark_across(f, v); },
        part.closed ? EdgeMark::None : closing_mark(v), scratch.faces);
    for (std::size_t i = scratch.planes.size(); i < scratch.faces.size(); ++i)
      scratch.planes.push_back(face_plane(triangle_of(mesh_.position, scratch.faces[i].corners)));
    return {std::nullopt, filling.step(), filling.error()};
  }

  /// The mark of the new edge along a line; a boundary is none.
  EdgeMark closing_mark(int v) const {
    if (mesh_.kind[v] == VertexKind::Boundary) return EdgeMark::None;
    return lines_.edges_at(v, EdgeMark::Held) > 0 ? EdgeMark::Held : EdgeMark::Feature;
  }

  WorkingMesh& mesh_;
  const RemovalPlan& plan_;
  FeatureEdges lines_;
  FaceGuard face_guard_;
  std::vector<double> error_;  // by vertex: how far a point of the faces at it is from the input
  std::vector<double> spent_;  // by vertex: its share of what removals near it have cost
  const RemovalObservers observers_;
  std::optional<StepBound> bound_;
};

}  // namespace curvdecim::detail
