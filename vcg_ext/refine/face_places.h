// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "vcg_ext/geometry/closest_point.h"

namespace curvdecim::detail {

/// Where on a face samples may lie: at its corners, and at the centres of its parts where its edges
/// are cut into 1, 2, 3 ... pieces. A place is a number in the list of all of these.
class FacePlaces {
 public:
  explicit FacePlaces(int most_cuts) : places_{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}} {
    for (int cuts = 1; cuts <= most_cuts; ++cuts) {
      first_.push_back(static_cast<int>(places_.size()));
      add_centres(cuts);
    }
  }

  const Barycentric& operator[](int place) const { return places_[place]; }

  static int of_corner(int corner) { return corner; }

  /// The first of the places of cuts * cuts parts.
  int first_of_parts(int cuts) const { return first_[cuts - 1]; }

 private:
  void add_centres(int cuts) {
    const double third = 1.0 / 3.0;
    const auto add = [&](double x, double y) {
      places_.push_back({1.0 - (x + y) / cuts, x / cuts, y / cuts});
    };
    for (int i = 0; i < cuts; ++i)
      for (int j = 0; i + j < cuts; ++j) {
        add(i + third, j + third);
        if (i + j + 1 < cuts) add(i + 2.0 * third, j + 2.0 * third);
      }
  }

  std::vector<Barycentric> places_;
  std::vector<int> first_;  // by cuts - 1
};

/// Cuts of an edge, so that the parts of a face are about as large as `part`, up to a limit.
inline int cuts_for(double area, double part, int most) {
  return static_cast<int>(std::lround(std::clamp(std::sqrt(area / part), 1.0, double(most))));
}

}  // namespace curvdecim::detail
