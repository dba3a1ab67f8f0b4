// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "vcg_ext/parallel/processor.h"

namespace curvdecim::detail {

/// Threads that wait for the next job. They start with the first job and end with the team, so that
/// a job costs some microseconds and not the start of a thread.
class ThreadTeam {
 public:
  using Job = std::function<void(int worker)>;

  /// size: threads in all, the calling one included.
  explicit ThreadTeam(int size) : size_(size) {}
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;
  ~ThreadTeam() {
    give(nullptr);
    for (std::thread& thread : threads_) thread.join();
  }

  int size() const { return size_; }

  /// job(worker) once on every thread, worker 0 on the calling one; returns when all are done.
  /// Throws what a worker threw.
  void run(const Job& job) {
    start();
    error_ = nullptr;
    give(&job);
    attempt(job, 0);
    wait_for([this] { return working_.load() == 0; });
    if (error_) std::rethrow_exception(error_);
  }

 private:
  /// Looks at the condition this often, for about a millisecond, before it goes to sleep: a thread
  /// that sleeps takes some tens of microseconds to wake, as long as a whole small job, and may
  /// wake where the one that wakes it is at work.
  static constexpr int looks = 3000;

  /// Where the system grants fewer threads, the team is smaller.
  void start() {
    if (!threads_.empty()) return;
    const Processor callers = Processor::current();
    try {
      for (int worker = 1; worker < size_; ++worker)
        threads_.emplace_back([this, worker, callers] { callers.leave(), serve(worker); });
    } catch (const std::system_error&) {
      size_ = static_cast<int>(threads_.size()) + 1;
    }
  }

  /// A job, or nullptr to go home.
  void give(const Job* job) {
    {
      const std::lock_guard lock(mutex_);
      job_ = job;
      working_ = static_cast<int>(threads_.size());
      ++turn_;
    }
    changed_.notify_all();
  }

  void serve(int worker) {
    for (unsigned turn = 1;; ++turn) {
      wait_for([&] { return turn_.load() == turn; });
      if (!job_) return;
      attempt(*job_, worker);
      if (--working_ == 0) {
        const std::lock_guard lock(mutex_);
        changed_.notify_all();
      }
    }
  }

  void attempt(const Job& job, int worker) {
    try {
      job(worker);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      error_ = std::current_exception();
    }
  }

  template <class Condition>
  void wait_for(Condition condition) {
    for (int i = 0; i < looks; ++i) {
      if (condition()) return;
      std::this_thread::yield();
    }
    std::unique_lock lock(mutex_);
    changed_.wait(lock, condition);
  }

  int size_;
  std::vector<std::thread> threads_;
  std::mutex mutex_;
  std::condition_variable changed_;  // turn_ or working_
  std::atomic<unsigned> turn_{0};    // number of the job
  std::atomic<int> working_{0};      // threads that have not finished it
  const Job* job_ = nullptr;
  std::exception_ptr error_;
};

}  // namespace curvdecim::detail
