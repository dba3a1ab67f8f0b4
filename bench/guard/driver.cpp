// SPDX-License-Identifier: GPL-3.0-or-later
// driver MESH PRESET TARGET_FACES: decimates once and prints the seconds. It is compiled with the
// core of two commits, so it uses nothing of the interface but what every commit has.
#include <vcg/complex/complex.h>

#include <chrono>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "vcg_ext/decimate.h"

namespace {

class GuardVertex;
class GuardFace;
struct GuardTypes
    : vcg::UsedTypes<vcg::Use<GuardVertex>::AsVertexType, vcg::Use<GuardFace>::AsFaceType> {};
class GuardVertex : public vcg::Vertex<GuardTypes, vcg::vertex::Coord3d, vcg::vertex::BitFlags> {};
class GuardFace : public vcg::Face<GuardTypes, vcg::face::VertexRef, vcg::face::BitFlags> {};
class GuardMesh : public vcg::tri::TriMesh<std::vector<GuardVertex>, std::vector<GuardFace>> {};

template <class T>
std::vector<T> take(std::istream& file, std::int64_t count) {
  std::vector<T> values(static_cast<std::size_t>(count));
  file.read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(values.size() * sizeof(T)));
  if (!file) throw std::runtime_error("the mesh file ends too early");
  return values;
}

/// The file of binary_mesh.py.
void read(const std::string& path, GuardMesh& mesh) {
  std::ifstream file(path, std::ios::binary);
  const auto sizes = take<std::int64_t>(file, 2);
  const auto points = take<double>(file, 3 * sizes[0]);
  const auto corners = take<std::int32_t>(file, 3 * sizes[1]);
  vcg::tri::Allocator<GuardMesh>::AddVertices(mesh, static_cast<std::size_t>(sizes[0]));
  vcg::tri::Allocator<GuardMesh>::AddFaces(mesh, static_cast<std::size_t>(sizes[1]));
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    mesh.vert[v].P() = {points[3 * v], points[3 * v + 1], points[3 * v + 2]};
  }
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      mesh.face[f].V(static_cast<int>(i)) =
          &mesh.vert[static_cast<std::size_t>(corners[3 * f + i])];
    }
  }
}

curvdecim::Preset preset_of(const std::string& name) {
  if (name == "Fast") return curvdecim::Preset::Fast;
  if (name == "Balanced") return curvdecim::Preset::Balanced;
  if (name == "Best") return curvdecim::Preset::Best;
  throw std::invalid_argument("no preset " + name);
}

double seconds_of(GuardMesh& mesh, const std::string& preset, int target) {
  curvdecim::EdgeCollapseParams params;
  params.preset = preset_of(preset);
  params.target_faces = target;
  const auto start = std::chrono::steady_clock::now();
  curvdecim::decimate_edge_collapse(mesh, params);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) {
    std::cerr << "usage: " << words[0] << " MESH Fast|Balanced|Best TARGET_FACES\n";
    return 2;
  }
  try {
    GuardMesh mesh;
    read(words[1], mesh);
    std::cout << seconds_of(mesh, words[2], std::stoi(words[3])) << '\n';
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
