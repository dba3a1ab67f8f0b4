// SPDX-License-Identifier: GPL-3.0-or-later
// Tiny triangle soups on an integer grid, where degenerate is normal.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "support/shape.h"

namespace curvdecim::test {

/// Any random choice of the tests: the same sequence on every machine, unlike <random>'s
/// distributions.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}

  int below(int end) { return static_cast<int>(engine_() % static_cast<unsigned>(end)); }
  bool coin() { return below(2) == 1; }

  template <class Value>
  Value any(std::initializer_list<Value> values) {
    return values.begin()[below(static_cast<int>(values.size()))];
  }

 private:
  std::mt19937 engine_;
};

struct Family {
  const char* name;
  Shape (*draw)(Dice&);
};

inline void PrintTo(const Family& family, std::ostream* out) { *out << family.name; }

inline std::string family_name(const testing::TestParamInfo<Family>& info) {
  return info.param.name;
}

/// Faces between any vertices; and a sheet with some damage.
std::vector<Family> families();

}  // namespace curvdecim::test
