// SPDX-License-Identifier: GPL-3.0-or-later
// The names that differ between the hosts. CURVDECIM_HOST_API, 2020 or 2022, is the generation of
// the plugin interface and is given by the build.
#pragma once

#include <optional>
#include <vector>

#if CURVDECIM_HOST_API == 2020

#include <common/interfaces.h>

using HostFilter = MeshFilterInterface;
using RichLength = RichAbsPerc;

/// Its dialogs show every parameter at once.
inline constexpr bool dialogs_unfold = false;

/// A parameter of the host, made of its own arguments.
template <class Rich, class... Arguments>
Rich in_place(bool /*advanced*/, const QString& /*heading*/, const Arguments&... arguments) {
  return Rich(arguments...);
}

inline std::vector<MeshModel*> layers_of(const MeshDocument& document) {
  return {document.meshList.begin(), document.meshList.end()};
}

/// What a RichMesh begins with. It is shown only in a document that has the layer.
struct RichLayer : RichMesh {
  template <class... Texts>
  RichLayer(const QString& name, int layer, const MeshDocument* document, const Texts&... texts)
      : RichMesh(name, mesh_of(document, layer), document_with(document, layer), texts...) {}

 private:
  static MeshModel* mesh_of(const MeshDocument* document, int layer) {
    for (MeshModel* mesh : layers_of(*document))
      if (mesh->id() == layer) return mesh;
    return nullptr;
  }
  static MeshDocument* document_with(const MeshDocument* document, int layer) {
    return mesh_of(document, layer) ? const_cast<MeshDocument*>(document) : nullptr;
  }
};

/// The number of the layer that a script or a dialog names; nullopt: it names none.
inline std::optional<int> layer_number(const Value& value) {
  if (value.isInt()) return value.getInt();
  if (value.isMesh() && value.getMesh()) return value.getMesh()->id();
  return std::nullopt;
}

#elif CURVDECIM_HOST_API == 2022

#include <common/plugins/interfaces/filter_plugin.h>

using HostFilter = FilterPlugin;

inline constexpr bool dialogs_unfold = true;

template <class Rich, class... Arguments>
Rich in_place(bool advanced, const QString& heading, const Arguments&... arguments) {
  return Rich(arguments..., advanced, heading);
}

using RichLayer = RichMesh;

inline std::vector<MeshModel*> layers_of(MeshDocument& document) {
  std::vector<MeshModel*> layers;
  for (MeshModel& mesh : document.meshIterator()) layers.push_back(&mesh);
  return layers;
}

inline std::vector<const MeshModel*> layers_of(const MeshDocument& document) {
  std::vector<const MeshModel*> layers;
  for (const MeshModel& mesh : document.meshIterator()) layers.push_back(&mesh);
  return layers;
}

/// The number of the layer that a script or a dialog names; nullopt: it names none.
inline std::optional<int> layer_number(const Value& value) {
  if (value.isInt()) return value.getInt();
  return std::nullopt;
}

#if __has_include(<common/parameters/rich_parameter/rich_percentage.h>)
using RichLength = RichPercentage;  // 2025
#else
using RichLength = RichAbsPerc;
#endif

#else
#error "CURVDECIM_HOST_API must be 2020 (MeshFilterInterface) or 2022 (FilterPlugin)."
#endif
