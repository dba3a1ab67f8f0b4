// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/errors.h"

#include "vcg_ext/simplification_error.h"

namespace curvdecim::test {

namespace {

template <class MeshType>
ErrorReport error_as(const Shape& original, const Shape& simplified, const ErrorParams& params) {
  MeshType first, second;
  fill(first, original), fill(second, simplified);
  return simplification_error(first, second, params);
}

}  // namespace

ErrorReport error_between(RichMesh& original, RichMesh& simplified, const ErrorParams& params,
                          const Progress& progress) {
  return simplification_error(original, simplified, params, progress);
}

ErrorReport error_between(const Shape& original, const Shape& simplified,
                          const ErrorParams& params) {
  return error_as<RichMesh>(original, simplified, params);
}

ErrorReport error_between_float(const Shape& original, const Shape& simplified,
                                const ErrorParams& params) {
  return error_as<FloatMesh>(original, simplified, params);
}

SurfaceFigures figures_of(const Shape& shape) {
  ErrorParams few;
  few.sample_num = 1000;
  return error_between(shape, shape, few).original;
}

}  // namespace curvdecim::test
