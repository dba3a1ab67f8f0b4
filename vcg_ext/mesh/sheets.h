// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

#include "vcg_ext/mesh/disjoint_sets.h"
#include "vcg_ext/mesh/faces_at_edge.h"
#include "vcg_ext/mesh/working_mesh.h"

namespace curvdecim::detail {

/// Faces over other vertices than those of a mesh.
struct Revertexed {
  std::vector<Face> faces;  // in the mesh's order
  std::vector<int> old_of;  // by new vertex: the mesh's
};

/// Tells the sheets that touch in a vertex apart: faces around it that are connected by edges. At
/// an edge of more than two faces pairs are connected, or all, where they cannot be paired. Reused
/// from vertex to vertex.
class SheetsAtVertex {
 public:
  SheetsAtVertex(const WorkingMesh& mesh, Pairing pairing) : mesh_(mesh), pairing_(pairing) {}

  /// By face of the vertex's list: the number of its sheet, from 0 on as they come.
  const std::vector<int>& sheets(int v) {
    vertex_ = v;
    gather();
    connect();
    return number();
  }

  /// How many there were last.
  int count() const { return count_; }

  /// True if an edge of more than two faces has two in one sheet, and they run alike: there the
  /// surface would be turned over.
  bool turn_over() const {
    for (std::size_t first = 0, last; first < spokes_.size(); first = last) {
      last = end_of_edge(first);
      for (std::size_t i = first; i < last && last - first > 2; ++i)
        if (is_turned_over(first, last, sheets_[spokes_[i].place])) return true;
    }
    return false;
  }

 private:
  /// An edge at the vertex, as a face has it.
  struct Spoke {
    int to, place;  // place: of the face, in the vertex's list
    bool forward;   // the face runs from the vertex along it

    bool operator<(const Spoke& o) const { return std::tie(to, place) < std::tie(o.to, o.place); }
  };

  void gather() {
    const TriangleConnectivity& connectivity = mesh_.connectivity;
    spokes_.clear();
    int place = 0;
    for (int f : connectivity.faces_of(vertex_)) {
      const int next = connectivity.next_vertex(f, vertex_);
      spokes_.push_back({next, place, true});
      spokes_.push_back({connectivity.third_vertex(f, vertex_, next), place, false});
      ++place;
    }
    std::sort(spokes_.begin(), spokes_.end());
    connected_.reset(place);
  }

  /// The spokes of one edge follow each other.
  std::size_t end_of_edge(std::size_t first) const {
    std::size_t last = first + 1;
    while (last < spokes_.size() && spokes_[last].to == spokes_[first].to) ++last;
    return last;
  }

  bool is_turned_over(std::size_t first, std::size_t last, int sheet) const {
    int forward = 0, backward = 0;
    for (std::size_t i = first; i < last; ++i)
      if (sheets_[spokes_[i].place] == sheet) ++(spokes_[i].forward ? forward : backward);
    return forward + backward == 2 && forward != 1;
  }

  void connect() {
    for (std::size_t first = 0, last; first < spokes_.size(); first = last) {
      last = end_of_edge(first);
      if (last - first > 2 && connect_pairs(first, last)) continue;
      for (std::size_t i = first + 1; i < last; ++i)
        connected_.unite(spokes_[first].place, spokes_[i].place);
    }
  }

  bool connect_pairs(std::size_t first, std::size_t last) {
    const TriangleConnectivity& connectivity = mesh_.connectivity;
    const int to = spokes_[first].to;
    edge_.clear();
    for (std::size_t i = first; i < last; ++i) {
      const int f = connectivity.faces_of(vertex_).begin()[spokes_[i].place];
      edge_.add({spokes_[i].place, spokes_[i].forward,
                 mesh_.position[connectivity.third_vertex(f, vertex_, to)]});
    }
    if (!edge_.pair(mesh_.position[vertex_], mesh_.position[to], pairing_)) return false;
    for (const auto& [f, g] : edge_.pairs()) connected_.unite(f, g);
    return true;
  }

  const std::vector<int>& number() {
    count_ = 0;
    sheets_.resize(mesh_.connectivity.faces_of(vertex_).size());
    for (int i = 0; i < static_cast<int>(sheets_.size()); ++i) {
      const int root = connected_.root(i);  // the least: its number is known
      sheets_[i] = root == i ? count_++ : sheets_[root];
    }
    return sheets_;
  }

  const WorkingMesh& mesh_;
  const Pairing pairing_;
  int vertex_ = -1, count_ = 0;
  std::vector<Spoke> spokes_;
  DisjointSets connected_;  // by place of the face
  FacesAtEdge edge_;
  std::vector<int> sheets_;
};

/// The sheets that can be parted at v: their numbers, by face of the vertex's list. Empty where
/// the surface is a manifold, v is locked, or the faces hang together in other ways.
inline std::vector<int> partable_sheets(const WorkingMesh& mesh, int v) {
  if (mesh.kind[v] < VertexKind::Curve || mesh.locked[v]) return {};
  for (Pairing pairing : {Pairing::Flattest, Pairing::Alone}) {
    SheetsAtVertex around(mesh, pairing);
    const std::vector<int>& sheets = around.sheets(v);
    if (around.count() > 1 && !around.turn_over()) return sheets;
  }
  return {};
}

/// The mesh with a vertex for every sheet, where several touch in one that is not locked. The
/// copies follow their original. No faces: there is nothing to separate.
inline Revertexed separated_sheets(const WorkingMesh& mesh, Pairing pairing) {
  struct Corner {
    int face, vertex, sheet;
  };
  std::vector<Corner> moved;
  SheetsAtVertex around(mesh, pairing);
  Revertexed result;
  std::vector<int> first_of(mesh.kind.size());
  for (int v = 0; v < static_cast<int>(mesh.kind.size()); ++v) {
    first_of[v] = static_cast<int>(result.old_of.size());
    result.old_of.push_back(v);
    if (mesh.kind[v] < VertexKind::Curve || mesh.locked[v]) continue;
    const std::vector<int>& sheets = around.sheets(v);
    result.old_of.insert(result.old_of.end(), around.count() - 1, v);
    for (std::size_t i = 0; i < sheets.size(); ++i)
      if (sheets[i] > 0) moved.push_back({mesh.connectivity.faces_of(v).begin()[i], v, sheets[i]});
  }
  if (moved.empty()) return {};
  for (int f = 0; f < mesh.connectivity.face_slots(); ++f) {
    const auto [a, b, c] = mesh.connectivity.face(f);
    result.faces.push_back({first_of[a], first_of[b], first_of[c]});
  }
  for (const Corner& corner : moved)
    result.faces[corner.face][mesh.connectivity.corner(corner.face, corner.vertex)] += corner.sheet;
  return result;
}

}  // namespace curvdecim::detail
