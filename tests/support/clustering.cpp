// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/clustering.h"

#include <utility>

#include "support/properties.h"

namespace curvdecim::test {

namespace {

template <class MeshType>
Clustered clustered_as(const Shape& shape, const ClusteringParams& params) {
  MeshType mesh;
  fill(mesh, shape);
  ClusteringReport report = cluster(mesh, params);
  return {shape_of(mesh), std::move(report)};
}

}  // namespace

ClusteringReport cluster(BareMesh& mesh, const ClusteringParams& params, const Progress& progress) {
  return decimate_vertex_clustering(mesh, params, progress);
}

ClusteringReport cluster(FloatMesh& mesh, const ClusteringParams& params,
                         const Progress& progress) {
  return decimate_vertex_clustering(mesh, params, progress);
}

ClusteringReport cluster(RichMesh& mesh, const ClusteringParams& params, const Progress& progress) {
  return decimate_vertex_clustering(mesh, params, progress);
}

Clustered clustered(const Shape& shape, const ClusteringParams& params) {
  return clustered_as<BareMesh>(shape, params);
}

Clustered clustered_float(const Shape& shape, const ClusteringParams& params) {
  return clustered_as<FloatMesh>(shape, params);
}

ClusteringParams with_cells(double size) {
  ClusteringParams params;
  params.cell_size = size;
  return params;
}

ClusteringParams to_clusters(int faces) {
  ClusteringParams params;
  params.target_faces = faces;
  return params;
}

std::vector<NamedRepresentative> shape_representatives() {
  return {{"Quadric", Representative::Quadric},
          {"Mean", Representative::Mean},
          {"MeanByArea", Representative::WeightedMean, MeanWeight::Area},
          {"MeanByCurvature", Representative::WeightedMean, MeanWeight::Curvature},
          {"Median", Representative::Median},
          {"CellCenter", Representative::CellCenter}};
}

std::vector<NamedRepresentative> all_representatives() {
  std::vector<NamedRepresentative> all = shape_representatives();
  all.push_back({"MeanByQuality", Representative::WeightedMean, MeanWeight::Quality});
  return all;
}

void expect_sound_clusters(const Shape& after) {
  const Topology is = topology(after);
  EXPECT_TRUE(all_finite(after));
  EXPECT_EQ(is.faces_with_repeated_index, 0);
  EXPECT_EQ(is.duplicate_faces, 0);
  EXPECT_EQ(is.unreferenced_vertices, 0);
  EXPECT_GT(after.face_count(), 0);
}

FlatMesh flat_mesh(const Shape& shape) {
  BareMesh mesh;
  fill(mesh, shape);
  return read_flat(mesh, false, Parallel(1));
}

}  // namespace curvdecim::test
