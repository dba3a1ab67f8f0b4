// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "support/mesh_types.h"
#include "vcg_ext/params.h"
#include "vcg_ext/report.h"

namespace curvdecim::test {

/// A public function of the core with some of its parameters. What it finds out about a mesh
/// without changing it is written to the quality.
struct Call {
  std::string name;
  std::function<DecimationReport(RichMesh&, const CommonParams&, const Progress&)> run;
};

inline void PrintTo(const Call& call, std::ostream* out) { *out << call.name; }

/// Every public function, with all parameters that choose between ways to do the work.
std::vector<Call> every_call();

}  // namespace curvdecim::test
