// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that touch, and meshes of which neighbours share no vertex.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "support/drawn_meshes.h"
#include "support/shape.h"

namespace curvdecim::test {

/// Vertices in one place become one.
inline Shape welded(const Shape& shape) {
  Shape result;
  std::map<std::array<double, 3>, int> known;
  for (Corners face : shape.faces) {
    for (int& v : face) {
      const Point& p = shape.vertices[v];
      const auto [found, is_new] = known.try_emplace({p.x(), p.y(), p.z()}, result.vertex_count());
      if (is_new) result.vertices.push_back(p);
      v = found->second;
    }
    result.faces.push_back(face);
  }
  return result;
}

/// Every face has vertices of its own.
inline Shape soup_of(const Shape& shape) {
  Shape soup;
  for (const Corners& face : shape.faces) {
    const int first = soup.vertex_count();
    for (int v : face) soup.vertices.push_back(shape.vertices[v]);
    soup.faces.push_back({first, first + 1, first + 2});
  }
  return soup;
}

/// Every pair of faces has: as what is made of quads.
inline Shape quads_of(const Shape& shape) {
  Shape all;
  for (int f = 0; f < shape.face_count(); f += 2) {
    const Shape quad = welded({shape.vertices, {shape.faces[f], shape.faces[f + 1]}});
    all = all.faces.empty() ? quad : side_by_side({all, quad});
  }
  return all;
}

/// Boxes of `cells` along every edge, diagonally opposite at an edge along z.
inline Shape boxes_at_an_edge(int cells = 1) {
  const Shape box = dense_box(cells, {1, 1, 1});
  return welded(side_by_side({box, translated(box, {1, 1, 0})}));
}

/// Boxes with a whole side in common, which each of them has; turned: cut by the other diagonals.
inline Shape boxes_at_a_face(bool turned, int cells = 1) {
  const Shape box = dense_box(cells, {1, 1, 1});
  Shape other = box;
  if (turned) {
    other = mapped(other, [](const Point& p) { return Point(p.x(), 1.0 - p.y(), p.z()); });
    for (Corners& face : other.faces) std::swap(face[0], face[1]);
  }
  return welded(side_by_side({box, translated(other, {1, 0, 0})}));
}

/// Unit boxes with their lowest corners at these points, without the sides that two of them share.
inline Shape voxels(const std::vector<Point>& corners) {
  Shape all;
  for (const Point& corner : corners) all = side_by_side({all, translated(cube(), corner)});
  all = welded(all);
  std::map<Corners, int> count;
  const auto name = [](Corners face) {
    std::sort(face.begin(), face.end());
    return face;
  };
  for (const Corners& face : all.faces) ++count[name(face)];
  const auto is_inside = [&](const Corners& face) { return count[name(face)] == 2; };
  all.faces.erase(std::remove_if(all.faces.begin(), all.faces.end(), is_inside), all.faces.end());
  return welded(all);
}

/// Two of four boxes, diagonally opposite, between two layers of four: the edge between them cannot
/// be parted without parting the material.
inline Shape pinched_voxels() {
  return voxels({{0, 0, 0},
                 {1, 0, 0},
                 {0, 1, 0},
                 {1, 1, 0},
                 {0, 0, 1},
                 {1, 1, 1},
                 {0, 0, 2},
                 {1, 0, 2},
                 {0, 1, 2},
                 {1, 1, 2}});
}

/// Two tetrahedra on either side of an edge along z, with twice the angle (degrees) between their
/// faces at it.
inline Shape wedges_at_an_edge(double half_angle) {
  const double x = std::cos(half_angle * M_PI / 180.0), y = std::sin(half_angle * M_PI / 180.0);
  return {{{0, 0, 0}, {0, 0, 1}, {x, y, 0.5}, {x, -y, 0.5}, {-x, y, 0.5}, {-x, -y, 0.5}},
          {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}, {0, 4, 1}, {0, 1, 5}, {0, 5, 4}, {1, 4, 5}}};
}

/// The ends of the edge where boxes_at_an_edge() touch.
inline std::pair<int, int> edge_in_common(const Shape& boxes) {
  const auto at = [&](const Point& p) {
    for (int v = 0; v < boxes.vertex_count(); ++v)
      if (boxes.vertices[v] == p) return v;
    return -1;
  };
  return {at({1, 1, 0}), at({1, 1, 1})};
}

}  // namespace curvdecim::test
