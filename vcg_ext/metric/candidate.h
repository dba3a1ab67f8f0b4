// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/connectivity/edge_neighborhood.h"
#include "vcg_ext/geometry/vector3.h"

namespace curvdecim {

/// Where the kinds of the two ends let the merged vertex lie.
enum class Allowed { Anywhere, OntoA, OntoB };

/// A collapse that could be done.
struct Candidate {
  double cost;
  Vector3 position;
  double t;  // 0..1: where along the edge attributes are taken from
};

/// A collapse that was done: `gone` went into `keep`.
struct Collapse {
  int keep, gone;
  Vector3 keep_was, gone_was;  // positions before
  Vector3 now;                 // position after
  double t;                    // 0: where keep was, 1: where gone was
};

}  // namespace curvdecim
