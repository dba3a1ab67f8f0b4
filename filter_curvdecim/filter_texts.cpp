// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/filter_texts.h"

#include <algorithm>
#include <initializer_list>

namespace curvdecim {
namespace {

struct Reference {
  const char* authors;
  const char* title;
  const char* source;
};

constexpr Reference lindstrom_turk = {"P. Lindstrom, G. Turk",
                                      "Fast and memory efficient polygonal simplification",
                                      "IEEE Visualization 1998"};
constexpr Reference pellizzoni_savio = {
    "P. Pellizzoni, G. Savio", "Mesh simplification by curvature-enhanced quadratic error metrics",
    "Journal of Computer Science 16(8), 2020"};
constexpr Reference yao = {
    "L. Yao, S. Huang, H. Xu, P. Li",
    "Quadratic error metric mesh simplification algorithm based on discrete curvature",
    "Mathematical Problems in Engineering, 2015"};
constexpr Reference rossignac_borrel = {"J. Rossignac, P. Borrel",
                                        "Multi-resolution 3D approximations for rendering",
                                        "Modeling in Computer Graphics, 1993"};
constexpr Reference lindstrom = {"P. Lindstrom", "Out-of-core simplification of large models",
                                 "SIGGRAPH 2000"};
constexpr Reference ciolczyk_janczykowski = {"M. Ciolczyk, M. Janczykowski",
                                             "Mesh simplification: vertex clustering", "slides"};

constexpr Reference schroeder = {"W. J. Schroeder, J. A. Zarge, W. E. Lorensen",
                                 "Decimation of triangle meshes", "SIGGRAPH 1992"};
constexpr Reference michaud_mellado_paulin = {"J. Michaud, N. Mellado, M. Paulin",
                                              "Mesh simplification with curvature error metric",
                                              "Eurographics posters, 2017"};
constexpr Reference guennebaud = {"G. Guennebaud, M. Germann, M. Gross",
                                  "Dynamic sampling and rendering of algebraic point set surfaces",
                                  "Computer Graphics Forum 27(2), 2008"};

/// The list of references as MeshLab asks for it: authors, title, source. The dialog of MeshLab
/// 2020.09 does not scroll and would be too high for a screen, so each takes one line.
std::string bibliography(std::initializer_list<Reference> references) {
  std::string html = "<br>See:";
  for (const Reference& reference : references)
    html += "<br><nobr><i>" + std::string(reference.authors) + "</i> <b>\"" + reference.title +
            "\"</b> " + reference.source + ".</nobr>";
  return html;
}

// One line of the highest dialog: another would push its buttons off a full HD screen.
const char* const edge_collapse_info =
    "Collapse edges by quadrics (Garland, Heckbert) and keep what is curved, borders and sharp "
    "edges. <i>Curvature Importance</i> shows what is protected.";

const char* const removal_info =
    "Remove vertices one by one, those nearest to the surface that is left first, and fill the "
    "holes with triangles. The vertices that stay are vertices of the input and keep all that they "
    "carry, to the bit. A manifold stays one. Edge collapse moves vertices and has a lower error. "
    "The log says what was done.";

const char* const sphere_info =
    "Collapse edges by how far the new faces are from spheres fitted to the original surface, and "
    "place vertices where spheres and planes are nearest: on smooth shapes less error than the "
    "preset Balanced of <i>Curvature-Enhanced Edge Collapse</i>, in about twice its time. A closed "
    "manifold stays one; borders and sharp edges are kept. The log says what was done.";

const char* const clustering_info =
    "Put a grid over the mesh and make one vertex of all in a cell: the fastest way to a coarse "
    "mesh, of any input. No vertex moves further than the size of a cell, and with <i>Simplify "
    "only "
    "selected faces</i> the rest stays. Thin parts may vanish and edges get more than two faces; "
    "edge collapse keeps both, and more of the shape. The log says what was done.";

const char* const importance_info =
    "Write to the quality of every vertex, and show as colour, what the metric CurvatureWeighted "
    "of <i>Simplification: Curvature-Enhanced Edge Collapse</i> sees with the same parameters: the "
    "curvature, or the factor by which the cost of a collapse is multiplied. Places with high "
    "values keep their faces longest. The shape of the mesh does not change.<br>"
    "Red is low and blue is high. Curvature is coloured from its 5th to its 95th percentile, "
    "because a few spikes would hide the rest; the factor always from 0 to 1, so that settings can "
    "be compared.";

}  // namespace

const std::vector<FilterText>& filter_texts() {
  static const std::vector<FilterText> texts = {
      {FilterId::CurvatureEdgeCollapse, "Simplification: Curvature-Enhanced Edge Collapse",
       "meshing_decimation_curvature_edge_collapse", Category::Remeshing,
       edge_collapse_info + bibliography({pellizzoni_savio, yao})},
      {FilterId::VertexRemoval, "Simplification: Vertex Removal (Schroeder)",
       "meshing_decimation_vertex_removal", Category::Remeshing,
       removal_info + bibliography({schroeder})},
      {FilterId::AlgebraicSphere, "Simplification: Algebraic Sphere Edge Collapse",
       "meshing_decimation_algebraic_sphere", Category::Remeshing,
       sphere_info + bibliography({michaud_mellado_paulin, guennebaud, lindstrom_turk})},
      {FilterId::VertexClustering, "Simplification: Vertex Clustering with Representatives",
       "meshing_decimation_vertex_clustering", Category::Remeshing,
       clustering_info + bibliography({rossignac_borrel, lindstrom, ciolczyk_janczykowski})},
      {FilterId::CurvatureImportance, "Curvature Importance",
       "compute_scalar_by_curvature_importance", Category::QualityMeasure,
       importance_info + bibliography({pellizzoni_savio})},
  };
  return texts;
}

const FilterText& text_of(FilterId id) {
  const std::vector<FilterText>& texts = filter_texts();
  return *std::find_if(texts.begin(), texts.end(),
                       [id](const FilterText& text) { return text.id == id; });
}

}  // namespace curvdecim
