// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/drawn_meshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace curvdecim::test {

namespace {

constexpr double pi = 3.14159265358979323846;

Point on_circle(double turn, double radius, double z) {
  return {radius * std::cos(2.0 * pi * turn), radius * std::sin(2.0 * pi * turn), z};
}

/// One vertex per grid point, shared by all faces that use it.
class Welder {
 public:
  explicit Welder(Shape& shape) : shape_(shape) {}

  int operator()(const Point& p) {
    const auto [place, is_new] = index_.try_emplace({p.x(), p.y(), p.z()}, shape_.vertex_count());
    if (is_new) shape_.vertices.push_back(p);
    return place->second;
  }

 private:
  Shape& shape_;
  std::map<std::array<double, 3>, int> index_;
};

}  // namespace

Shape one_triangle() { return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}; }

Shape two_triangles() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

Shape triangle_strip(int faces) {
  Shape strip;
  for (int v = 0; v < faces + 2; ++v) strip.vertices.push_back({0.5 * v, v % 2 ? 1.0 : 0.0, 0.0});
  for (int f = 0; f < faces; ++f)
    strip.faces.push_back(f % 2 ? Corners{f, f + 2, f + 1} : Corners{f, f + 1, f + 2});
  for (Corners& face : strip.faces) std::swap(face[1], face[2]);  // counter-clockwise
  return strip;
}

