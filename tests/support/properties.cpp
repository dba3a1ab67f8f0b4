// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/properties.h"

#include <vcg/space/distance3.h>
#include <vcg/space/triangle3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace curvdecim::test {

namespace {

class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int root(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int i, int j) { parent_[root(i)] = root(j); }

 private:
  std::vector<int> parent_;
};

struct EdgeUse {
  std::vector<int> faces;
  int forward = 0;  // faces that run from the lower to the higher index
};

using EdgeUses = std::map<std::pair<int, int>, EdgeUse>;

EdgeUses edges_of(const Shape& shape) {
  EdgeUses edges;
  for (int f = 0; f < shape.face_count(); ++f)
    for (int i = 0; i < 3; ++i) {
      const int a = shape.faces[f][i], b = shape.faces[f][(i + 1) % 3];
      EdgeUse& use = edges[std::minmax(a, b)];
      use.faces.push_back(f);
      use.forward += a < b;
    }
  return edges;
}

bool has_repeated_index(const Corners& f) { return f[0] == f[1] || f[1] == f[2] || f[2] == f[0]; }

int count_components(const Shape& shape) {
  DisjointSets sets(shape.vertex_count());
  for (const Corners& f : shape.faces) sets.join(f[0], f[1]), sets.join(f[1], f[2]);
  std::set<int> roots;
  for (const Corners& f : shape.faces) roots.insert(sets.root(f[0]));
  return static_cast<int>(roots.size());
}

/// By face: whether its component is a tetrahedron or two of them: next to nothing is left of it,
/// and the input's nearest point to a face may lie on its other side.
std::vector<bool> lies_in_few_faces(const Shape& shape) {
  constexpr int few = 6;
  DisjointSets sets(shape.vertex_count());
  for (const Corners& f : shape.faces) sets.join(f[0], f[1]), sets.join(f[1], f[2]);
  std::map<int, int> faces;
  for (const Corners& f : shape.faces) ++faces[sets.root(f[0])];
  std::vector<bool> result;
  for (const Corners& f : shape.faces) result.push_back(faces[sets.root(f[0])] <= few);
  return result;
}

int count_boundary_loops(const EdgeUses& edges, int vertices) {
  DisjointSets sets(vertices);
  std::set<int> roots;
  for (const auto& [edge, use] : edges)
    if (use.faces.size() == 1) sets.join(edge.first, edge.second);
  for (const auto& [edge, use] : edges)
    if (use.faces.size() == 1) roots.insert(sets.root(edge.first));
  return static_cast<int>(roots.size());
}

/// Fans are the classes of (vertex, face) corners that edges at the vertex connect.
int count_nonmanifold_vertices(const Shape& shape, const EdgeUses& edges) {
  DisjointSets corners(3 * shape.face_count());
  const auto corner = [&](int f, int v) {
    const Corners& face = shape.faces[f];
    return 3 * f + static_cast<int>(std::find(face.begin(), face.end(), v) - face.begin());
  };
  for (const auto& [edge, use] : edges)
    for (std::size_t i = 1; i < use.faces.size(); ++i)
      for (int v : {edge.first, edge.second})
        corners.join(corner(use.faces[0], v), corner(use.faces[i], v));
  std::vector<std::set<int>> fans(shape.vertices.size());
  for (int f = 0; f < shape.face_count(); ++f)
    for (int i = 0; i < 3; ++i) fans[shape.faces[f][i]].insert(corners.root(3 * f + i));
  return static_cast<int>(
      std::count_if(fans.begin(), fans.end(), [](const auto& f) { return f.size() > 1; }));
}

int count_duplicates(const Shape& shape) {
  std::set<Corners> seen;
  for (Corners f : shape.faces) {
    std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
    seen.insert(f);
  }
  return shape.face_count() - static_cast<int>(seen.size());
}

int count_used_vertices(const Shape& shape) {
  std::set<int> used;
  for (const Corners& f : shape.faces) used.insert(f.begin(), f.end());
  return static_cast<int>(used.size());
}

