// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "vcg_ext/mesh/blend_step.h"
#include "vcg_ext/mesh/seams.h"
#include "vcg_ext/mesh/texture_outline.h"

namespace curvdecim::detail {

/// The faces around an edge by chart: what they carry goes on inside one, by a wedge that they have
/// in common at an end of the edge. When the edge collapses each chart goes on as one wedge, with
/// what was carried at the chart's own point nearest to the merged vertex; along a seam with what
/// was carried at the same place of the edge on both sides. So no chart tears, and no two mix. The
/// place in the texture and the colour, where these count, are those that deviate least from what
/// the chart's faces say. In the texture a chart stays inside of what it was there, so that nothing
/// shows that is in no chart. Reused from edge to edge; empty where corners are not told apart.
class EdgeCharts {
 public:
  /// merge: as if the edge collapsed.
  void gather(const WorkingMesh& mesh, const EdgeNeighborhood& around, const VertexMerge& merge) {
    charts_.clear(), corners_.clear(), faces_.clear();
    inside_ = is_inside_chart(mesh, merge.keep) && is_inside_chart(mesh, merge.gone);
    if (inside_) add_only_chart(mesh, merge);
    for (const std::vector<int>* faces : {&around.wings(), &around.star()})
      for (int f : *faces) faces_.push_back({f, inside_ ? 0 : join(mesh, f, merge)});
    wings_ = around.wings().size();
    fit_texture_ = true;
    if (!mesh.weighs_attributes()) return;
    for (ChartFace& each : faces_) estimate(mesh, merge.now, each);
    for (int c = 0; c < count(); ++c)
      if (!is_united(c)) place(mesh, merge, c);
  }

  int count() const { return static_cast<int>(charts_.size()); }

  /// The wedge that chart c goes on as; none: it is one with another.
  int wedge(int c) const {
    return charts_[c].at_keep != Wedges::none ? charts_[c].at_keep : charts_[c].at_gone;
  }

  /// How that wedge changes in the merge that the charts were gathered for; of `none`: it stays, or
  /// there is none. is_nearest: over the surface; otherwise on the edge.
  BlendStep step(const WorkingMesh& mesh, const VertexMerge& merge, int c, bool is_nearest) const {
    if (is_united(c) || stays(merge, c)) return {};
    if (goes_along_seam(mesh, merge, c) || (!is_nearest && has_both(c)))
      return step_on_edge(charts_[c].at_keep, charts_[c].at_gone, merge.t);
    return is_nearest ? nearest_step(mesh, merge, c) : BlendStep();
  }

  /// Where it is in the texture then, and the colour that it has.
  const Vector2& texture(int c) const { return charts_[c].texture; }
  const Vector3& color(int c) const { return charts_[c].color; }

  /// False where a chart cannot stay inside of what it was in the texture.
  bool fit_texture() const { return fit_texture_; }

  /// The charts of the faces of the neighbourhood.
  int of_wing(std::size_t i) const { return faces_[i].chart; }
  int of_star(std::size_t i) const { return faces_[wings_ + i].chart; }

  /// Sums of areas times squared distances in the texture, or of colours, to what each face says.
  double texture_deviation() const {
    double sum = 0.0;
    for (const ChartFace& each : faces_) sum += each.texture.deviation(texture(each.chart));
    return sum;
  }
  double color_deviation() const {
    double sum = 0.0;
    for (const ChartFace& each : faces_) sum += each.color.deviation(color(each.chart));
    return sum;
  }

 private:
  struct Chart {
    int at_keep = Wedges::none, at_gone = Wedges::none;
    Vector2 texture = Vector2::Zero();
    Vector3 color = Vector3::Zero();
  };

  struct ChartFace {
    int face, chart;
    FaceEstimate<Vector2> texture{};  // of the merged vertex
    FaceEstimate<Vector3> color{};
  };

  struct Corner {
    int vertex, wedge, chart;
  };

  bool is_united(int c) const { return wedge(c) == Wedges::none; }

  /// The chart of an edge that is on no outline.
  void add_only_chart(const WorkingMesh& mesh, const VertexMerge& merge) {
    charts_.push_back({only_wedge(mesh, merge.keep), only_wedge(mesh, merge.gone)});
  }

  /// The chart of face f, which may be new.
  int join(const WorkingMesh& mesh, int f, const VertexMerge& merge) {
    const Face &face = mesh.connectivity.face(f), &wedges = mesh.wedges.of_face(f);
    int chart = Wedges::none;
    for (int i = 0; i < 3; ++i)
      if (const Corner* known = find(face[i], wedges[i]))
        chart = chart == Wedges::none ? known->chart : united(chart, known->chart);
    if (chart == Wedges::none) chart = count(), charts_.emplace_back();
    for (int i = 0; i < 3; ++i)
      if (merge.has(face[i]) && !find(face[i], wedges[i])) {
        corners_.push_back({face[i], wedges[i], chart});
        int& at = face[i] == merge.keep ? charts_[chart].at_keep : charts_[chart].at_gone;
        if (at == Wedges::none) at = wedges[i];
      }
    return chart;
  }

  const Corner* find(int vertex, int wedge) const {
    for (const Corner& corner : corners_)
      if (corner.vertex == vertex && corner.wedge == wedge) return &corner;
    return nullptr;
  }