Shape tetrahedron() {
  return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
          {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

Shape octahedron() {
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

Shape cube() { return dense_box(1, {1, 1, 1}); }

Shape fan(int blades) {
  Shape shape{{Point::Zero()}, {}};
  for (int i = 0; i < blades; ++i) {
    shape.vertices.push_back(on_circle(double(i) / blades, 1.0, 0.0));
    shape.faces.push_back({0, 1 + i, 1 + (i + 1) % blades});
  }
  return shape;
}

Shape polygon_fan(int corners) {
  Shape shape;
  for (int i = 0; i < corners; ++i) {
    shape.vertices.push_back(on_circle(double(i) / corners, 1.0, 0.0));
    if (i > 1) shape.faces.push_back({0, i - 1, i});
  }
  return shape;
}

Shape bowtie() {
  return {{{0, 0, 0}, {1, -0.5, 0}, {1, 0.5, 0}, {-1, 0.5, 0}, {-1, -0.5, 0}},
          {{0, 1, 2}, {0, 3, 4}}};
}

Shape book(int pages, int cells) {
  Shape all;
  Welder weld(all);
  for (int i = 0; i <= cells; ++i) weld({0, 0, double(i) / cells});
  for (int page = 0; page < pages; ++page) {
    const Shape sheet = mapped(plane_grid(cells), [=](const Point& p) -> Point {
      return p.x() == 0.0 ? Point(0, 0, p.y()) : on_circle(double(page) / pages, p.x(), p.y());
    });
    for (const Corners& f : sheet.faces)
      all.faces.push_back(
          {weld(sheet.vertices[f[0]]), weld(sheet.vertices[f[1]]), weld(sheet.vertices[f[2]])});
  }
  return all;
}

Shape touching_spheres() {
  const Shape ball = icosphere(2);
  const int count = ball.vertex_count();
  const auto twin = [=](int v) { return v == 0 ? 0 : count + v - 1; };
  Shape both = ball;
  for (int v = 1; v < count; ++v)
    both.vertices.push_back(2.0 * ball.vertices[0] - ball.vertices[v]);
  for (const Corners& f : ball.faces) both.faces.push_back({twin(f[0]), twin(f[2]), twin(f[1])});
  return both;
}

Shape lattice(int columns, int rows, Seam seam_u, Seam seam_v,
              const std::function<Point(double, double)>& point) {
  const int wide = seam_u == Seam::Open ? columns + 1 : columns,
            high = seam_v == Seam::Open ? rows + 1 : rows;
  Shape shape;
  for (int i = 0; i < wide; ++i)
    for (int j = 0; j < high; ++j)
      shape.vertices.push_back(point(double(i) / columns, double(j) / rows));
  const auto vertex = [&](int i, int j) {
    if (i == columns && seam_u == Seam::Twisted) j = rows - j;
    return (i % wide) * high + j % high;
  };
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      shape.faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      shape.faces.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return shape;
}

Shape plane_grid(int cells) {
  return lattice(cells, cells, Seam::Open, Seam::Open,
                 [](double u, double v) { return Point(u, v, 0.0); });
}

Shape annulus(int around, int across) {
  return lattice(around, across, Seam::Closed, Seam::Open,
                 [](double u, double v) { return on_circle(u, 1.0 + v, 0.0); });
}

Shape grid_with_small_holes(int cells) {
  Shape grid = plane_grid(cells);
  const int quarter = cells / 4;
  const auto first_face = [&](int column, int row) { return 2 * (column * cells + row); };
  std::vector<int> gone;
  for (int k = 1; k <= 2; ++k) {
    gone.push_back(first_face(k * quarter, quarter));      // a hole of three edges
    gone.push_back(first_face(k * quarter, 3 * quarter));  // one of four
    gone.push_back(first_face(k * quarter, 3 * quarter) + 1);
  }
  std::sort(gone.rbegin(), gone.rend());
  for (int f : gone) grid.faces.erase(grid.faces.begin() + f);
  return grid;
}

Shape icosphere(int subdivisions) {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  Shape ball{{{-1, g, 0},
              {1, g, 0},
              {-1, -g, 0},
              {1, -g, 0},
              {0, -1, g},
              {0, 1, g},
              {0, -1, -g},
              {0, 1, -g},
              {g, 0, -1},
              {g, 0, 1},
              {-g, 0, -1},
              {-g, 0, 1}},
             {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
              {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
              {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for (int round = 0; round < subdivisions; ++round) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), ball.vertex_count());
      if (is_new) ball.vertices.push_back(0.5 * (ball.vertices[a] + ball.vertices[b]));
      return place->second;
    };
    std::vector<Corners> finer;
    for (const auto& [a, b, c] : ball.faces) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    ball.faces = std::move(finer);
  }
  return mapped(ball, [](const Point& p) -> Point { return p.normalized(); });
}

Shape noisy_sphere(int subdivisions, double noise) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> factor(1.0 - noise, 1.0 + noise);
  return mapped(icosphere(subdivisions),
                [&](const Point& p) -> Point { return factor(random) * p; });
}

Shape bumpy_sphere(int subdivisions) {
  return mapped(icosphere(subdivisions), [](const Point& p) -> Point {
    const double bumps = std::sin(9.0 * p.x()) * std::sin(9.0 * p.y()) * std::sin(9.0 * p.z());
    return (1.0 + (p.z() > 0.0 ? 0.12 * p.z() * bumps : 0.0)) * p;
  });
}

Shape torus(int around, int across) {
  return lattice(around, across, Seam::Closed, Seam::Closed, [](double u, double v) {
    return on_circle(u, 1.0 + 0.4 * std::cos(2.0 * pi * v), 0.4 * std::sin(2.0 * pi * v));
  });
}

Shape open_cylinder(int around, int along) {
  return lattice(around, along, Seam::Closed, Seam::Open,
                 [](double u, double v) { return on_circle(u, 1.0, 2.0 * v); });
}

Shape capped_cylinder(int around, int along) {
  Shape shape = open_cylinder(around, along);
  const int bottom = shape.vertex_count(), top = bottom + 1, high = along + 1;
  shape.vertices.push_back({0, 0, 0});
  shape.vertices.push_back({0, 0, 2});
  for (int i = 0; i < around; ++i) {
    const int next = (i + 1) % around;
    shape.faces.push_back({bottom, next * high, i * high});
    shape.faces.push_back({top, i * high + along, next * high + along});
  }
  return shape;
}

Shape double_cone(int sides) {
  Shape shape = fan(sides);
  shape.vertices[0] = {0, 0, 0.5};
  shape.vertices.push_back({0, 0, -0.5});
  for (int f = 0; f < sides; ++f)
    shape.faces.push_back({shape.vertex_count() - 1, shape.faces[f][2], shape.faces[f][1]});
  return shape;
}

Shape rough_cone(int sides) {
  std::minstd_rand random(sides);
  std::uniform_real_distribution<double> radius(0.95, 1.05), height(-0.05, 0.05);
  Shape cone = fan(sides);
  cone.vertices[0].z() = 1.0;
  for (int v = 1; v <= sides; ++v)
    cone.vertices[v] = radius(random) * cone.vertices[v] + Point(0, 0, height(random));
  return cone;
}

Shape rough_cones(int sides, int count) {
  std::minstd_rand random(sides);
  std::uniform_real_distribution<double> radius(0.6, 1.0), height(-1.0, 1.0), tip(1.0, 3.0);
  Shape cones;
  for (int i = 0; i < count; ++i) {
    Shape cone = double_cone(sides);
    for (int v = 1; v <= sides; ++v)
      cone.vertices[v] = radius(random) * cone.vertices[v] + Point(0, 0, height(random));
    cone.vertices.front().z() = tip(random), cone.vertices.back().z() = -tip(random);
    cones = side_by_side({cones, translated(cone, {2.0 * i, 0.0, 0.0})});
  }
  return cones;
}

Shape saddle(int cells) {
  return mapped(plane_grid(cells), [](const Point& p) {
    const double x = p.x() - 0.5, y = p.y() - 0.5;
    return Point(x, y, x * x - y * y);
  });
}

Shape dense_box(int cells, const Point& size) {
  const Shape side = plane_grid(cells);
  Shape box;
  Welder weld(box);
  for (int axis = 0; axis < 3; ++axis)
    for (double height : {0.0, 1.0})
      for (Corners face : side.faces) {
        if (height == 0.0) std::swap(face[1], face[2]);
        for (int& v : face) {
          Point p;
          p[axis] = height, p[(axis + 1) % 3] = side.vertices[v].x(),
          p[(axis + 2) % 3] = side.vertices[v].y();
          v = weld(p.cwiseProduct(size));
        }
        box.faces.push_back(face);
      }
  return box;
}

Shape moebius_strip(int around, int across) {
  return lattice(around, across, Seam::Twisted, Seam::Open, [](double u, double v) {
    const double half = pi * u, s = v - 0.5;
    return on_circle(u, 1.0 + 0.6 * s * std::cos(half), 0.6 * s * std::sin(half));
  });
}

Shape klein_bottle(int around, int across) {
  return lattice(around, across, Seam::Twisted, Seam::Closed, [](double u, double v) {
    const double c = std::cos(pi * u), s = std::sin(pi * u);
    const double x = std::sin(2.0 * pi * v), y = std::sin(4.0 * pi * v);
    return on_circle(u, 2.5 + c * x - s * y, s * x + c * y);
  });
}

Shape large_and_small_sphere() {
  return side_by_side({icosphere(2), translated(scaled(icosphere(1), 0.05), {1.5, 0.2, 0.1})});
}

}  // namespace curvdecim::test
