// SPDX-License-Identifier: GPL-3.0-or-later
// How curvature becomes a factor on the cost: what the filters that use or show it share.
#pragma once

#include "filter_curvdecim/table/parameter_row.h"
#include "filter_curvdecim/table/references.h"
#include "vcg_ext/params.h"

namespace curvdecim::glue {

constexpr Reference pellizzoni_savio = {"Pellizzoni, Savio",
                                        "Journal of Computer Science 16(8), 2020"};

template <class P>
ParameterRow<P> alpha_row() {
  return row<P>(
      &P::alpha, "Alpha", "Curvature weight (alpha)",
      {"CurvatureWeighted multiplies the cost by F + (1 - F) (1 - exp(-alpha k&sup2;)), where F is "
       "the <i>Weight of flat places</i> and k the curvature, 1 where the most curved fifth of the "
       "area begins. With the unit ModelUnits the factor is the paper's 1 - exp(-alpha k). A small "
       "alpha protects only the most curved places; a large one brings the factor to 1 everywhere. "
       "0 or less: infinite, that is plain quadrics.",
       "Small protects only the most curved places; 0 or less: plain quadrics."});
}

template <class P>
ParameterRow<P> curvature_floor_row() {
  return row<P>(
      &P::curvature_floor, "CurvatureFloor", "Weight of flat places",
      {"How much flat places count beside curved ones. F in the formula of <i>Curvature "
       "weight</i>: the factor where the curvature is 0, with the "
       "unit ScaleFree. Lower spends more triangles on curved places and fewer on flat ones: the "
       "default takes about a tenth off the error of the most curved fifth of the area for a "
       "fiftieth more on the whole, 0.01 about a quarter for a quarter more. 1 is plain quadrics. "
       "With ModelUnits it is 0, as in the paper.",
       "1: as much as curved ones; lower gives these more faces (strong: 0.01)."});
}

template <class P>
ParameterRow<P> alpha_units_row() {
  return enum_row<P>(
      &P::alpha_units, "AlphaUnits", "Unit of the curvature in alpha",
      "Choose ModelUnits only to repeat published figures: the effect of an alpha then depends on "
      "the size of the model.",
      {{AlphaUnits::ScaleFree, "1: most curved fifth",
        "curvature is 1 where the most curved fifth of the area begins, so that an alpha means the "
        "same at every size; open borders count as curved"},
       {AlphaUnits::ModelUnits, "as in the paper",
        "the model's own unit of length, as in the paper"}});
}

template <class P>
ParameterRow<P> curvature_kind_row() {
  return enum_row<P>(
      &P::curvature_kind, "CurvatureKind", "Kind of curvature",
      "Choose Gaussian for the metric as published; it is blind to cylinders and straight ridges.",
      {{CurvatureKind::Gaussian, "as in the paper",
        "|K| from the angles around a vertex, in 1/length&sup2;"},
       {CurvatureKind::Absolute, "also sees cylinders",
        "|k1| + |k2| of the principal curvatures, in 1/length; with ScaleFree |K| and 0.03 of its "
        "square"}});
}

template <class P>
ParameterRow<P> curvature_of_row() {
  return enum_row<P>(
      &P::curvature_of, "CurvatureOf", "Curvature of",
      "Choose Current for the metric as published; it costs time and protects less.",
      {{CurvatureOf::Input, "the input, faster",
        "the input, averaged with the neighbours; merged vertices average theirs by area"},
       {CurvatureOf::Current, "each step, as in the paper",
        "the mesh as it is after each collapse, as in the paper"}});
}

/// What repeats a paper, beside the floor.
template <class P>
ParameterRows<P> alpha_rows() {
  return {alpha_row<P>(), alpha_units_row<P>(), curvature_kind_row<P>(), curvature_of_row<P>()};
}

}  // namespace curvdecim::glue
