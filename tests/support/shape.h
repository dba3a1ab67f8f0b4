// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <functional>
#include <initializer_list>
#include <vector>

namespace curvdecim::test {

using Point = Eigen::Vector3d;
using Corners = std::array<int, 3>;

/// A mesh as plain arrays: what the tests draw and what they look at.
struct Shape {
  std::vector<Point> vertices;
  std::vector<Corners> faces;

  int face_count() const { return static_cast<int>(faces.size()); }
  int vertex_count() const { return static_cast<int>(vertices.size()); }

  bool operator==(const Shape& o) const { return vertices == o.vertices && faces == o.faces; }
};

inline std::array<Point, 3> corners_of(const Shape& shape, const Corners& face) {
  return {shape.vertices[face[0]], shape.vertices[face[1]], shape.vertices[face[2]]};
}

/// Normal times twice the area.
inline Point double_area(const Shape& shape, const Corners& face) {
  const auto [a, b, c] = corners_of(shape, face);
  return (b - a).cross(c - a);
}

/// Every vertex moved by `move`.
Shape mapped(Shape shape, const std::function<Point(const Point&)>& move);
Shape scaled(const Shape& shape, double factor);
Shape translated(const Shape& shape, const Point& step);
Shape rotated(const Shape& shape, double radians, const Point& axis);

/// All in one mesh, sharing no vertex.
Shape side_by_side(std::initializer_list<Shape> parts);

/// Vertices and faces in an arbitrary order that is the same for the same seed.
Shape renumbered(const Shape& shape, unsigned seed);

}  // namespace curvdecim::test
