// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a PLY file, halves its faces, and writes the result:  shrink big.ply small.ply
#include "vcg_ext/edge_collapse.h"  // before vcglib and Eigen

#include <vcg/complex/complex.h>
#include <wrap/io_trimesh/export_ply.h>
#include <wrap/io_trimesh/import_ply.h>

#include <exception>
#include <iostream>
#include <stdexcept>
#include <vector>

class Vertex;
class Face;
struct Types : vcg::UsedTypes<vcg::Use<Vertex>::AsVertexType, vcg::Use<Face>::AsFaceType> {};
class Vertex : public vcg::Vertex<Types, vcg::vertex::Coord3f, vcg::vertex::Normal3f,
                                  vcg::vertex::BitFlags> {};
class Face : public vcg::Face<Types, vcg::face::VertexRef, vcg::face::BitFlags> {};
class Mesh : public vcg::tri::TriMesh<std::vector<Vertex>, std::vector<Face>> {};

int main(int count, char** arguments) try {
  if (count != 3) throw std::runtime_error("shrink BIG.ply SMALL.ply");
  Mesh mesh;
  if (vcg::tri::io::ImporterPLY<Mesh>::Open(mesh, arguments[1]) != 0)
    throw std::runtime_error("cannot read the mesh");

  curvdecim::EdgeCollapseParams params;
  params.target_faces = mesh.fn / 2;
  const curvdecim::DecimationReport report = curvdecim::decimate_edge_collapse(mesh, params);
  std::cout << report.faces_before << " faces became " << report.faces << " faces\n";

  if (vcg::tri::io::ExporterPLY<Mesh>::Save(mesh, arguments[2]) != 0)
    throw std::runtime_error("cannot write the mesh");
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
