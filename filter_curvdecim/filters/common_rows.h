// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters that several filters have.
#pragma once

#include <optional>
#include <string>

#include "filter_curvdecim/table/joined.h"
#include "filter_curvdecim/table/parameter_row.h"
#include "vcg_ext/params.h"

namespace curvdecim::glue {

inline Value half_of_the_faces(const MeshFacts& mesh) {
  return (mesh.selected_faces > 0 ? mesh.selected_faces : mesh.faces) / 2;
}

inline Value are_faces_selected(const MeshFacts& mesh) { return mesh.selected_faces > 0; }

template <class P>
ParameterRow<P> target_faces_row(
    const ParameterText& text =
        {"Stop at this many faces; with <i>Simplify only selected faces</i>, at this many selected "
         "faces. A last step removes two faces at once, so the result may have one face less. 0: "
         "as few as the other parameters allow, for example up to <i>Maximum error</i>.",
         "Stop at this many faces (selected faces, if only those may change)."},
    const std::optional<MeshDefault>& mesh_default = MeshDefault{
        half_of_the_faces, "half of the faces, or of the selected ones if there are any"}) {
  return row<P>(&P::target_faces, "TargetFaceNum", "Target number of faces", text, mesh_default);
}

template <class P>
ParameterRow<P> target_fraction_row() {
  return row<P>(
      &P::target_fraction, "TargetPerc", "Fraction of the faces (0..1)",
      {"0.2 keeps a fifth of the faces, of the selected ones with <i>Simplify only selected "
       "faces</i>. 0: not used; otherwise it wins over <i>Target number of faces</i>.",
       "0.2 keeps a fifth and wins over the number. 0: not used."});
}

template <class P>
ParameterRow<P> target_vertices_row() {
  return row<P>(
      &P::target_vertices, "TargetVertNum", "Target number of vertices",
      {"Stop at this many vertices of the whole mesh. 0: not used; otherwise it wins over "
       "<i>Target number of faces</i>.",
       "Wins over the number of faces. 0: not used."});
}

template <class P>
ParameterRow<P> max_error_row() {
  return row<P>(
      &P::max_error, "MaxError", "Maximum error",
      {"No point of the result is further from the original surface than this, and no point of the "
       "original further from the result. Given as a length or as per cent of the bounding box's "
       "diagonal. Together with a target, whichever comes first stops. 0: no bound.",
       "No point of either surface is further from the other. 0: no bound."});
}

template <class P>
ParameterRow<P> max_error_one_sided_row() {
  return row<P>(
      &P::max_error_one_sided, "MaxErrorOneSided", "Maximum error on one side only",
      {"<i>Maximum error</i> counts from the result to the original only: what is left is near the "
       "original, but parts of the original, a corner or the rim of a border, may be further from "
       "what is left.",
       "From the result to the original, not back."});
}

/// The targets of a decimation step by step.
template <class P>
ParameterRows<P> target_rows() {
  return {for_all(target_faces_row<P>()), also_for_assemblies(target_fraction_row<P>()),
          tuning(target_vertices_row<P>()), also_for_assemblies(max_error_row<P>())};
}

/// The same for collapses.
template <class P>
ParameterRows<P> collapse_target_rows() {
  return joined<ParameterRow<P>>({target_rows<P>(), {assemblies(max_error_one_sided_row<P>())}});
}

template <class P>
ParameterRow<P> refine_sweeps_row(const std::string& label, const ParameterText& text) {
  return row<P>(&P::refine_sweeps, "RefineSweeps", label, text);
}

template <class P>
ParameterRow<P> preserve_boundary_row(
    const ParameterText& text = {
        "Vertices of open borders stay on the border's curve, and the error along it counts. "
        "Switch off to let borders shrink.",
        "Open borders stay on their curve."}) {
  return row<P>(&P::preserve_boundary, "PreserveBoundary", "Preserve boundary of the mesh", text);
}

template <class P>
ParameterRow<P> boundary_weight_row(
    const ParameterText& text = {
        "Weight of borders and sharp edges against the surface, 1 counting both alike. Raise it to "
        "keep more vertices on them.",
        "Of borders and sharp edges; more keeps more vertices on them."}) {
  return row<P>(&P::boundary_weight, "BoundaryWeight", "Boundary preserving weight", text);
}

template <class P>
ParameterRow<P> preserve_normal_row(
    const ParameterText& text = {
        "Refuse a step that turns a face by more than <i>Largest turn of a face</i>. Switch off "
        "only when folded faces do not matter.",
        "Up to <i>Largest turn of a face</i>."}) {
  return row<P>(&P::preserve_normal, "PreserveNormal", "Preserve normal", text);
}

template <class P>
ParameterRow<P> normal_angle_row(
    const ParameterText& text = {
        "Used with <i>Preserve normal</i>. Less keeps the orientation of faces closer and may stop "
        "before the target; above 90 faces may flip.",
        "Less may stop before the target; above 90 faces may flip."}) {
  return row<P>(&P::normal_angle, "NormalAngle", "Largest turn of a face (degrees)", text);
}

template <class P>
ParameterRow<P> preserve_topology_row() {
  return row<P>(
      &P::preserve_topology, "PreserveTopology", "Preserve topology",
      {"Keep every part, hole and handle. Off, those smaller than the error reached may go, so "
       "that "
       "every target is met and a manifold stays one. <i>Maximum error</i> keeps them always.",
       "Keep parts, holes and handles."});
}

template <class P>
ParameterRow<P> join_borders_row() {
  return row<P>(
      &P::join_borders, "JoinBorders", "Join borders that coincide",
      {"Neighbours that share no vertex, as in files that list every face by itself, become one "
       "surface where border edges lie on each other exactly. Vertices that differ in colour or "
       "texture come out as copies in one place. Off: such seams count as borders.",
       "Close what shares no vertex."});
}

template <class P>
ParameterRow<P> attribute_weight_row() {
  return row<P>(
      &P::attribute_weight, "AttributeWeight", "Weight of texture and colours",
      {"How much it counts that a texture drifts over the surface, or that colours of vertices are "
       "off, against the error of the surface itself. More keeps the image in place and the shape "
       "less well. 0: they are carried, but do not count; seams are kept in any case.",
       "Of their errors, against that of the surface."});
}

template <class P>
ParameterRow<P> keep_borders_of_row() {
  return enum_row<P>(
      &P::keep_borders_of, "KeepBordersOf", "Keep borders of",
      "The borders between groups of faces stay lines of the mesh, as the seams of a texture do. "
      "They cost faces: a mesh of many small groups keeps less of its shape.",
      {{KeepBordersOf::Nothing, "only of textures",
        "only of textures, whose pages and seams are always kept"},
       {KeepBordersOf::FaceColor, "materials",
        "faces of one colour: hosts show the colour of a material as that of its faces"},
       {KeepBordersOf::FaceQuality, "segments", "faces of one quality"},
       {KeepBordersOf::FaceAttributes, "labels",
        "faces that are the same in every custom attribute of numbers or points"}});
}

template <class P>
ParameterRow<P> prevent_intersections_row() {
  return row<P>(
      &P::prevent_intersections, "PreventIntersections", "Prevent intersections",
      {"No face crosses or touches another that it did not before, so that parts with a narrow gap "
       "between them, and shells inside each other, stay apart. Faces that cross already stay "
       "about "
       "as small as they are, and the result may have more faces than the target. The log says how "
       "many cross.",
       "Faces that do not cross will not; may stop above the target."});
}

template <class P>
ParameterRow<P> keep_map_row() {
  return row<P>(
      &P::keep_map, "KeepMap", "Map to the original vertices",
      {"Leaves, as the custom attribute nearest_input_vertex of each vertex, the number of the "
       "nearest vertex of the original, and a layer of the original's vertices, whose custom "
       "attribute result_vertex is the number of the vertex that each went into, -1 where none "
       "is left. With these skin weights and measurements can be carried over.",
       "As custom attributes, and a layer of the original vertices."});
}

/// What an edge collapse refuses to do, or does only where all else costs more, and what it joins
/// before.
template <class P>
ParameterRows<P> collapse_guard_rows() {
  return {
      also_for_assemblies(preserve_boundary_row<P>()),
      tuning(boundary_weight_row<P>()),
      tuning(preserve_normal_row<P>(
          {"A step that turns a face by more than <i>Largest turn of a face</i> costs by the "
           "face's size, so that only slivers turn, and none may fold back onto its neighbour. "
           "Switch off only when folded faces do not matter.",
           "Beyond <i>Largest turn of a face</i> only slivers turn."})),
      tuning(normal_angle_row<P>(
          {"Used with <i>Preserve normal</i>. Less keeps the orientation of faces closer; above "
           "90 faces may flip.",
           "Less keeps faces closer; above 90 they may flip."})),
      also_for_assemblies(preserve_topology_row<P>()),
      also_for_assemblies(tuning(join_borders_row<P>())),
      also_for_assemblies(paper(attribute_weight_row<P>())),
      also_for_assemblies(tuning(keep_borders_of_row<P>())),
      assemblies(prevent_intersections_row<P>())};
}

template <class P>
ParameterRow<P> feature_angle_row(
    const ParameterText& text = {
        "An edge between faces whose normals differ by at least this is sharp, and is kept like a "
        "border. 180: no edge is.",
        "Edges with at least this angle are kept. 180: none."}) {
  return row<P>(&P::feature_angle, "FeatureAngle", "Feature angle (degrees)", text);
}

template <class P>
ParameterRow<P> selected_row() {
  return row<P>(
      &P::selected_only, "Selected", "Simplify only selected faces",
      {"The rest of the mesh stays as it is, to the bit. The targets then count selected faces.",
       "Targets count selected faces."},
      MeshDefault{are_faces_selected, "true if faces are selected"});
}

template <class P>
ParameterRow<P> quality_weight_row(
    const ParameterText& text = {
        "The quality of the vertices multiplies the cost: paint or compute a high quality on what "
        "matters.",
        "Vertex quality multiplies the cost."}) {
  return row<P>(&P::quality_weight, "QualityWeight", "Weighted simplification", text);
}

template <class P>
ParameterRow<P> threads_row() {
  return row<P>(&P::threads, "Threads", "Number of threads (0: all cores)",
                {"0: all cores. It never changes the result.", "It never changes the result."});
}

/// What every edge collapse asks beside its targets and its own parameters.
template <class P>
ParameterRows<P> common_rows() {
  return {also_for_assemblies(selected_row<P>()), tuning(quality_weight_row<P>()),
          paper(keep_map_row<P>()), tuning(threads_row<P>())};
}

/// What an edge collapse is to keep, under a heading of its own.
template <class P>
ParameterRows<P> keep_rows() {
  return under<P>("Keep",
                  joined<ParameterRow<P>>({collapse_guard_rows<P>(),
                                           {also_for_assemblies(tuning(feature_angle_row<P>()))}}));
}

}  // namespace curvdecim::glue
