// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/edge_collapse.h"

#include <exception>
#include <iostream>

#include "bumpy_grid.h"

int main() try {
  Mesh mesh;
  make_bumpy_grid(mesh, 32);

  curvdecim::EdgeCollapseParams params;
  params.target_faces = 500;
  const curvdecim::DecimationReport report = curvdecim::decimate_edge_collapse(mesh, params);

  std::cout << report.faces_before << " faces became " << report.faces << " faces\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
