// SPDX-License-Identifier: GPL-3.0-or-later
// What a filter is. Its file in filters/ has a struct with these static members:
//   Params                       what it takes; Params::fields() lists it, as in vcg_ext/params.h
//   Report                       what a run tells; it has a member `notes`
//   about()                      names and texts
//   parameters()                 a row for each parameter, in the order of the dialog
//   results()                    a row for each result, in the order of the log
//   run(mesh, params, progress)  returns the report; throws InputError before the mesh is touched.
//                                With two parameters that are a Layer: run(mesh, other, ...)
//   changed(report)              what the run changed
//   headline(report)             the same in a sentence; empty: nothing
// Here it becomes a Filter, which looks like any other.
#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include "filter_curvdecim/table/parameter_row.h"
#include "filter_curvdecim/table/result.h"
#include "vcg_ext/report.h"

namespace curvdecim::glue {

/// The submenu of a host's Filters menu.
enum class Category { Remeshing, QualityMeasure };

struct About {
  std::string menu_name;
  std::string python_name;
  Category category;
  Changes may_change;
  std::string info;  ///< HTML, as hosts show it above the parameters: low dialogs have little room
  std::string details;                            ///< HTML, for the documentation, after the info
  std::vector<std::string> fields_not_offered{};  ///< members of Params that have no row
};

/// All about a filter but its run.
struct FilterTable {
  About about;
  std::vector<Parameter> parameters;  ///< in the order of the dialog
  std::vector<ResultText> results;    ///< in the order of the log
};

/// A filter for hosts with meshes of this type.
template <class MeshType>
struct Filter : FilterTable {
  /// meshes: those of the parameters that are a Layer, or the one that is to change. values: one
  /// for each parameter, in their order. Throws InputError in the core's names; the meshes are then
  /// as they were.
  Outcome (*run)(const std::vector<MeshType*>& meshes, const std::vector<Value>& values,
                 const Progress& progress);
};

template <class F>
FilterTable table_of() {
  const auto parameters = F::parameters();
  const auto results = F::results();
  return {F::about(), {parameters.begin(), parameters.end()}, {results.begin(), results.end()}};
}

template <class Params>
Params with_values(const ParameterRows<Params>& rows, const std::vector<Value>& values) {
  Params params;
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].assign(params, values[i]);
  return params;
}

template <class F, class MeshType>
typename F::Report report_of(const std::vector<MeshType*>& meshes, const typename F::Params& params,
                             const Progress& progress) {
  using OnTwo =
      typename F::Report(MeshType&, MeshType&, const typename F::Params&, const Progress&);
  if constexpr (std::is_same_v<decltype(F::template run<MeshType>), OnTwo>)
    return F::run(*meshes.at(0), *meshes.at(1), params, progress);
  else
    return F::run(*meshes.at(0), params, progress);
}

template <class F, class MeshType>
Outcome run_filter(const std::vector<MeshType*>& meshes, const std::vector<Value>& values,
                   const Progress& progress) {
  const auto rows = F::parameters();
  const typename F::Params params = with_values(rows, values);
  const auto report = report_of<F>(meshes, params, progress);
  return {F::headline(report), report.notes, results_of(F::results(), report, params),
          F::changed(report)};
}

template <class... F>
struct FilterList {
  static std::vector<FilterTable> tables() { return {table_of<F>()...}; }

  template <class MeshType>
  static std::vector<Filter<MeshType>> filters() {
    return {{table_of<F>(), run_filter<F, MeshType>}...};
  }
};

}  // namespace curvdecim::glue
