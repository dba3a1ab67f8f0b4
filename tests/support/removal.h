// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "support/mesh_types.h"
#include "support/shape.h"
#include "vcg_ext/vertex_removal.h"

namespace curvdecim::test {

using namespace detail;

// The core's templates, compiled once for all suites.
DecimationReport remove(BareMesh& mesh, const VertexRemovalParams& params,
                        const Progress& progress = {});
DecimationReport remove(FloatMesh& mesh, const VertexRemovalParams& params,
                        const Progress& progress = {});
DecimationReport remove(RichMesh& mesh, const VertexRemovalParams& params,
                        const Progress& progress = {});

struct Thinned {
  Shape shape;
  DecimationReport report;
};

Thinned thinned(const Shape& shape, const VertexRemovalParams& params);        ///< in double
Thinned thinned_float(const Shape& shape, const VertexRemovalParams& params);  ///< in float

VertexRemovalParams removal_to(int faces);
VertexRemovalParams removal_within(double distance);

/// A way to remove vertices, with its name.
struct RemovalVariant {
  std::string name;
  RemovalCriterion criterion;
  bool features;

  VertexRemovalParams of(VertexRemovalParams params) const {
    params.criterion = criterion, params.preserve_features = features;
    return params;
  }
};

/// Both criteria, with sharp edges held or not.
std::vector<RemovalVariant> removal_variants();

/// Without the way back to a vcg mesh: of the shape in its own unit, features by the angle.
class RemovalOn {
 public:
  explicit RemovalOn(const Shape& shape, const VertexRemovalParams& params = {},
                     RemovalObservers observers = {});

  VertexClass class_of(int v);
  RemovalAnswer ask(int v);
  /// Removes the vertex that was asked about last.
  void remove(const RemovalAnswer& answer);

  const RemovalPlan plan;
  WorkingMesh mesh;
  RemovalOperator removals;
  RemovalOperator::Scratch scratch;
};

}  // namespace curvdecim::test