Point centre(const Shape& shape, const Corners& face) {
  const auto [a, b, c] = corners_of(shape, face);
  return (a + b + c) / 3.0;
}

struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  int face = -1;
};

/// Exact nearest points by trying every face whose bounding ball comes near enough.
class Surface {
 public:
  explicit Surface(const Shape& shape) : shape_(shape) {
    for (const Corners& face : shape.faces) {
      centre_.push_back(centre(shape, face));
      radius_.push_back(0.0);
      for (int v : face)
        radius_.back() = std::max(radius_.back(), (shape.vertices[v] - centre_.back()).norm());
    }
  }

  Nearest nearest(const Point& p) const {
    Nearest best;
    for (int f = 0; f < shape_.face_count(); ++f) {
      const double reach = best.distance + radius_[f];
      if ((p - centre_[f]).squaredNorm() > reach * reach) continue;
      const double distance = distance_to_face(f, p);
      if (distance < best.distance) best = {distance, f};
    }
    return best;
  }

 private:
  double distance_to_face(int f, const Point& p) const {
    const auto [a, b, c] = corners_of(shape_, shape_.faces[f]);
    const auto as_vcg = [](const Point& q) { return vcg::Point3d(q.x(), q.y(), q.z()); };
    double distance;
    vcg::Point3d closest;
    vcg::TrianglePointDistance(vcg::Triangle3<double>(as_vcg(a), as_vcg(b), as_vcg(c)), as_vcg(p),
                               distance, closest);
    return distance;
  }

  const Shape& shape_;
  std::vector<Point> centre_;
  std::vector<double> radius_;
};

double one_sided_distance(const Shape& from, const Shape& to) {
  const Surface surface(to);
  double largest = 0.0;
  for (const Point& p : from.vertices) largest = std::max(largest, surface.nearest(p).distance);
  for (const Corners& f : from.faces)
    largest = std::max(largest, surface.nearest(centre(from, f)).distance);
  return largest;
}

double mean_square_distance(const Shape& from, const Shape& to) {
  const Surface surface(to);
  double sum = 0.0, weight = 0.0;
  for (const Corners& f : from.faces) {
    const double size = double_area(from, f).norm(), d = surface.nearest(centre(from, f)).distance;
    sum += size * d * d;
    weight += size;
  }
  return sum / weight;
}

}  // namespace

Topology topology(const Shape& shape) {
  const EdgeUses edges = edges_of(shape);
  const int used = count_used_vertices(shape);
  Topology t;
  t.euler = used - static_cast<int>(edges.size()) + shape.face_count();
  t.components = count_components(shape);
  t.boundary_loops = count_boundary_loops(edges, shape.vertex_count());
  for (const auto& [edge, use] : edges) {
    t.nonmanifold_edges += use.faces.size() > 2;
    t.inconsistent_edges += use.faces.size() == 2 && use.forward != 1;
  }
  t.nonmanifold_vertices = count_nonmanifold_vertices(shape, edges);
  t.duplicate_faces = count_duplicates(shape);
  t.faces_with_repeated_index =
      static_cast<int>(std::count_if(shape.faces.begin(), shape.faces.end(), has_repeated_index));
  t.unreferenced_vertices = shape.vertex_count() - used;
  return t;
}

std::ostream& operator<<(std::ostream& out, const Topology& t) {
  return out << "euler " << t.euler << ", components " << t.components << ", loops "
             << t.boundary_loops << ", non-manifold edges " << t.nonmanifold_edges
             << " and vertices " << t.nonmanifold_vertices << ", inconsistent edges "
             << t.inconsistent_edges << ", duplicate faces " << t.duplicate_faces
             << ", repeated indices " << t.faces_with_repeated_index << ", unreferenced "
             << t.unreferenced_vertices;
}

