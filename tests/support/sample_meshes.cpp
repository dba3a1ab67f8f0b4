// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sample_meshes.h"

#include <wrap/io_trimesh/import_obj.h>
#include <wrap/io_trimesh/import_ply.h>
#include <wrap/ply/plylib.cpp>  // the PLY reader is not header-only

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "support/mesh_types.h"

namespace curvdecim::test {

namespace {

template <class Importer>
void open_with(RichMesh& mesh, const std::string& file) {
  int loaded = 0;  // which attributes the file has
  const int error = Importer::Open(mesh, file.c_str(), loaded);
  if (Importer::ErrorCritical(error))
    throw std::runtime_error(file + ": " + Importer::ErrorMsg(error));
}

Shape read(const std::filesystem::path& file) {
  RichMesh mesh;
  if (file.extension() == ".obj")
    open_with<vcg::tri::io::ImporterOBJ<RichMesh>>(mesh, file.string());
  else
    open_with<vcg::tri::io::ImporterPLY<RichMesh>>(mesh, file.string());
  Shape shape = shape_of(mesh);
  mesh.ClearAttributes();  // the mesh does not free what the reader attached
  return shape;
}

}  // namespace

Shape sample_mesh(const std::string& file) {
  return read(std::filesystem::path(CURVDECIM_REPOSITORY) / "sample_meshes" / file);
}

std::optional<Shape> shared_mesh(const std::string& file) {
  const char* named = std::getenv("CURVDECIM_MESHES");
  const std::filesystem::path directory =
      named ? std::filesystem::path(named)
            : std::filesystem::path(CURVDECIM_REPOSITORY) / "../shared/meshes";
  if (!std::filesystem::exists(directory / file)) return std::nullopt;
  return read(directory / file);
}

}  // namespace curvdecim::test
