// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/shape.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace curvdecim::test {

Shape mapped(Shape shape, const std::function<Point(const Point&)>& move) {
  for (Point& p : shape.vertices) p = move(p);
  return shape;
}

Shape scaled(const Shape& shape, double factor) {
  return mapped(shape, [=](const Point& p) -> Point { return factor * p; });
}

Shape translated(const Shape& shape, const Point& step) {
  return mapped(shape, [=](const Point& p) -> Point { return p + step; });
}

Shape rotated(const Shape& shape, double radians, const Point& axis) {
  const Eigen::AngleAxisd turn(radians, axis.normalized());
  return mapped(shape, [=](const Point& p) -> Point { return turn * p; });
}

Shape side_by_side(std::initializer_list<Shape> parts) {
  Shape all;
  for (const Shape& part : parts) {
    const int first = all.vertex_count();
    all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const Corners& f : part.faces)
      all.faces.push_back({f[0] + first, f[1] + first, f[2] + first});
  }
  return all;
}

Shape renumbered(const Shape& shape, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<int> new_index(shape.vertices.size());
  std::iota(new_index.begin(), new_index.end(), 0);
  std::shuffle(new_index.begin(), new_index.end(), random);
  Shape result = shape;
  for (int v = 0; v < shape.vertex_count(); ++v) result.vertices[new_index[v]] = shape.vertices[v];
  for (Corners& face : result.faces)
    face = {new_index[face[0]], new_index[face[1]], new_index[face[2]]};
  std::shuffle(result.faces.begin(), result.faces.end(), random);
  return result;
}

}  // namespace curvdecim::test
