// Threads of a team find processors of their own; nobody else is moved for good.
//
// Where a thread is, the system's scheduler decides anew at any time. Here two functions of the C library are
// replaced in the whole test program, by a scheduler that moves a thread only when it must: a thread stays
// where it was when it first asked until it leaves that processor out of those it may run on; then it is on
// the first of these. The system's affinities are set as well. So tests see what threads ask for, whatever
// else the machine is doing.
#include "bench/executors/processor_shares.hpp"

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "bench/executors.hpp"
#include "tests/support/processors.hpp"
#include "tests/support/sanitizers.hpp"

namespace {

thread_local int calm_processor = -1;

void stay_within(const cpu_set_t& processors) {
  if (CPU_ISSET(sched_getcpu(), &processors)) return;
  for (calm_processor = 0; !CPU_ISSET(calm_processor, &processors);) ++calm_processor;
}

}  // namespace

extern "C" int sched_getcpu() noexcept {
  unsigned processor = 0;
  if (calm_processor < 0 && syscall(SYS_getcpu, &processor, nullptr, nullptr) == 0) {
    calm_processor = static_cast<int>(processor);
  }
  return calm_processor;
}

extern "C" int sched_setaffinity(pid_t thread, std::size_t size, const cpu_set_t* processors) noexcept {
  const auto result = static_cast<int>(syscall(SYS_sched_setaffinity, thread, size, processors));
  if (result == 0 && thread == 0) stay_within(*processors);
  return result;
}

namespace pathrace::bench {
namespace {

using testing::allowed_processors;
using testing::Processors;
using testing::thread_sanitizer;

constexpr const char* not_instrumented = "the thread sanitizer would report the locks of OpenMP and TBB";

void in_a_thread_of_its_own(const std::function<void()>& body) {
  std::thread(body).join();
}

// Two threads wait here for each other; but TBB promises nobody that a second one comes.
void meet(std::atomic<int>& present) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  for (++present; present < 2 && std::chrono::steady_clock::now() < end;) std::this_thread::yield();
}

// Of two shares, the k-th: every other of the calling thread's processors.
Processors share_of(int k) {
  Processors share;
  int next = 0;
  for (const int processor : allowed_processors()) {
    if (next++ % 2 == k) share.insert(processor);
  }
  return share;
}

Processors union_of(const std::vector<Processors>& sets) {
  Processors all;
  for (const Processors& set : sets) all.insert(set.begin(), set.end());
  return all;
}

std::size_t sum_of_sizes(const std::vector<Processors>& sets) {
  std::size_t sum = 0;
  for (const Processors& set : sets) sum += set.size();
  return sum;
}

TEST(ProcessorShares, AreDisjointAndTogetherAllProcessors) {
  const Processors all = allowed_processors();
  for (int threads = 1; threads <= static_cast<int>(all.size()); ++threads) {
    const ProcessorShares shares(threads);
    EXPECT_TRUE(shares.exist());
    std::vector<Processors> share(static_cast<std::size_t>(threads));
    for (int k = 0; k < threads; ++k) {
      in_a_thread_of_its_own([&] {
        shares.settle(k);
        EXPECT_TRUE(shares.here(k));
        share[static_cast<std::size_t>(k)] = allowed_processors();
      });
    }
    EXPECT_EQ(union_of(share), all) << threads;
    EXPECT_EQ(sum_of_sizes(share), all.size()) << threads;
    for (const Processors& one : share) EXPECT_FALSE(one.empty()) << threads;
  }
}

TEST(ProcessorShares, ThereAreNoneWhereThreadsOutnumberProcessors) {
  const Processors all = allowed_processors();
  const ProcessorShares shares(static_cast<int>(all.size()) + 1);
  EXPECT_FALSE(shares.exist());
  EXPECT_FALSE(shares.here(0));
  in_a_thread_of_its_own([&] {
    shares.settle(0);
    shares.go_to(1);
    EXPECT_EQ(allowed_processors(), all);
  });
}

TEST(ProcessorShares, WhoGoesToOneIsThereAndMayBeMovedOn) {
  const Processors all = allowed_processors();
  const auto threads = static_cast<int>(all.size());
  const ProcessorShares shares(threads);
  in_a_thread_of_its_own([&] {
    for (int k = 0; k < threads; ++k) {
      shares.go_to(k);
      EXPECT_TRUE(shares.here(k)) << k;
      EXPECT_EQ(allowed_processors(), all) << k;
    }
  });
}

// Threads of this process that may run on just these.
int threads_on(const Processors& processors) {
  int threads = 0;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    threads += allowed_processors(std::stoi(task.path().filename())) == processors ? 1 : 0;
  }
  return threads;
}

