// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>
#include <vector>

#include "support/shape.h"

namespace curvdecim::test {

/// Facts about a mesh from its arrays alone, computed independently of the code under test.
struct Topology {
  int euler = 0;  ///< used vertices - edges + faces
  int components = 0;
  int boundary_loops = 0;  ///< connected parts of the graph of edges with one face
  int nonmanifold_edges = 0;
  int nonmanifold_vertices = 0;  ///< whose faces are not all connected by edges at the vertex
  int inconsistent_edges = 0;    ///< whose two faces run along them in the same direction
  int duplicate_faces = 0;       ///< of the same orientation as another
  int faces_with_repeated_index = 0;
  int unreferenced_vertices = 0;
};

Topology topology(const Shape& shape);
std::ostream& operator<<(std::ostream& out, const Topology& t);

/// True if all is as before, except that non-manifold curves, and the seams where a surface that
/// cannot be oriented changes its side, may have fewer edges, but not none.
bool keeps_topology(const Topology& before, const Topology& after);

bool all_finite(const Shape& shape);
double diagonal(const Shape& shape);
double area(const Shape& shape);
double volume(const Shape& shape);  ///< of a closed shape

/// Faces whose normal opposes that of the original at the point nearest to their centre; faces of
/// less than 1e-12 of the squared diagonal have no reliable normal and do not count, nor do those
/// of a component that is down to six faces: the nearest point to a face's centre may lie
/// behind it.
int flipped_faces(const Shape& original, const Shape& simplified);

/// Whether a vertex is no further than this from the point.
bool has_vertex(const Shape& shape, const Point& p, double tolerance);

/// From a point to the surface.
double distance_to(const Shape& surface, const Point& p);

/// Largest distance from the vertices and face centres of either to the other.
double two_sided_distance(const Shape& a, const Shape& b);

/// Largest distance from a lattice of points on the faces of either, corners and edges included, to
/// the other.
double sampled_distance(const Shape& a, const Shape& b);
double one_sided_sampled_distance(const Shape& from, const Shape& to);

/// The same as two_sided_distance, root of the mean square weighted by area; face centres only.
double two_sided_rms(const Shape& a, const Shape& b);

/// The smallest interior angle of any face, in degrees.
double smallest_angle(const Shape& shape);

}  // namespace curvdecim::test
