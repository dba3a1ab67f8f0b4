// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>
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
DecimationReport decimate(SkinnedMesh& mesh, const EdgeCollapseParams& params,
                          const Progress& progress = {});
DecimationReport decimate(RichMesh& mesh, const EdgeCollapseParams& params,
                          const Progress& progress = {});
DecimationReport decimate(RichMesh& mesh, const SphereParams& params,
                          const Progress& progress = {});
void importance(RichMesh& mesh, const ImportanceParams& params);

struct Decimated {
  Shape shape;
  DecimationReport report;
};

/// The parameters of any edge collapse.
using AnyParams = std::variant<EdgeCollapseParams, SphereParams>;

DecimationParams& shared(AnyParams& params);

Decimated decimated(const Shape& shape, const EdgeCollapseParams& params);  ///< double coordinates
Decimated decimated(const Shape& shape, const AnyParams& params);           ///< double coordinates
Decimated decimated_float(const Shape& shape,
                          const EdgeCollapseParams& params);             ///< single coordinates
Decimated decimated_float(const Shape& shape, const AnyParams& params);  ///< single coordinates

EdgeCollapseParams to_faces(int faces);
SphereParams spheres_to_faces(int faces);

/// A way to decimate, with its name.
struct Variant {
  std::string name;
  AnyParams params;

  AnyParams with_target(int faces) const;
  AnyParams with_max_error(double length) const;
};

/// The 48 ways to combine metric, quadrics, plane weight and placement.
std::vector<Variant> quadric_variants();

/// The 4 ways to combine energy and placement.
std::vector<Variant> sphere_variants();

/// Both.
std::vector<Variant> all_variants();

}  // namespace curvdecim::test
