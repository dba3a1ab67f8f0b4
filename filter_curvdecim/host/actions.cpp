// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_curvdecim/host/actions.h"

#include <algorithm>
#include <string>
#include <type_traits>

#include "filter_curvdecim/filters/all_filters.h"
#include "filter_curvdecim/host/input_layer.h"
#include "filter_curvdecim/host/rich_parameters.h"
#include "filter_curvdecim/table/flat_dialogs.h"
#include "vcg_ext/errors.h"

namespace curvdecim::glue {
namespace {

constexpr int quality_and_color = MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR;

/// The selection counters of the host's mesh are not kept up to date by vcglib.
template <class Elements>
int count_selected(const Elements& elements) {
  return static_cast<int>(std::count_if(elements.begin(), elements.end(), [](const auto& element) {
    return !element.IsD() && element.IsS();
  }));
}

MeshFacts facts_of(const MeshDocument& document) {
  MeshFacts facts;
  const auto layers = layers_of(document);
  if (!layers.empty()) {
    facts.first_layer = static_cast<int>(layers.front()->id());
    facts.second_layer = static_cast<int>(layers[layers.size() > 1]->id());
  }
  if (const MeshModel* mesh = document.mm()) {
    const CMeshO& cm = mesh->cm;
    facts.faces = cm.fn, facts.selected_faces = count_selected(cm.face);
    if (!cm.bbox.IsNull()) facts.diagonal = static_cast<double>(cm.bbox.Diag());
  }
  return facts;
}

[[noreturn]] void refuse_layer(const std::string& field, int number) {
  throw InputError(field + " is " + std::to_string(number) + "; it must be " + layer_unit +
                       ". No mesh was changed.",
                   {field});
}

MeshModel& layer_of(MeshDocument& document, const std::string& field, int number) {
  for (MeshModel* layer : layers_of(document))
    if (static_cast<int>(layer->id()) == number) return *layer;
  refuse_layer(field, number);
}

/// The layers that parameters name, each another one; without such parameters, the current one.
std::vector<MeshModel*> meshes_of(const std::vector<Parameter>& parameters,
                                  const std::vector<Value>& values, MeshDocument& document) {
  std::vector<MeshModel*> meshes;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].kind != Kind::Layer) continue;
    MeshModel& layer = layer_of(document, parameters[i].field, std::get<int>(values[i]));
    if (std::find(meshes.begin(), meshes.end(), &layer) != meshes.end())
      throw InputError(layers_of(document).size() == 1
                           ? "There is only one layer. Load the original and the simplified mesh "
                             "as two layers."
                           : parameters[i].field +
                                 " is a layer that is chosen already. Choose "
                                 "two different layers.",
                       {parameters[i].field});
    meshes.push_back(&layer);
  }
  if (meshes.empty()) meshes.push_back(document.mm());
  return meshes;
}

Progress progress_of(vcg::CallBackPos* callback) {
  if (!callback) return {};
  return [callback](int percent, const char* stage) { return callback(percent, stage); };
}

bool has_polygons(const CMeshO& mesh) {
  return std::any_of(mesh.face.begin(), mesh.face.end(),
                     [](const auto& face) { return face.IsAnyF(); });
}

/// Brings up to date what the host keeps about a mesh beside the mesh.
void refresh(MeshModel& mesh, const Changes& changed) {
  if (changed.shape) {
    mesh.clearDataMask(MeshModel::MM_FACEFACETOPO | MeshModel::MM_VERTFACETOPO);
    if (mesh.hasDataMask(MeshModel::MM_POLYGONAL) && !has_polygons(mesh.cm))
      mesh.clearDataMask(MeshModel::MM_POLYGONAL);
    mesh.cm.sfn = count_selected(mesh.cm.face);
    mesh.cm.svn = count_selected(mesh.cm.vert);
  }
  if (changed.quality_and_color) mesh.updateDataMask(quality_and_color);
}

std::vector<Action> all_actions() {
  std::vector<Action> all;
  for (const auto& filter : AllFilters::filters<CMeshO>()) {
    if (dialogs_unfold) {
      all.push_back({filter, filter.parameters});
      continue;
    }
    for (const FlatDialog& dialog : flat_dialogs(filter)) {
      all.push_back({filter, dialog.parameters});
      all.back().about.menu_name = dialog.menu_name;
      all.back().about.python_name = dialog.python_name;
    }
  }
  return all;
}

/// Only PyMeshLab's meshes are in double precision.
std::string name_for_user(const Parameter& parameter) {
  constexpr bool is_python = std::is_same_v<CMeshO::ScalarType, double>;
  return is_python ? python_name(parameter) : name_in_dialog(parameter);
}

}  // namespace

const std::vector<Action>& actions() {
  static const std::vector<Action> all = all_actions();
  return all;
}

const Action& action_of(int number) {
  if (number < 0 || number >= static_cast<int>(actions().size()))
    throw InputError("This plugin has no filter number " + std::to_string(number) + ".");
  return actions()[number];
}

HostFilter::FilterClass menu_class(const Action& action) {
  switch (action.about.category) {
    case Category::Remeshing: return HostFilter::Remeshing;
    case Category::QualityMeasure:
      return HostFilter::FilterClass(HostFilter::Quality | HostFilter::VertexColoring);
  }
  return HostFilter::Generic;
}

int postcondition(const Action& action) {
  int mask = MeshModel::MM_NONE;
  if (action.about.may_change.shape) mask |= MeshModel::MM_GEOMETRY_AND_TOPOLOGY_CHANGE;
  if (action.about.may_change.quality_and_color) mask |= quality_and_color;
  return mask;
}

bool names_its_layers(const Action& action) {
  return std::any_of(action.parameters.begin(), action.parameters.end(),
                     [](const Parameter& each) { return each.kind == Kind::Layer; });
}

RichParameterList default_parameters(const Action& action, const MeshDocument& document) {
  return rich_parameters(action.offered, facts_of(document), document);
}

Outcome apply(const Action& action, MeshDocument& document, const RichParameterList& parameters,
              vcg::CallBackPos* callback) {
  if (!document.mm()) throw InputError("There is no current mesh; load a triangle mesh first.");
  const auto values = read_values(action.parameters, parameters, facts_of(document));
  try {
    const std::vector<MeshModel*> meshes = meshes_of(action.parameters, values, document);
    const InputLayer input(action.parameters, values, *meshes.front());
    std::vector<CMeshO*> surfaces;
    surfaces.reserve(meshes.size());
    for (MeshModel* mesh : meshes) surfaces.push_back(&mesh->cm);
    const Outcome outcome = action.run(surfaces, values, progress_of(callback));
    for (MeshModel* mesh : meshes) refresh(*mesh, outcome.changed);
    input.add_to(document, *meshes.front());
    return outcome;
  } catch (const InputError& error) {
    throw in_names_of(action.parameters, error, name_for_user);
  }
}

}  // namespace curvdecim::glue
