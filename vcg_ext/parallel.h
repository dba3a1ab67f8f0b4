// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <thread>
#include <vector>

namespace curvdecim {

/// Runs independent work on several threads. Every index writes only what belongs to it, so that
/// the number of threads cannot show in the result.
class Parallel {
 public:
  /// threads: 0 for all cores. between_blocks: called on the calling thread while no other runs; it
  /// may throw to end the work.
  explicit Parallel(int threads, std::function<void()> between_blocks = {})
      : threads_(threads > 0 ? threads
                             : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))),
        between_blocks_(std::move(between_blocks)) {}

  /// work(i) for every i below count.
  template <class Work>
  void for_each(int count, Work work) const {
    for_ranges(count, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) work(i);
    });
  }

  /// work(begin, end) for ranges that cover 0..count, for work that needs scratch of its own.
  template <class Work>
  void for_ranges(int count, Work work) const {
    constexpr int block = 1 << 18;  // some tens of milliseconds
    for (int begin = 0; begin < count; begin += std::min(block, count - begin)) {
      if (between_blocks_) between_blocks_();
      run_block(begin, std::min(block, count - begin), work);
    }
  }

 private:
  template <class Work>
  void run_block(int first, int count, Work& work) const {
    constexpr int least_per_thread = 4096;  // below it a thread costs more than it gives
    const int parts = std::clamp(count / least_per_thread, 1, threads_);
    const auto run_part = [&](int part) {
      const auto bound = [&](long long p) { return first + static_cast<int>(p * count / parts); };
      work(bound(part), bound(part + 1));
    };
    std::vector<std::thread> workers;
    for (int part = 1; part < parts; ++part) workers.emplace_back(run_part, part);
    run_part(0);
    for (std::thread& worker : workers) worker.join();
  }

  int threads_;
  std::function<void()> between_blocks_;
};

}  // namespace curvdecim
