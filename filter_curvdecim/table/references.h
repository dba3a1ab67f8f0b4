// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string>

namespace curvdecim::glue {

/// A paper that a filter follows.
struct Reference {
  const char *authors, *source;
};

/// The list of references in HTML.
std::string bibliography(std::initializer_list<Reference> references);

}  // namespace curvdecim::glue
