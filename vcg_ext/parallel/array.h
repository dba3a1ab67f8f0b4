// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace curvdecim::detail {

/// Leaves new elements without a value, whatever their type says.
template <class T>
struct LeavesUnset : std::allocator<T> {
  static_assert(std::is_trivially_destructible_v<T>);

  // NOLINTBEGIN(readability-identifier-naming): the standard's names
  template <class U>
  struct rebind {
    using other = LeavesUnset<U>;
  };
  // NOLINTEND(readability-identifier-naming)

  LeavesUnset() = default;
  template <class U>
  LeavesUnset(const LeavesUnset<U>&) {}

  template <class U>
  void construct(U*) {}
  template <class U, class First, class... Rest>
  void construct(U* at, First&& first, Rest&&... rest) {
    ::new (static_cast<void*>(at)) U(std::forward<First>(first), std::forward<Rest>(rest)...);
  }
};

/// A vector for elements that all cores write right after it has got its size: resize() does not
/// touch them. A large one is new memory, which the system clears when it is touched first; one
/// core alone would take as long for that as all for the work itself.
template <class T>
using Array = std::vector<T, LeavesUnset<T>>;

}  // namespace curvdecim::detail
