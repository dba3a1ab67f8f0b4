// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/soups.h"

#include <utility>

namespace curvdecim::test {
namespace {

Shape random_soup(Dice& dice) {
  constexpr int side = 3;
  Shape soup;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) soup.vertices.push_back(Point(x, y, z));
  const int vertices = 4 + dice.below(soup.vertex_count() - 3);
  std::swap(soup.vertices[0], soup.vertices[dice.below(soup.vertex_count())]);
  soup.vertices.resize(vertices);
  for (int faces = 4 + dice.below(37); faces > 0; --faces)
    soup.faces.push_back({dice.below(vertices), dice.below(vertices), dice.below(vertices)});
  return soup;
}

/// A grid with a few faces missing, turned over, bent or given twice.
Shape damaged_mesh(Dice& dice) {
  constexpr int cells = 3;
  Shape mesh;
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) mesh.vertices.push_back(Point(i, j, dice.below(2)));
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const int v = i * (cells + 1) + j, w = v + cells + 1;
      mesh.faces.push_back({v, w, w + 1});
      mesh.faces.push_back({v, w + 1, v + 1});
    }
  for (int damage = 1 + dice.below(4); damage > 0; --damage) {
    Corners& face = mesh.faces[dice.below(mesh.face_count())];
    switch (dice.below(4)) {
      case 0: face[dice.below(3)] = dice.below(mesh.vertex_count()); break;
      case 1: std::swap(face[0], face[1]); break;
      case 2: mesh.faces.erase(mesh.faces.begin() + dice.below(mesh.face_count())); break;
      case 3: mesh.faces.push_back(face); break;
    }
  }
  return mesh;
}

}  // namespace

std::vector<Family> families() { return {{"Soup", random_soup}, {"DamagedMesh", damaged_mesh}}; }

}  // namespace curvdecim::test
