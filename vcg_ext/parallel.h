// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <thread>
#include <vector>

namespace curvdecim {

/// Runs independent work on several threads. Every index writes only what belongs to it, so that
/// the number of threads cannot show in the result.
class Parallel {
 public:
  /// threads: 0 for all cores.
  explicit Parallel(int threads)
      : threads_(threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))) {}

  template <class Work>
  void for_each(int count, Work work) const {
    constexpr int least_per_thread = 4096;  // below it a thread costs more than it gives
    const int parts = std::clamp(count / least_per_thread, 1, threads_);
    const auto run_part = [&](int part) {
      const auto end = static_cast<long long>(count) * (part + 1) / parts;
      for (auto i = static_cast<long long>(count) * part / parts; i < end; ++i) work(static_cast<int>(i));
    };
    std::vector<std::thread> workers;
    for (int part = 1; part < parts; ++part) workers.emplace_back(run_part, part);
    run_part(0);
    for (std::thread& worker : workers) worker.join();
  }

 private:
  int threads_;
};

}  // namespace curvdecim
