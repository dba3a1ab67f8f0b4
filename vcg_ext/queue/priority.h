// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <cstdint>
#include <cstring>
#include <limits>

namespace curvdecim::detail {

/// Cheapest first; among the equally cheap, as on a plane, the shortest, so that a flat place is
/// thinned evenly and no vertex swallows all others. Both in single precision, as one number that
/// compares as they do: the bits of floats that are not negative ascend with their value.
class Priority {
 public:
  /// No edge: after all others.
  Priority() = default;

  /// cost, length2 >= 0; length2: squared length, in the box of diagonal 1.
  Priority(double cost, double length2) : bits_(bits_of(cost) << 32 | bits_of(length2)) {
    assert(!(cost < 0.0) && !(length2 < 0.0));
  }

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

}  // namespace curvdecim::detail
