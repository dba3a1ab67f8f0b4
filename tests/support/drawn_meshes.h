// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "support/shape.h"

namespace curvdecim::test {

// --- a handful of faces --------------------------------------------------------------------------
Shape one_triangle();
Shape two_triangles();  ///< a unit square cut along 0-2
Shape triangle_strip(int faces);
Shape tetrahedron();
Shape octahedron();
Shape cube();                      ///< [0, 1]^3, 12 faces
Shape fan(int blades);             ///< closed around vertex 0, radius 1
Shape polygon_fan(int corners);    ///< a flat polygon, all faces at vertex 0
Shape bowtie();                    ///< two triangles that share vertex 0
Shape book(int pages, int cells);  ///< sheets that meet in one curve: vertices 0..cells along z
Shape touching_spheres();          ///< two closed parts that share vertex 0

// --- flat ----------------------------------------------------------------------------------------
Shape plane_grid(int cells);  ///< the unit square at z = 0
Shape annulus(int around, int across);
Shape grid_with_small_holes(int cells);  ///< two of three and two of four edges; 8 cells at least

// --- curved --------------------------------------------------------------------------------------
Shape icosphere(int subdivisions);  ///< radius 1, 20 * 4^subdivisions faces
Shape noisy_sphere(int subdivisions, double noise);
Shape bumpy_sphere(int subdivisions);
Shape torus(int around, int across);         ///< radii 1 and 0.4
Shape open_cylinder(int around, int along);  ///< radius 1, height 2
Shape capped_cylinder(int around, int along);
Shape rough_cone(int sides);   ///< open, its rim rough; the tip, vertex 0, is a hub
Shape double_cone(int sides);  ///< two cones on one rim; the tips are hubs
/// Double cones side by side, with rough rims: many edges of their hubs are refused.
Shape rough_cones(int sides, int count);
Shape saddle(int cells);
Shape dense_box(int cells, const Point& size);  ///< `cells` along every edge
Shape moebius_strip(int around, int across);
Shape klein_bottle(int around, int across);
Shape large_and_small_sphere();

/// How the last column (row) of a lattice meets the first one.
enum class Seam { Open, Closed, Twisted };

/// Two faces a cell; point(u, v) with u, v in 0..1. Only u may be twisted: its end meets its start
/// with v reversed.
Shape lattice(int columns, int rows, Seam seam_u, Seam seam_v,
              const std::function<Point(double, double)>& point);

}  // namespace curvdecim::test
