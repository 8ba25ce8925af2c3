#include "pipeline/draw/worker_pool.h"

namespace gouraud::pipeline {

WorkerPool::~WorkerPool() {
  for (std::jthread& worker : workers_) worker.request_stop();
}

void WorkerPool::start() {
  for (int i = 1; i < thread_count_; ++i) {
    workers_.emplace_back([this](const std::stop_token& stop) { work(stop); });
  }
}

void WorkerPool::take_jobs() {
  for (std::int32_t i = next_job_.fetch_add(1); i < job_count_; i = next_job_.fetch_add(1)) (*job_)(i);
}

void WorkerPool::work(const std::stop_token& stop) {
  std::uint64_t seen = 0;
  std::unique_lock lock(mutex_);
  while (wake_.wait(lock, stop, [&] { return generation_ != seen; })) {
    seen = generation_;
    if (job_ == nullptr) continue;  // woke after the run had ended
    ++working_;
    lock.unlock();
    take_jobs();
    lock.lock();
    if (--working_ == 0) done_.notify_one();
  }
}

void WorkerPool::run(std::int32_t job_count, bool worth_waking, const std::function<void(std::int32_t)>& job) {
  if (thread_count_ == 1 || !worth_waking || job_count < 2) {
    for (std::int32_t i = 0; i < job_count; ++i) job(i);
    return;
  }
  if (workers_.empty()) start();
  {
    const std::lock_guard lock(mutex_);
    job_ = &job;
    job_count_ = job_count;
    next_job_.store(0);
    ++generation_;
  }
  wake_.notify_all();
  take_jobs();
  std::unique_lock lock(mutex_);
  done_.wait(lock, [&] { return working_ == 0; });
  job_ = nullptr;
}

}  // namespace gouraud::pipeline
