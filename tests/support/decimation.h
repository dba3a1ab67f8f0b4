// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "support/mesh_types.h"
#include "support/shape.h"
#include "vcg_ext/errors.h"
#include "vcg_ext/params.h"
#include "vcg_ext/report.h"

namespace curvdecim::test {

// The core's templates, compiled once for all suites.
DecimationReport decimate(BareMesh& mesh, const EdgeCollapseParams& params,
                          const Progress& progress = {});
DecimationReport decimate(FloatMesh& mesh, const EdgeCollapseParams& params,
                          const Progress& progress = {});
DecimationReport decimate(RichMesh& mesh, const EdgeCollapseParams& params,
                          const Progress& progress = {});
void importance(RichMesh& mesh, const ImportanceParams& params);

struct Decimated {
  Shape shape;
  DecimationReport report;
};

Decimated decimated(const Shape& shape, const EdgeCollapseParams& params);  ///< double coordinates
Decimated decimated_float(const Shape& shape,
                          const EdgeCollapseParams& params);  ///< single coordinates

EdgeCollapseParams to_faces(int faces);

/// One of the 48 ways to combine metric, quadrics, plane weight and placement, with its name.
struct Variant {
  std::string name;
  EdgeCollapseParams params;

  EdgeCollapseParams with_target(int faces) const;
};

std::vector<Variant> all_variants();

}  // namespace curvdecim::test
