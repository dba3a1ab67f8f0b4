// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/table/references.h"

namespace curvdecim::glue {

std::string bibliography(std::initializer_list<Reference> references) {
  // The dialog of MeshLab 2020.09 does not scroll and would be too high for a screen: a line each.
  std::string html, start = "<br><nobr>See: ";
  for (const auto& [authors, title, source] : references) {
    html += start + "<i>" + authors + "</i> <b>\"" + title + "\"</b> " + source + ".</nobr>";
    start = "<br><nobr>";
  }
  return html;
}

}  // namespace curvdecim::glue
