// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "vcg_ext/collapse/near_points.h"
#include "vcg_ext/errors.h"
#include "vcg_ext/mesh/triangle_connectivity.h"
#include "vcg_ext/mesh/working_mesh.h"
#include "vcg_ext/parallel/parallel.h"

namespace curvdecim::detail {

/// The valid pairs that are no edges @cite garland1997: vertices that were close to each other in
/// the input. A vertex that others merged into has all their partners.
class VertexPairs {
 public:
  /// No pairs.
  VertexPairs() = default;

  /// The pairs of vertices closer than the distance, in the unit of the mesh; locked ones have
  /// none. Throws InputError where there are too many, and CancelRequest.
  VertexPairs(const WorkingMesh& mesh, double distance, const Parallel& parallel)
      : partners_(mesh.position.size()) {
    const std::size_t most = most_a_vertex * mesh.position.size();
    std::size_t pairs = 0;
    NearPoints(mesh.position, free_vertices(mesh), distance, parallel)
        .for_each_pair([&](int a, int b) {
          if (mesh.connectivity.has_edge(a, b)) return;
          if (pairs++ % pairs_per_progress == 0) parallel.progress().ask();
          if (pairs > most) refuse();
          partners_[a].push_back(b), partners_[b].push_back(a);
        });
    for (std::vector<int>& partners : partners_) std::sort(partners.begin(), partners.end());
  }

  /// Whether pairs were asked for.
  bool active() const { return !partners_.empty(); }

  /// Ascending; valid until the next merge.
  IndexRange of(int v) const {
    if (!active()) return {nullptr, nullptr};
    return {partners_[v].data(), partners_[v].data() + partners_[v].size()};
  }

  bool contains(int a, int b) const {
    const IndexRange partners = of(a);
    return std::binary_search(partners.begin(), partners.end(), b);
  }

  /// To be told that `gone` went into `keep`.
  void merge(int keep, int gone) {
    for (int v : partners_[gone]) {
      erase(v, gone);
      if (v != keep) insert(v, keep), insert(keep, v);
    }
    partners_[gone].clear();
  }

  /// v has no partners any more.
  void forget(int v) {
    for (int u : partners_[v]) erase(u, v);
    partners_[v].clear();
  }

 private:
  /// As many as an even mesh has where the distance is six edges. More would take more memory than
  /// all else, and join what is not near.
  static constexpr std::size_t most_a_vertex = 64;
  static constexpr std::size_t pairs_per_progress = 4096;  // about a millisecond

  [[noreturn]] static void refuse() {
    throw InputError(
        "pair_distance is so large that there are more than 64 pairs a vertex. Give a smaller one, "
        "such as the width of the gaps to close.",
        {"pair_distance"});
  }

  static std::vector<int> free_vertices(const WorkingMesh& mesh) {
    std::vector<int> free;
    for (int v = 0; v < mesh.connectivity.vertex_slots(); ++v)
      if (!mesh.locked[v]) free.push_back(v);
    return free;
  }

  void insert(int v, int partner) {
    std::vector<int>& partners = partners_[v];
    const auto place = std::lower_bound(partners.begin(), partners.end(), partner);
    if (place == partners.end() || *place != partner) partners.insert(place, partner);
  }

  void erase(int v, int partner) {
    std::vector<int>& partners = partners_[v];
    partners.erase(std::lower_bound(partners.begin(), partners.end(), partner));
  }

  std::vector<std::vector<int>> partners_;  // by vertex, ascending
};

}  // namespace curvdecim::detail
