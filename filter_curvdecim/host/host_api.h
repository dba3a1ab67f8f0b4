// SPDX-License-Identifier: GPL-3.0-or-later
// The names that differ between the hosts. CURVDECIM_HOST_API, 2020 or 2022, is the generation of
// the plugin interface and is given by the build.
#pragma once

#if CURVDECIM_HOST_API == 2020

#include <common/interfaces.h>

using HostFilter = MeshFilterInterface;
using RichLength = RichAbsPerc;

#elif CURVDECIM_HOST_API == 2022

#include <common/plugins/interfaces/filter_plugin.h>

using HostFilter = FilterPlugin;

#if __has_include(<common/parameters/rich_parameter/rich_percentage.h>)
using RichLength = RichPercentage;  // 2025
#else
using RichLength = RichAbsPerc;
#endif

#else
#error "CURVDECIM_HOST_API must be 2020 (MeshFilterInterface) or 2022 (FilterPlugin)."
#endif
