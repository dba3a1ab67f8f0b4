// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>

#include "vcg_ext/parallel/progress_meter.h"
#include "vcg_ext/parallel/thread_team.h"

namespace curvdecim::detail {

/// How work is cut up.
struct Grain {
  int least;  ///< items that are worth a thread's while
  int block;  ///< items between two looks at whether to go on: some tens of milliseconds
};

/// Runs independent work on several threads. Every index writes only what belongs to it, so that
/// the number of threads cannot show in the result. Between blocks of work the calling thread asks
/// whether to go on; CancelRequest ends the work.
class Parallel {
 public:
  static constexpr Grain light{512, 1 << 18};  ///< items of some tens of nanoseconds
  static constexpr Grain heavy{8, 1 << 13};    ///< items of some microseconds

  /// threads: 0 for all cores. progress: called on the calling thread while no other runs.
  explicit Parallel(int threads, Progress progress = {})
      : team_(std::make_unique<ThreadTeam>(
            threads > 0 ? threads
                        : std::max(1, static_cast<int>(std::thread::hardware_concurrency())))),
        progress_(std::make_unique<ProgressMeter>(std::move(progress))) {}

  int threads() const { return team_->size(); }

  /// How far the run is that this works for.
  ProgressMeter& progress() const { return *progress_; }

  /// work(i) for every i below count.
  template <class Work>
  void for_each(int count, Work work, Grain grain = light) const {
    for_ranges(
        count,
        [&](int begin, int end, int) {
          for (int i = begin; i < end; ++i) work(i);
        },
        grain);
  }

  /// work(begin, end, worker) for ranges that cover 0..count; worker, below threads(), tells apart
  /// what runs at the same time, for work that needs scratch of its own.
  template <class Work>
  void for_ranges(int count, Work work, Grain grain = light) const {
    for (int begin = 0; begin < count; begin += std::min(grain.block, count - begin)) {
      progress_->in_loop(static_cast<double>(begin) / count);
      run_block(begin, std::min(grain.block, count - begin), work, grain.least);
    }
  }

  /// work(i) for every i below count, in this order, on the calling thread.
  template <class Work>
  void in_order(int count, Work work, Grain grain = light) const {
    for (int begin = 0; begin < count; begin += std::min(grain.block, count - begin)) {
      progress_->in_loop(static_cast<double>(begin) / count);
      const int end = begin + std::min(grain.block, count - begin);
      for (int i = begin; i < end; ++i) work(i);
    }
  }

  /// The order of std::sort, if no two elements are equal.
  template <class Iterator>
  void sort(Iterator begin, Iterator end) const {
    const int parts = threads();
    const Grain one_each{1, parts};
    const auto bound = [&](int part) {
      return begin + (end - begin) * std::min(part, parts) / parts;
    };
    for_each(
        parts, [&](int part) { std::sort(bound(part), bound(part + 1)); }, one_each);
    for (int width = 1; width < parts; width *= 2) {
      const auto merge = [&](int pair) {
        const int part = 2 * width * pair;
        std::inplace_merge(bound(part), bound(part + width), bound(part + 2 * width));
      };
      for_each((parts + width - 1) / (2 * width), merge, one_each);
    }
  }

 private:
  template <class Work>
  void run_block(int first, int count, Work& work, int least) const {
    constexpr int shares = 4;  // a thread, so that none waits long for the slowest
    if (count < 2 * least || threads() == 1) return work(first, first + count, 0);
    const int share = std::max(least, count / (shares * threads()));
    std::atomic<int> next{0};
    team_->run([&](int worker) {
      for (int at; (at = next.fetch_add(share)) < count;)
        work(first + at, first + std::min(at + share, count), worker);
    });
  }

  std::unique_ptr<ThreadTeam> team_;
  std::unique_ptr<ProgressMeter> progress_;
};

}  // namespace curvdecim::detail
