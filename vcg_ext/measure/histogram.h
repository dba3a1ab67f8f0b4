// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "vcg_ext/error_report.h"
#include "vcg_ext/measure/distances.h"
#include "vcg_ext/measure/most_curved.h"

namespace curvdecim::detail {

/// Where the scale of colours ends if no tolerance is given: so much of both areas has less. A few
/// spikes would make the rest one colour.
inline double end_of_scale(const Readings& forth, const Readings& back) {
  constexpr double beyond = 0.01;
  std::vector<double> distance(forth.distance.begin(), forth.distance.end());
  distance.insert(distance.end(), back.distance.begin(), back.distance.end());
  return least_of_largest(std::move(distance), beyond);
}

/// The histogram of both surfaces' distances. end: in the box of diagonal 1.
inline ErrorHistogram histogram_of(const Readings& forth, const Readings& back, double end) {
  ErrorHistogram histogram;
  histogram.end = end;
  constexpr double bins = ErrorHistogram::bins;
  const double part = 1.0 / (double(forth.count()) + back.count());
  for (const Readings* readings : {&forth, &back})
    for (double distance : readings->distance) {
      const double bin = end > 0.0        ? std::min(distance / end * bins, bins)
                         : distance > 0.0 ? bins
                                          : 0.0;
      histogram.share[static_cast<std::size_t>(bin)] += part;
    }
  return histogram;
}

}  // namespace curvdecim::detail