bool keeps_topology(const Topology& before, const Topology& after) {
  const auto facts = [](const Topology& t) {
    return std::array<int, 7>{t.euler,
                              t.components,
                              t.boundary_loops,
                              t.nonmanifold_vertices,
                              t.duplicate_faces,
                              t.faces_with_repeated_index,
                              t.unreferenced_vertices};
  };
  const auto fewer_but_not_gone = [](int was, int is) {
    return is <= was && (is > 0) == (was > 0);
  };
  return facts(before) == facts(after) &&
         fewer_but_not_gone(before.nonmanifold_edges, after.nonmanifold_edges) &&
         fewer_but_not_gone(before.inconsistent_edges, after.inconsistent_edges);
}

bool all_finite(const Shape& shape) {
  return std::all_of(shape.vertices.begin(), shape.vertices.end(),
                     [](const Point& p) { return p.allFinite(); });
}

double diagonal(const Shape& shape) {
  Point low = shape.vertices[0], high = low;
  for (const Point& p : shape.vertices) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return (high - low).norm();
}

double area(const Shape& shape) {
  double sum = 0.0;
  for (const Corners& f : shape.faces) sum += 0.5 * double_area(shape, f).norm();
  return sum;
}

double volume(const Shape& shape) {
  double sum = 0.0;
  for (const Corners& f : shape.faces) sum += double_area(shape, f).dot(shape.vertices[f[0]]) / 6.0;
  return sum;
}

int flipped_faces(const Shape& original, const Shape& simplified) {
  const double negligible = 2e-12 * diagonal(original) * diagonal(original);
  const Surface surface(original);
  const std::vector<bool> few = lies_in_few_faces(simplified);
  int flipped = 0;
  for (int i = 0; i < simplified.face_count(); ++i) {
    const Corners& f = simplified.faces[i];
    const Point normal = double_area(simplified, f);
    if (normal.norm() <= negligible || few[i]) continue;
    const int there = surface.nearest(centre(simplified, f)).face;
    flipped += normal.dot(double_area(original, original.faces[there])) <= 0.0;
  }
  return flipped;
}

bool has_vertex(const Shape& shape, const Point& p, double tolerance) {
  return std::any_of(shape.vertices.begin(), shape.vertices.end(),
                     [&](const Point& q) { return (p - q).norm() <= tolerance; });
}

double distance_to(const Shape& surface, const Point& p) {
  return Surface(surface).nearest(p).distance;
}

double two_sided_distance(const Shape& a, const Shape& b) {
  return std::max(one_sided_distance(a, b), one_sided_distance(b, a));
}

double one_sided_sampled_distance(const Shape& from, const Shape& to) {
  constexpr int steps = 4;  // 15 points a face
  const Surface surface(to);
  double largest = 0.0;
  for (const Corners& f : from.faces) {
    const auto [a, b, c] = corners_of(from, f);
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        const Point p = a + (b - a) * (double(i) / steps) + (c - a) * (double(j) / steps);
        largest = std::max(largest, surface.nearest(p).distance);
      }
  }
  return largest;
}

double sampled_distance(const Shape& a, const Shape& b) {
  return std::max(one_sided_sampled_distance(a, b), one_sided_sampled_distance(b, a));
}

double two_sided_rms(const Shape& a, const Shape& b) {
  return std::sqrt(0.5 * (mean_square_distance(a, b) + mean_square_distance(b, a)));
}

double smallest_angle(const Shape& shape) {
  double smallest = 180.0;
  for (const Corners& f : shape.faces)
    for (int i = 0; i < 3; ++i) {
      const Point u = shape.vertices[f[(i + 1) % 3]] - shape.vertices[f[i]];
      const Point v = shape.vertices[f[(i + 2) % 3]] - shape.vertices[f[i]];
      smallest = std::min(smallest,
                          std::atan2(u.cross(v).norm(), u.dot(v)) * 180.0 / 3.14159265358979323846);
    }
  return smallest;
}

}  // namespace curvdecim::test