// Before the first loop, which might be over before they had started.
TEST(ProcessorShares, ThreadsOfANewOpenMpExecutorAreAtTheirPlaces) {
  if (thread_sanitizer) GTEST_SKIP() << not_instrumented;
  if (allowed_processors().size() < 2) GTEST_SKIP() << "needs two processors";
  in_a_thread_of_its_own([] {
    const std::unique_ptr<Executor> executor = make_executor("openmp", 2);
    EXPECT_GT(threads_on(share_of(1)), 0);
  });
}

class TeamOnShares : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (thread_sanitizer) GTEST_SKIP() << not_instrumented;
    if (allowed_processors().size() < 2) GTEST_SKIP() << "needs two processors";
  }
};

TEST_P(TeamOnShares, WhoGathersItLeavesTheProcessorsOfTheOthers) {
  in_a_thread_of_its_own([] {
    const ProcessorShares shares(2);
    const std::unique_ptr<Executor> executor = make_executor(GetParam(), 2);
    for (int round = 0; round < 50; ++round) {
      shares.go_to(1);
      executor->with_team([&] {
        for_each_index(*executor, 2, 1, [](std::size_t) {});
        EXPECT_TRUE(shares.here(0)) << round;
      });
    }
  });
}

// Also when the helper comes from where the leader is.
TEST_P(TeamOnShares, ItsHelperIsNotOnTheProcessorOfItsLeader) {
  const Processors all = allowed_processors();
  in_a_thread_of_its_own([&all] {
    const ProcessorShares shares(2);
    const std::unique_ptr<Executor> executor = make_executor(GetParam(), 2);
    const auto leader = std::this_thread::get_id();
    std::atomic<int> came{0};
    std::atomic<int> apart{0};
    for (int round = 0; round < 50; ++round) {
      std::atomic<int> present{0};
      executor->with_team([&] {
        for_each_index(*executor, 2, 1, [&](std::size_t) {
          const bool helps = std::this_thread::get_id() != leader;
          if (helps) ++came;
          if (helps && shares.here(1)) ++apart;
          meet(present);
          if (helps) shares.go_to(0);
        });
      });
    }
    EXPECT_GT(came, 0);
    EXPECT_EQ(apart, came);
    EXPECT_EQ(allowed_processors(), all);
  });
}

// There others have their places already.
TEST_P(TeamOnShares, InsideOfALoopNobodyIsMoved) {
  in_a_thread_of_its_own([] {
    const ProcessorShares shares(2);
    const std::unique_ptr<Executor> outer = make_executor(GetParam(), 2);
    const std::unique_ptr<Executor> inner = make_executor(GetParam(), 2);
    for (int round = 0; round < 50; ++round) {
      for_each_index(*outer, 2, 1, [&](std::size_t k) {
        if (k == 1) return;
        shares.go_to(1);
        inner->with_team([&] {
          for_each_index(*inner, 2, 1, [](std::size_t) {});
          EXPECT_TRUE(shares.here(1)) << round;
        });
      });
    }
  });
}

INSTANTIATE_TEST_SUITE_P(ProcessorShares, TeamOnShares, ::testing::Values("openmp", "tbb"),
                         [](const auto& backend) { return backend.param; });

// A worker that is bound would bind those whom it starts.
TEST(ProcessorShares, AThreadOfATbbTeamMayRunAnywhere) {
  if (thread_sanitizer) GTEST_SKIP() << not_instrumented;
  const Processors all = allowed_processors();
  if (all.size() < 2) GTEST_SKIP() << "needs two processors";
  in_a_thread_of_its_own([&all] {
    const std::unique_ptr<Executor> executor = make_executor("tbb", 2);
    std::vector<Processors> seen(2);
    std::atomic<int> present{0};
    executor->with_team([&] {
      for_each_index(*executor, 2, 1, [&](std::size_t k) {
        meet(present);
        seen[k] = allowed_processors();
      });
    });
    EXPECT_EQ(seen, std::vector<Processors>(2, all));
  });
}

// From its first loop on, in a team and without.
TEST(ProcessorShares, KeepThreadsOfAnOpenMpExecutorApart) {
  if (thread_sanitizer) GTEST_SKIP() << not_instrumented;
  const Processors all = allowed_processors();
  if (all.size() < 2) GTEST_SKIP() << "needs two processors";
  in_a_thread_of_its_own([&all] {
    const std::unique_ptr<Executor> executor = make_executor("openmp", 2);
    const auto caller = std::this_thread::get_id();
    const auto processors_of_the_other = [&] {
      std::vector<Processors> others(2);
      std::atomic<int> present{0};
      for_each_index(*executor, 2, 1, [&](std::size_t k) {
        meet(present);
        if (std::this_thread::get_id() != caller) others[k] = allowed_processors();
      });
      return union_of(others);
    };
    const auto check = [&] {
      EXPECT_EQ(processors_of_the_other(), share_of(1));
      EXPECT_EQ(allowed_processors(), all);
    };
    check();
    executor->with_team(check);
    EXPECT_EQ(allowed_processors(), all);
  });
}

}  // namespace
}  // namespace pathrace::bench
