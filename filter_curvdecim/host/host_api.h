// SPDX-License-Identifier: GPL-3.0-or-later
// The names that differ between the hosts. CURVDECIM_HOST_API, 2020 or 2022, is the generation of
// the plugin interface and is given by the build.
#pragma once

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

#elif CURVDECIM_HOST_API == 2022

#include <common/plugins/interfaces/filter_plugin.h>

using HostFilter = FilterPlugin;

inline constexpr bool dialogs_unfold = true;

template <class Rich, class... Arguments>
Rich in_place(bool advanced, const QString& heading, const Arguments&... arguments) {
  return Rich(arguments..., advanced, heading);
}

#if __has_include(<common/parameters/rich_parameter/rich_percentage.h>)
using RichLength = RichPercentage;  // 2025
#else
using RichLength = RichAbsPerc;
#endif

#else
#error "CURVDECIM_HOST_API must be 2020 (MeshFilterInterface) or 2022 (FilterPlugin)."
#endif
