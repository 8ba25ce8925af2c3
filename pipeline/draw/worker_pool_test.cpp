#include "pipeline/draw/worker_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace gouraud::pipeline {
namespace {

TEST(WorkerPool, DoesEachJobOnceHoweverOftenItRuns) {
  for (const int threads : {1, 2, 5}) {
    WorkerPool pool(threads);
    for (const std::int32_t jobs : {0, 1, 2, 7, 1000}) {
      for (int repeat = 0; repeat < 20; ++repeat) {
        std::vector<std::atomic<int>> done(static_cast<std::size_t>(jobs));
        pool.run(jobs, true, [&](std::int32_t i) { ++done[static_cast<std::size_t>(i)]; });
        for (const auto& count : done) ASSERT_EQ(count.load(), 1);
      }
    }
  }
}

TEST(WorkerPool, ThatIsNotWorthWakingRunsOnTheCaller) {
  WorkerPool pool(4);
  const std::thread::id caller = std::this_thread::get_id();
  pool.run(50, false, [&](std::int32_t) { EXPECT_EQ(std::this_thread::get_id(), caller); });
}

}  // namespace
}  // namespace gouraud::pipeline
