// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "vcg_ext/connectivity/edge_neighborhood.h"
#include "vcg_ext/connectivity/renumbering.h"

namespace curvdecim {

/// Cheapest first; among the equally cheap, as on a plane, the shortest, so that a flat place is
/// thinned evenly and no vertex swallows all others. Both in single precision, as one number that
/// compares as they do: the bits of floats that are not negative ascend with their value.
class Priority {
 public:
  /// No edge: after all others.
  Priority() = default;

  /// cost, length2 >= 0; length2: squared length, in the box of diagonal 1.
  Priority(double cost, double length2) : bits_(bits_of(cost) << 32 | bits_of(length2)) {}

  double cost() const {
    const std::uint32_t high = static_cast<std::uint32_t>(bits_ >> 32);
    float cost;
    std::memcpy(&cost, &high, sizeof cost);
    return cost;
  }

  bool operator<(Priority o) const { return bits_ < o.bits_; }
  bool operator==(Priority o) const { return bits_ == o.bits_; }

 private:
  static std::uint64_t bits_of(double value) {
    const float single = static_cast<float>(value);
    std::uint32_t bits;
    std::memcpy(&bits, &single, sizeof bits);
    return bits;
  }

  std::uint64_t bits_ = std::numeric_limits<std::uint64_t>::max();
};

/// An edge from a vertex to a neighbour of higher index.
struct EdgeChoice {
  static constexpr int none = -1;

  Priority priority;
  int partner = none;

  bool exists() const { return partner != none; }
  bool operator<(const EdgeChoice& o) const {
    return priority == o.priority ? partner < o.partner : priority < o.priority;
  }
};

/// The cheapest edge of every vertex, kept at the edge's lower vertex, as last known.
class EdgeChoices {
 public:
  explicit EdgeChoices(int vertices) : priority_(vertices), partner_(vertices, EdgeChoice::none) {}

  EdgeChoice of(int owner) const { return {priority_[owner], partner_[owner]}; }
  Priority priority(int owner) const { return priority_[owner]; }
  bool exists(int owner) const { return partner_[owner] != EdgeChoice::none; }

  void set(int owner, const EdgeChoice& choice) {
    priority_[owner] = choice.priority;
    partner_[owner] = choice.partner;
  }

  /// A partner that is gone becomes none; its owner has to choose again.
  void renumber(const Renumbering& numbers) {
    numbers.vertices(priority_), numbers.vertices(partner_);
    for (int& partner : partner_)
      if (partner != EdgeChoice::none) partner = numbers.vertex(partner);
  }

 private:
  std::vector<Priority> priority_;  // by vertex
  std::vector<int> partner_;        // by vertex
};

}  // namespace curvdecim
