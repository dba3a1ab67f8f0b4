// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#ifdef __linux__
#include <sched.h>
#endif

namespace curvdecim::detail {

/// The processor that the calling thread runs on, and a way to get off another's: a new thread may
/// be put beside the one that starts it, and some milliseconds pass until the system spreads them,
/// as long as a whole small run. Where the system does not tell, nothing is done.
class Processor {
 public:
  static Processor current() {
#ifdef __linux__
    return Processor(sched_getcpu());
#else
    return Processor(-1);
#endif
  }

  /// Moves the calling thread to another processor, if it may run on one. Later the system is free
  /// to move it anywhere again.
  void leave() const {
#ifdef __linux__
    cpu_set_t allowed;
    if (number_ < 0 || sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
    cpu_set_t others = allowed;
    CPU_CLR(number_, &others);
    if (CPU_COUNT(&others) == 0) return;
    sched_setaffinity(0, sizeof others, &others);
    sched_setaffinity(0, sizeof allowed, &allowed);
#endif
  }

 private:
  explicit Processor(int number) : number_(number) {}

  int number_;  // -1: not known
};

}  // namespace curvdecim::detail
