// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "vcg_ext/report.h"

namespace curvdecim {

/// How far the points of one surface are from another. Lengths as ErrorParams::relative_to says.
struct DirectionError {
  double mean = 0.0, rms = 0.0;   ///< of samples, uniform by area
  double max = 0.0;               ///< of samples, vertices and points along every edge
  double beyond_tolerance = 0.0;  ///< share of the area, 0..1
  double normal_deviation = 0.0;  ///< mean angle to the normal at the nearest point, degrees
};

/// What a surface is like by itself. Vertices of borders that lie on each other count as one, and
/// surfaces that touch as several.
struct SurfaceFigures {
  std::int64_t faces = 0, vertices = 0;  ///< as they are in the mesh
  double area = 0.0;                     ///< in the mesh's unit, squared
  double volume = 0.0;     ///< cubed; an open surface is closed by a cone to the original's middle
  std::int64_t parts = 0;  ///< pieces that hang together
  std::int64_t holes = 0;  ///< loops of edges of one face
  std::int64_t handles = 0;       ///< the genus, of all parts
  std::int64_t folded = 0;        ///< faces that turn by more than 179 degrees at an edge
  std::int64_t intersecting = 0;  ///< faces that cross another one
};

/// How much of both surfaces has which distance to the other one: bins of one width from 0 up to
/// `end`, and what is beyond it.
struct ErrorHistogram {
  static constexpr std::size_t bins = 8;

  double end = 0.0;                      ///< 0: all distances are
  std::array<double, bins + 1> share{};  ///< of the area, 0..1
};

/// How far a texture is from where it was. Lengths as ErrorParams::relative_to says.
struct TextureDriftError {
  double rms = 0.0, max = 0.0;  ///< from samples to where the original shows what is drawn there
  double lost = 0.0;  ///< share of the area that shows what the original shows nowhere, 0..1
};

/// How far a simplification is from its original. Lengths as ErrorParams::relative_to says.
struct ErrorReport {
  StopReason stopped_by = StopReason::Target;
  double rms = 0.0;               ///< root of the mean of both directions' squares
  double mean = 0.0, max = 0.0;   ///< mean of both directions; larger one of both
  double beyond_tolerance = 0.0;  ///< mean of both directions
  double normal_deviation = 0.0;  ///< mean of both directions, degrees
  DirectionError original_to_simplified, simplified_to_original;
  double rms_salient = 0.0;  ///< from the fifth of the original's area that is curved most
  std::int64_t flipped = 0;  ///< faces turned by more than 90 degrees against the original
  std::optional<TextureDriftError> texture;  ///< where both are textured
  SurfaceFigures original, simplified;
  ErrorHistogram histogram;
  double diagonal = 0.0;     ///< of the original's bounding box, in the mesh's unit
  std::int64_t samples = 0;  ///< on each surface
  double seconds = 0.0;
  std::vector<std::string> notes;
};

}  // namespace curvdecim
