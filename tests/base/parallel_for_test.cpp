// Also run with the thread sanitizer. Jobs write to plain memory, so the sanitizer reports a missing
// synchronization between the caller and a worker.
#include "base/parallel_for.h"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <thread>
#include <tuple>
#include <vector>

namespace temblor::base {
namespace {

class ParallelFor : public ::testing::TestWithParam<std::tuple<JobBackend, int>> {
 protected:
  JobBackend backend() const { return std::get<0>(GetParam()); }
  int threads() const { return std::get<1>(GetParam()); }
};

TEST_P(ParallelFor, CallsEveryIndexOnce) {
  Jobs jobs(threads(), backend());
  EXPECT_EQ(jobs.threads(), threads());
  for (const std::size_t count : {0u, 1u, 2u, 3u, 7u, 64u, 1000u}) {
    std::vector<int> calls(count, 0);
    jobs.parallel_for(count, [&](std::size_t i) { ++calls.at(i); });
    EXPECT_EQ(calls, std::vector<int>(count, 1)) << count;
  }
}

TEST_P(ParallelFor, JobsSeeWhatTheCallerWroteAndTheCallerWhatTheyWrote) {
  Jobs jobs(threads(), backend());
  std::vector<std::uint64_t> values(257, 1);
  for (int round = 0; round < 300; ++round) {
    for (std::uint64_t& value : values) value += 1;
    jobs.parallel_for(values.size(), [&](std::size_t i) { values[i] = values[i] * 3 % 1000003; });
  }
  std::uint64_t expected = 1;
  for (int round = 0; round < 300; ++round) expected = (expected + 1) * 3 % 1000003;
  EXPECT_EQ(values, std::vector<std::uint64_t>(257, expected));
}

TEST_P(ParallelFor, RunsNoMoreJobsAtATimeThanItHasThreads) {
  Jobs jobs(threads(), backend());
  std::atomic<int> running{0}, most{0};
  jobs.parallel_for(500, [&](std::size_t) {
    const int now = ++running;
    for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) continue;
    std::this_thread::yield();
    --running;
  });
  EXPECT_LE(most, threads());
}

TEST_P(ParallelFor, OneThreadIsTheCallers) {
  Jobs jobs(1, backend());
  std::vector<std::thread::id> workers(50);
  jobs.parallel_for(50, [&](std::size_t i) { workers[i] = std::this_thread::get_id(); });
  EXPECT_EQ(workers, std::vector<std::thread::id>(50, std::this_thread::get_id()));
}

TEST_P(ParallelFor, WorksAfterAMove) {
  Jobs first(threads(), backend());
  Jobs second(1);
  second = std::move(first);
  EXPECT_EQ(second.threads(), threads());
  std::vector<int> calls(100, 0);
  second.parallel_for(100, [&](std::size_t i) { ++calls[i]; });
  EXPECT_EQ(calls, std::vector<int>(100, 1));
}

INSTANTIATE_TEST_SUITE_P(BackendsAndThreads, ParallelFor,
                         ::testing::Combine(::testing::Values(JobBackend::kOneTbb, JobBackend::kStdThread),
                                            ::testing::Values(1, 2, 3, 8)));

// Each job waits for all the others, so the loop ends only if they run at the same time.
TEST(ParallelForThreads, JobsRunAtTheSameTime) {
  Jobs jobs(4, JobBackend::kStdThread);
  std::latch all_here(4);
  jobs.parallel_for(4, [&](std::size_t) { all_here.arrive_and_wait(); });
  EXPECT_TRUE(all_here.try_wait());
}

TEST(ParallelForThreads, TwoPoolsLiveSideBySide) {
  Jobs outer(2, JobBackend::kStdThread);
  std::vector<std::vector<int>> calls(4, std::vector<int>(50, 0));
  outer.parallel_for(4, [&](std::size_t i) {
    Jobs inner(2, JobBackend::kStdThread);
    inner.parallel_for(50, [&](std::size_t j) { ++calls[i][j]; });
  });
  for (const std::vector<int>& row : calls) EXPECT_EQ(row, std::vector<int>(50, 1));
}

TEST(ParallelForDeathTest, NoThreadsAtAllIsOurMistake) {
  EXPECT_DEATH(Jobs(0), "CHECK failed");
}

}  // namespace
}  // namespace temblor::base
