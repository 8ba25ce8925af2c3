// Threads that share out numbered jobs. The calling thread works too; with one thread no other is ever made.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace gouraud::pipeline {

class WorkerPool {
 public:
  /// `thread_count` >= 1 counts the caller of run(). Threads are made at the first run() that wants them.
  explicit WorkerPool(int thread_count) : thread_count_(thread_count) {}
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Calls job(0) ... job(job_count - 1), each once, in any order, and returns when all are done. With
  /// `worth_waking` false the caller does it all.
  void run(std::int32_t job_count, bool worth_waking, const std::function<void(std::int32_t)>& job);

 private:
  void start();
  void work(const std::stop_token& stop);
  void take_jobs();

  const int thread_count_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::condition_variable done_;
  std::uint64_t generation_ = 0;  ///< counts the runs; workers wait for the next
  int working_ = 0;               ///< workers inside the current run
  const std::function<void(std::int32_t)>* job_ = nullptr;
  std::int32_t job_count_ = 0;
  std::atomic<std::int32_t> next_job_{0};
  std::vector<std::jthread> workers_;
};

}  // namespace gouraud::pipeline
