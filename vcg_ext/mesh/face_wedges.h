// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vcg_ext/mesh/wedge_texture.h"

namespace curvdecim {

/// The wedge texture coordinates of a vcg face.
template <class FaceType>
FaceWedges wedges_of(const FaceType& face) {
  FaceWedges wedges;
  for (int i = 0; i < 3; ++i) {
    const auto& texture = face.cWT(i);
    wedges[i] = {double(texture.u()), double(texture.v()), texture.n()};
  }
  return wedges;
}

/// The face keeps its texture page.
template <class FaceType>
void write_wedges(FaceType& face, const FaceWedges& wedges) {
  for (int i = 0; i < 3; ++i) {
    auto& texture = face.WT(i);
    texture.u() = static_cast<decltype(texture.u() + 0)>(wedges[i].u);
    texture.v() = static_cast<decltype(texture.v() + 0)>(wedges[i].v);
  }
}

}  // namespace curvdecim