  /// A face may join what two others did not.
  int united(int a, int b) {
    if (a == b) return a;
    for (Corner& corner : corners_)
      if (corner.chart == b) corner.chart = a;
    for (ChartFace& face : faces_)
      if (face.chart == b) face.chart = a;
    if (charts_[a].at_keep == Wedges::none) charts_[a].at_keep = charts_[b].at_keep;
    if (charts_[a].at_gone == Wedges::none) charts_[a].at_gone = charts_[b].at_gone;
    charts_[b] = {};
    return a;
  }

  BlendStep nearest_step(const WorkingMesh& mesh, const VertexMerge& merge, int c) const {
    NearestStep nearest(merge.now, step_on_edge(wedge(c), wedge(c), 0.0));
    for (const ChartFace& each : faces_)
      if (each.chart == c)
        nearest.look_at(mesh.triangle(each.face), mesh.plane[each.face].normal,
                        mesh.wedges.of_face(each.face));
    return nearest.step();
  }

  bool has_both(int c) const {
    return charts_[c].at_keep != Wedges::none && charts_[c].at_gone != Wedges::none;
  }

  bool stays(const VertexMerge& merge, int c) const {
    return charts_[c].at_keep != Wedges::none && merge.now == merge.keep_was;
  }

  bool goes_along_seam(const WorkingMesh& mesh, const VertexMerge& merge, int c) const {
    return has_both(c) && is_on_seam(mesh, merge.keep) && is_on_seam(mesh, merge.gone);
  }

  static void estimate(const WorkingMesh& mesh, const Vector3& x, ChartFace& of) {
    const PlanePoint at = plane_point(mesh.triangle(of.face), x);
    if (!mesh.texture.empty()) of.texture = face_estimate(at, mesh.texture_triangle(of.face));
    if (!mesh.color.empty()) of.color = face_estimate(at, mesh.color_triangle(of.face));
  }

  void place(const WorkingMesh& mesh, const VertexMerge& merge, int c) {
    if (!mesh.texture.empty()) place_in_texture(mesh, merge, c);
    if (!mesh.color.empty())
      charts_[c].color = wanted(mesh, merge, c, mesh.color, &ChartFace::color);
  }

  /// What deviates least; along a seam what is there on the edge. carried: by wedge.
  template <class Value>
  Value wanted(const WorkingMesh& mesh, const VertexMerge& merge, int c,
               const std::vector<Value>& carried, FaceEstimate<Value> ChartFace::*estimate) const {
    const Value& is = carried[wedge(c)];
    if (stays(merge, c)) return is;
    if (goes_along_seam(mesh, merge, c)) return is + merge.t * (carried[charts_[c].at_gone] - is);
    EstimateFit<Value> fit;
    for (const ChartFace& each : faces_)
      if (each.chart == c) {
        const Face& corners = mesh.wedges.of_face(each.face);
        fit.add(each.*estimate, {carried[corners[0]], carried[corners[1]], carried[corners[2]]});
      }
    return fit.value(is);
  }

  void place_in_texture(const WorkingMesh& mesh, const VertexMerge& merge, int c) {
    Vector2& texture = charts_[c].texture;
    texture = wanted(mesh, merge, c, mesh.texture, &ChartFace::texture);
    if (inside_ || !gather_outline(mesh, merge, c)) return;
    const std::optional<Vector2> place = outline_.nearest(texture);
    texture = place.value_or(texture);
    fit_texture_ = fit_texture_ && place;
  }

  /// The edges of the chart's outline at the two vertices, but for the one between them. False: the
  /// chart has no area in the texture.
  bool gather_outline(const WorkingMesh& mesh, const VertexMerge& merge, int c) {
    double area = 0.0;
    for (const ChartFace& each : faces_)
      if (each.chart == c) area += texture_area(mesh.texture_triangle(each.face));
    outline_.clear(area > 0.0 ? 1.0 : -1.0);
    const auto is_at_one_end = [&](int a, int b) { return merge.has(a) != merge.has(b); };
    for (const ChartFace& each : faces_)
      if (each.chart == c) add_outline_edges(mesh, each.face, is_at_one_end, outline_);
    return area != 0.0;
  }

  std::vector<Chart> charts_;
  std::vector<Corner> corners_;   // at the edge's ends
  std::vector<ChartFace> faces_;  // the wings, then the star
  std::size_t wings_ = 0;
  TextureOutline outline_;
  bool inside_ = false;  // the edge is on no outline
  bool fit_texture_ = true;
};

/// Before the connectivity follows: what the edge's ends carry becomes one.
inline void merge_wedges(WorkingMesh& mesh, const EdgeNeighborhood& around,
                         const EdgeCharts& charts) {
  for (int c = 0; c < charts.count(); ++c) {
    if (charts.wedge(c) == Wedges::none) continue;
    if (!mesh.texture.empty()) mesh.texture[charts.wedge(c)] = charts.texture(c);
    if (!mesh.color.empty()) mesh.color[charts.wedge(c)] = charts.color(c);
  }
  const auto [a, b] = around.edge();
  for (std::size_t i = 0; i < around.star().size(); ++i) {
    const int f = around.star()[i];
    const int end = mesh.connectivity.face_has(f, a) ? a : b;
    mesh.wedges.set(mesh.connectivity, f, end, charts.wedge(charts.of_star(i)));
  }
}

}  // namespace curvdecim::detail
