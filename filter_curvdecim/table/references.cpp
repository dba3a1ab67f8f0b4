// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/table/references.h"

namespace curvdecim::glue {

std::string bibliography(std::initializer_list<Reference> references) {
  // A line each: the dialog of MeshLab 2020.09 is too low for what it breaks itself.
  std::string html, start = "<br>See: ";
  for (const auto& [authors, source] : references) {
    html += start + authors + ", " + source + ".";
    start = "<br>";
  }
  return html;
}

}  // namespace curvdecim::glue
