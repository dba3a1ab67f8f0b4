// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest mesh type that can be decimated, and a mesh to decimate.
#pragma once

#include <vcg/complex/complex.h>

#include <cmath>
#include <vector>

class Vertex;
class Face;
struct Types : vcg::UsedTypes<vcg::Use<Vertex>::AsVertexType, vcg::Use<Face>::AsFaceType> {};
class Vertex : public vcg::Vertex<Types, vcg::vertex::Coord3d, vcg::vertex::BitFlags> {};
class Face : public vcg::Face<Types, vcg::face::VertexRef, vcg::face::BitFlags> {};
class Mesh : public vcg::tri::TriMesh<std::vector<Vertex>, std::vector<Face>> {};

/// The unit square as cells x cells x 2 faces, flat where x < 1/2 and bumpy elsewhere.
inline void make_bumpy_grid(Mesh& mesh, int cells) {
  using Allocator = vcg::tri::Allocator<Mesh>;
  const int row = cells + 1;
  Allocator::AddVertices(mesh, row * row);
  for (int v = 0; v < row * row; ++v) {
    const double x = double(v % row) / cells, y = double(v / row) / cells;
    const double bump = 0.05 * std::sin(25.0 * (x - 0.5)) * std::sin(25.0 * y);
    mesh.vert[v].P() = {x, y, x < 0.5 ? 0.0 : bump};
  }
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      const int v = y * row + x;
      Allocator::AddFace(mesh, v, v + 1, v + row + 1);
      Allocator::AddFace(mesh, v, v + row + 1, v + row);
    }
}
