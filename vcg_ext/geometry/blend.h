// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace curvdecim::detail {

inline bool is_finite(double value) { return std::isfinite(value); }
template <class Vector>
bool is_finite(const Vector& value) {
  return value.allFinite();
}

/// The weighted mean of some values of a vector space over double. One that is not finite does not
/// spread: the others stand in for it.
template <class Value>
class Blend {
 public:
  /// otherwise: the mean where no value counts.
  explicit Blend(const Value& otherwise) : sum_(otherwise) {}

  void add(double weight, const Value& value) {
    if (weight == 0.0 || !is_finite(value)) return;
    sum_ = weights_ == 0.0 ? Value(weight * value) : Value(sum_ + weight * value);
    weights_ += weight;
  }

  Value mean() const { return weights_ == 0.0 || weights_ == 1.0 ? sum_ : Value(sum_ / weights_); }

 private:
  Value sum_;
  double weights_ = 0.0;
};

/// What no mean is of: the name of a thing, a mark, a number that counts something.
template <class T>
struct Label {
  T value{};
  bool operator==(const Label& o) const { return value == o.value; }
};

/// The label of the largest weight, the first of several.
template <class T>
class Blend<Label<T>> {
 public:
  explicit Blend(const Label<T>& otherwise) : heaviest_(otherwise) {}

  void add(double weight, const Label<T>& value) {
    if (weight > weight_) weight_ = weight, heaviest_ = value;
  }

  Label<T> mean() const { return heaviest_; }

 private:
  Label<T> heaviest_;
  double weight_ = 0.0;
};

}  // namespace curvdecim::detail
