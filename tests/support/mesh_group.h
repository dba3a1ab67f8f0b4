// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/drawn_meshes.h"

namespace curvdecim::test {

/// A mesh with the name that a failing test prints.
struct NamedShape {
  std::string name;
  Shape shape;
};

inline void PrintTo(const NamedShape& mesh, std::ostream* out) { *out << mesh.name; }

inline std::string name_of(const testing::TestParamInfo<NamedShape>& info) {
  return info.param.name;
}

inline std::vector<NamedShape> closed_meshes() {
  return {{"icosphere", icosphere(2)},
          {"noisy_sphere", noisy_sphere(2, 0.02)},
          {"torus", torus(24, 12)},
          {"capped_cylinder", capped_cylinder(24, 6)},
          {"dense_box", dense_box(5, {1, 2, 3})},
          {"two_components", large_and_small_sphere()}};
}

inline std::vector<NamedShape> open_meshes() {
  return {{"plane_grid", plane_grid(12)},
          {"saddle", saddle(12)},
          {"open_cylinder", open_cylinder(24, 8)},
          {"annulus", annulus(24, 4)},
          {"small_holes", grid_with_small_holes(12)},
          {"triangle_strip", triangle_strip(40)},
          {"fan", fan(64)}};
}

/// Not orientable, or not manifold.
inline std::vector<NamedShape> difficult_meshes() {
  return {{"moebius_strip", moebius_strip(30, 6)},
          {"klein_bottle", klein_bottle(32, 12)},
          {"three_pages", book(3, 8)},
          {"four_pages", book(4, 8)},
          {"touching_spheres", touching_spheres()}};
}

inline std::vector<NamedShape> manifold_meshes() {
  std::vector<NamedShape> all = closed_meshes();
  for (NamedShape& mesh : open_meshes()) all.push_back(std::move(mesh));
  return all;
}

inline std::vector<NamedShape> all_meshes() {
  std::vector<NamedShape> all = manifold_meshes();
  for (NamedShape& mesh : difficult_meshes()) all.push_back(std::move(mesh));
  return all;
}

}  // namespace curvdecim::test
