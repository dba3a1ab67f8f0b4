// SPDX-License-Identifier: GPL-3.0-or-later
// The attributes that a user gave a vcg mesh, which are known by their type at run time only.
#pragma once

#include <vcg/complex/complex.h>

#include <Eigen/Core>
#include <algorithm>
#include <cstring>
#include <string>
#include <tuple>
#include <typeindex>
#include <typeinfo>

#include "vcg_ext/geometry/blend.h"

namespace curvdecim::detail {

/// How a value of this type is blended: a number as a double, a point by its coordinates; a whole
/// number or a truth value is a label.
template <class T>
struct CustomValue {
  using Blended = Label<T>;
  static Blended read(const T& value) { return {value}; }
  static T write(const Blended& value) { return value.value; }
};

template <class Scalar>
struct CustomNumber {
  using Blended = double;
  static Blended read(const Scalar& value) { return static_cast<double>(value); }
  static Scalar write(const Blended& value) { return static_cast<Scalar>(value); }
};
template <>
struct CustomValue<float> : CustomNumber<float> {};
template <>
struct CustomValue<double> : CustomNumber<double> {};

template <class Point, int Size>
struct CustomPoint {
  using Blended = Eigen::Matrix<double, Size, 1>;
  static Blended read(const Point& value) {
    Blended blended;
    for (int k = 0; k < Size; ++k) blended[k] = static_cast<double>(value[k]);
    return blended;
  }
  static Point write(const Blended& blended) {
    Point value;
    for (int k = 0; k < Size; ++k) value[k] = static_cast<decltype(value[k] + 0)>(blended[k]);
    return value;
  }
};
template <class Scalar>
struct CustomValue<vcg::Point2<Scalar>> : CustomPoint<vcg::Point2<Scalar>, 2> {};
template <class Scalar>
struct CustomValue<vcg::Point3<Scalar>> : CustomPoint<vcg::Point3<Scalar>, 3> {};
template <class Scalar>
struct CustomValue<vcg::Point4<Scalar>> : CustomPoint<vcg::Point4<Scalar>, 4> {};

using CustomTypes =
    std::tuple<float, double, vcg::Point2f, vcg::Point2d, vcg::Point3f, vcg::Point3d, vcg::Point4f,
               vcg::Point4d, bool, char, signed char, unsigned char, short, unsigned short, int,
               unsigned int, long, unsigned long, long long, unsigned long long>;

/// use(T()) with the type of the attribute's values. Returns whether it is one of those above.
template <class Attribute, class Use>
bool with_type_of(const Attribute& attribute, Use use) {
  return std::apply(
      [&](auto... of_type) {
        return ((attribute._type == std::type_index(typeid(of_type)) && (use(of_type), true)) ||
                ...);
      },
      CustomTypes());
}

/// use(read, write) for each of the attributes: read(i) gives the value of element i to be blended,
/// write(i, value) puts one back. Those of other types are left out.
template <class Attributes, class Use>
void for_each_custom(const Attributes& attributes, Use use) {
  for (const auto& attribute : attributes)
    with_type_of(attribute, [&](auto of_type) {
      using T = decltype(of_type);
      auto* values = attribute._handle;
      use([values](int i) { return CustomValue<T>::read(*static_cast<const T*>(values->At(i))); },
          [values](int i, const typename CustomValue<T>::Blended& value) {
            *static_cast<T*>(values->At(i)) = CustomValue<T>::write(value);
          });
    });
}

/// The names of those whose type is none of the above, in quotes; empty: there are none.
template <class Attributes>
std::string names_of_unknown(const Attributes& attributes) {
  std::string names;
  for (const auto& attribute : attributes)
    if (!with_type_of(attribute, [](auto) {}))
      names += (names.empty() ? "'" : ", '") + attribute._name + "'";
  return names;
}

/// Whether two elements have the same bits in an attribute.
template <class Attribute>
bool has_same_bits(const Attribute& attribute, std::size_t i, std::size_t j) {
  const auto* values = attribute._handle;
  return std::memcmp(values->At(i), values->At(j), values->SizeOf()) == 0;
}

/// Whether two elements have the same values in all attributes of the above types.
template <class Attributes>
bool are_same_in_known(const Attributes& attributes, std::size_t i, std::size_t j) {
  return std::all_of(attributes.begin(), attributes.end(), [&](const auto& attribute) {
    return !with_type_of(attribute, [](auto) {}) || has_same_bits(attribute, i, j);
  });
}

/// Element `to` gets what element `from` has, of any type.
template <class Attributes>
void copy_custom(const Attributes& attributes, std::size_t to, std::size_t from) {
  for (const auto& attribute : attributes)
    attribute._handle->CopyValue(to, from, attribute._handle);
}

}  // namespace curvdecim::detail
