// SPDX-License-Identifier: GPL-3.0-or-later
// Which filters have a row of the parameter table, and where its value goes.
#pragma once

#include <initializer_list>
#include <type_traits>
#include <vector>

#include "filter_curvdecim/filter_parameters.h"

namespace curvdecim {

template <class Field>
using StoredAs =
    std::conditional_t<std::is_same_v<Field, bool>, bool,
                       std::conditional_t<std::is_floating_point_v<Field>, double, int>>;

/// Binds Settings.*params.*member. Stored: the alternative of Value that the parameter's kind has.
template <auto params, auto member, class Stored = void>
Binding bind(FilterId filter, MeshDefault mesh_default = MeshDefault::None) {
  using Field = std::decay_t<decltype(Settings().*params.*member)>;
  using Alternative = std::conditional_t<std::is_void_v<Stored>, StoredAs<Field>, Stored>;
  return {filter,
          [](Settings& settings, const Value& value) {
            settings.*params.*member = static_cast<Field>(std::get<Alternative>(value));
          },
          [](const Settings& settings) -> Value {
            return static_cast<Alternative>(settings.*params.*member);
          },
          mesh_default, std::nullopt};
}

template <auto member>
Binding edge_collapse(MeshDefault mesh_default = MeshDefault::None) {
  return bind<&Settings::edge_collapse, member>(FilterId::CurvatureEdgeCollapse, mesh_default);
}

template <auto member>
Binding removal(MeshDefault mesh_default = MeshDefault::None) {
  return bind<&Settings::vertex_removal, member>(FilterId::VertexRemoval, mesh_default);
}

template <auto member>
Binding sphere(MeshDefault mesh_default = MeshDefault::None) {
  return bind<&Settings::sphere, member>(FilterId::AlgebraicSphere, mesh_default);
}

template <auto member>
Binding clustering(MeshDefault mesh_default = MeshDefault::None) {
  return bind<&Settings::clustering, member>(FilterId::VertexClustering, mesh_default);
}

/// Where a parameter has another meaning than in the row's first filter.
inline Binding meaning(Binding binding, const char* help, const char* hint) {
  binding.meaning = {help, hint};
  return binding;
}

/// Every filter that collapses edges; more: other filters.
template <auto member>
std::vector<Binding> collapse(MeshDefault mesh_default = MeshDefault::None,
                              std::initializer_list<Binding> more = {}) {
  std::vector<Binding> bindings = {edge_collapse<member>(mesh_default),
                                   sphere<member>(mesh_default)};
  bindings.insert(bindings.end(), more);
  return bindings;
}

/// Every filter that decimates step by step; more: other filters.
template <auto member>
std::vector<Binding> decimation(MeshDefault mesh_default = MeshDefault::None,
                                std::initializer_list<Binding> more = {}) {
  std::vector<Binding> bindings = collapse<member>(mesh_default, {removal<member>(mesh_default)});
  bindings.insert(bindings.end(), more);
  return bindings;
}

/// Every filter that decimates; in_clusters: the member of ClusteringParams.
template <auto member, auto in_clusters>
std::vector<Binding> every_decimation(MeshDefault mesh_default = MeshDefault::None) {
  return decimation<member>(mesh_default, {clustering<in_clusters>(mesh_default)});
}

/// Every filter that weighs by curvature.
template <auto member>
std::vector<Binding> curvature() {
  return {edge_collapse<member>(),
          bind<&Settings::importance, member>(FilterId::CurvatureImportance)};
}

}  // namespace curvdecim
