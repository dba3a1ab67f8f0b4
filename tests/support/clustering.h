// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "support/mesh_types.h"
#include "support/shape.h"
#include "vcg_ext/vertex_clustering.h"

namespace curvdecim::test {

using namespace detail;

// The core's templates, compiled once for all suites.
ClusteringReport cluster(BareMesh& mesh, const ClusteringParams& params,
                         const Progress& progress = {});
ClusteringReport cluster(FloatMesh& mesh, const ClusteringParams& params,
                         const Progress& progress = {});
ClusteringReport cluster(RichMesh& mesh, const ClusteringParams& params,
                         const Progress& progress = {});

struct Clustered {
  Shape shape;
  ClusteringReport report;
};

Clustered clustered(const Shape& shape, const ClusteringParams& params);        ///< in double
Clustered clustered_float(const Shape& shape, const ClusteringParams& params);  ///< in float

ClusteringParams with_cells(double size);
ClusteringParams to_clusters(int faces);

/// A representative with its name; WeightedMean once for each weight.
struct NamedRepresentative {
  std::string name;
  Representative representative;
  MeanWeight weight = MeanWeight::Area;

  ClusteringParams of(ClusteringParams params) const {
    params.representative = representative, params.mean_weight = weight;
    return params;
  }
};

inline void PrintTo(const NamedRepresentative& representative, std::ostream* out) {
  *out << representative.name;
}

inline std::string representative_name(const testing::TestParamInfo<NamedRepresentative>& info) {
  return info.param.name;
}

/// Those that need no attributes, or all.
std::vector<NamedRepresentative> shape_representatives();
std::vector<NamedRepresentative> all_representatives();

/// What holds of any clustering: a mesh without faces or vertices that mean nothing.
void expect_sound_clusters(const Shape& after);

/// The shape as the clustering sees it.
FlatMesh flat_mesh(const Shape& shape);

}  // namespace curvdecim::test
