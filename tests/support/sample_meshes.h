// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "support/shape.h"

namespace curvdecim::test {

/// A mesh of the repository's sample_meshes directory, .ply or .obj. Throws std::runtime_error
/// where it cannot be read.
Shape sample_mesh(const std::string& file);

/// A mesh of the directory that CURVDECIM_MESHES names, by default ../shared/meshes beside the
/// repository; nothing where it is not there.
std::optional<Shape> shared_mesh(const std::string& file);

}  // namespace curvdecim::test
