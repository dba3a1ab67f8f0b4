// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/filter_curvdecim.h"

#include <algorithm>

#include "filter_curvdecim/rich_parameters.h"
#include "vcg_ext/errors.h"

namespace curvdecim {
namespace {

/// The selection counters of the host's mesh are not kept up to date by vcglib.
template <class Elements>
int count_selected(const Elements& elements) {
  return static_cast<int>(std::count_if(elements.begin(), elements.end(), [](const auto& element) {
    return !element.IsD() && element.IsS();
  }));
}

MeshFacts facts_of(const MeshModel* mesh) {
  if (!mesh) return {};
  const CMeshO& cm = mesh->cm;
  return {cm.fn, count_selected(cm.face),
          cm.bbox.IsNull() ? 0.0 : static_cast<double>(cm.bbox.Diag())};
}

Progress progress_of(vcg::CallBackPos* callback) {
  if (!callback) return {};
  return [callback](int percent, const char* stage) { return callback(percent, stage); };
}

/// Brings up to date what the host keeps about a mesh beside the mesh, if that changed.
Outcome refreshed(MeshModel& mesh, Outcome outcome) {
  if (!outcome.mesh_changed) return outcome;
  mesh.clearDataMask(MeshModel::MM_FACEFACETOPO | MeshModel::MM_VERTFACETOPO);
  mesh.cm.sfn = count_selected(mesh.cm.face);
  mesh.cm.svn = count_selected(mesh.cm.vert);
  return outcome;
}

Outcome run_removal(MeshModel& mesh, const Settings& settings, const Progress& progress) {
  const Outcome outcome =
      refreshed(mesh, decimate_by_removal(mesh.cm, settings.vertex_removal, progress));
  if (settings.vertex_removal.show_classes)
    mesh.updateDataMask(MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR);
  return outcome;
}

Outcome run_edge_collapse(MeshModel& mesh, const Settings& settings, const Progress& progress) {
  return refreshed(mesh, decimate_by_edge_collapse(mesh.cm, settings.edge_collapse, progress));
}

Outcome run_spheres(MeshModel& mesh, const Settings& settings, const Progress& progress) {
  return refreshed(mesh, decimate_by_spheres(mesh.cm, settings.sphere, progress));
}

Outcome run_clustering(MeshModel& mesh, const Settings& settings, const Progress& progress) {
  return refreshed(mesh, decimate_by_clustering(mesh.cm, settings.clustering, progress));
}

Outcome run_importance(MeshModel& mesh, const Settings& settings, const Progress& progress) {
  const Outcome outcome = show_curvature_importance(mesh.cm, settings.importance, progress);
  if (outcome.mesh_changed)
    mesh.updateDataMask(MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR);
  return outcome;
}

HostFilter::FilterClass class_of(Category category) {
  switch (category) {
    case Category::Remeshing: return HostFilter::Remeshing;
    case Category::QualityMeasure:
      return HostFilter::FilterClass(HostFilter::Quality | HostFilter::VertexColoring);
  }
  return HostFilter::Generic;
}

Filter filter(FilterId id, int precondition, int postcondition,
              Outcome (*run)(MeshModel&, const Settings&, const Progress&)) {
  return {id, class_of(text_of(id).category), precondition, postcondition, run};
}

}  // namespace

const std::vector<Filter>& filters() {
  static const std::vector<Filter> rows = {
      filter(FilterId::CurvatureEdgeCollapse, MeshModel::MM_FACENUMBER,
             MeshModel::MM_GEOMETRY_AND_TOPOLOGY_CHANGE, run_edge_collapse),
      filter(FilterId::AlgebraicSphere, MeshModel::MM_FACENUMBER,
             MeshModel::MM_GEOMETRY_AND_TOPOLOGY_CHANGE, run_spheres),
      filter(FilterId::VertexRemoval, MeshModel::MM_FACENUMBER,
             MeshModel::MM_GEOMETRY_AND_TOPOLOGY_CHANGE | MeshModel::MM_VERTQUALITY |
                 MeshModel::MM_VERTCOLOR,
             run_removal),
      filter(FilterId::VertexClustering, MeshModel::MM_FACENUMBER,
             MeshModel::MM_GEOMETRY_AND_TOPOLOGY_CHANGE, run_clustering),
      filter(FilterId::CurvatureImportance, MeshModel::MM_FACENUMBER,
             MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR, run_importance),
  };
  return rows;
}

const Filter& filter_of(int id) {
  const auto found = std::find_if(filters().begin(), filters().end(), [id](const Filter& row) {
    return static_cast<int>(row.id) == id;
  });
  if (found == filters().end())
    throw InputError("This plugin has no filter number " + std::to_string(id) + ".");
  return *found;
}

RichParameterList default_parameters(const Filter& filter, const MeshModel* mesh) {
  return rich_parameters(filter.id, facts_of(mesh));
}

Outcome apply(const Filter& filter, MeshModel* mesh, const RichParameterList& parameters,
              vcg::CallBackPos* callback) {
  if (!mesh) throw InputError("There is no current mesh; load a triangle mesh first.");
  return filter.run(*mesh, read_settings(filter.id, parameters, facts_of(mesh)),
                    progress_of(callback));
}

std::vector<std::string> log_lines(const Outcome& outcome) {
  std::vector<std::string> lines = outcome.notes;
  for (const Result& result : outcome.results) lines.push_back(log_line(result));
  return lines;
}

}  // namespace curvdecim
