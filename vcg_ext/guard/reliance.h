// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

namespace curvdecim::detail {

/// Which faces of the mesh each face of the input relies on: all of its points are near these.
class Reliance {
 public:
  /// Nothing relies on anything. Counts of faces: of the input, and of the mesh.
  void reset(int input, int mesh) { on_.assign(input, {}), by_.assign(mesh, {}); }

  /// Faces of the mesh that an input face relies on.
  const std::vector<int>& of_input(int r) const { return on_[r]; }

  /// Faces of the input that rely on a face.
  const std::vector<int>& of_face(int f) const { return by_[f]; }

  void add(int r, int f) { on_[r].push_back(f), by_[f].push_back(r); }

  /// What relied on faces that change relies on nothing any more. input: all of that.
  void drop(const std::vector<int>& changed, const std::vector<int>& input) {
    for (int f : changed) by_[f].clear();
    for (int r : input) {
      for (int f : on_[r])
        if (const auto at = std::find(by_[f].begin(), by_[f].end(), r); at != by_[f].end())
          by_[f].erase(at);
      on_[r].clear();
    }
  }

 private:
  std::vector<std::vector<int>> on_, by_;
};

}  // namespace curvdecim::detail
