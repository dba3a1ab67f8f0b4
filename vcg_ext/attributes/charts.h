// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "vcg_ext/collapse/collapse_observer.h"

namespace curvdecim::detail {

/// What the corners at the ends of an edge carry that is carried as one: those at one vertex with
/// the same value, and those that a face at the edge joins.
template <class Value>
struct Chart {
  struct Corner {
    int vertex;
    Value at;
  };
  std::vector<Corner> corners;
  std::vector<int> faces;

  bool shares_corner(const std::vector<Corner>& others) const {
    for (const Corner& known : corners)
      for (const Corner& corner : others)
        if (known.vertex == corner.vertex && known.at == corner.at) return true;
    return false;
  }
};

/// The charts around an edge before its collapse. of_corner(f, i): the value at a corner.
template <class Value, class OfCorner>
std::vector<Chart<Value>> charts_around(const WorkingMesh& mesh, const EdgeNeighborhood& around,
                                        const VertexMerge& merge, OfCorner of_corner) {
  std::vector<Chart<Value>> charts;
  const auto join = [&](int f) {
    std::vector<typename Chart<Value>::Corner> corners;
    for (int i = 0; i < 3; ++i)
      if (const int v = mesh.connectivity.face(f)[i]; v == merge.keep || v == merge.gone)
        corners.push_back({v, of_corner(f, i)});
    const auto known = std::find_if(charts.begin(), charts.end(), [&](const Chart<Value>& chart) {
      return chart.shares_corner(corners);
    });
    if (known == charts.end()) return charts.push_back({corners, {f}});
    known->corners.insert(known->corners.end(), corners.begin(), corners.end());
    known->faces.push_back(f);
  };
  for (const std::vector<int>* faces : {&around.wings(), &around.star()})
    for (int f : *faces) join(f);
  return charts;
}

/// True if the collapse removes the face.
inline bool is_wing(const EdgeNeighborhood& around, int f) {
  return std::count(around.wings().begin(), around.wings().end(), f) > 0;
}

}  // namespace curvdecim::detail
