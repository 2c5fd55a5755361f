// The contract of executors. What their threads do for a whole planner's call is in executor_team_test.cpp.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/stream.hpp"
#include "tests/bench/executor_contract.hpp"

namespace pathrace::bench {
namespace {

using pathrace::testing::executors_under_test;
using pathrace::testing::thread_sanitizer;

class ExecutorContract : public EveryExecutor {};

TEST_P(ExecutorContract, HasTheNameAndTheThreadsThatWereAskedForAndSerialHasOne) {
  const auto& [name, threads] = GetParam();
  EXPECT_EQ(executor().name(), name);
  EXPECT_EQ(executor().threads(), name == "serial" ? 1 : threads);
  EXPECT_EQ(executor().threads_used(), 1);
}

TEST_P(ExecutorContract, VisitsEveryIndexOnceWhateverTheCountAndTheGrain) {
  for (const std::size_t grain : {1U, 7U, 64U}) {
    for (const std::size_t count :
         {std::size_t{0}, grain - 1, grain, grain + 1, 10 * grain, std::size_t{20011}}) {
      EXPECT_EQ(visits(executor(), count, grain), Indices(count, 1))
          << "count " << count << " grain " << grain;
    }
  }
}

TEST_P(ExecutorContract, AGrainOfZeroMeansOneAndAHugeOneMeansAll) {
  EXPECT_EQ(visits(executor(), 5, 0), Indices(5, 1));
  EXPECT_EQ(visits(executor(), 5, std::numeric_limits<std::size_t>::max()), Indices(5, 1));
}

TEST_P(ExecutorContract, CutsChunksAtMultiplesOfTheGrain) {
  std::mutex mutex;
  std::set<std::pair<std::size_t, std::size_t>> chunks;
  const auto body = [&](std::size_t begin, std::size_t end) {
    const std::scoped_lock lock(mutex);
    chunks.emplace(begin, end);
  };
  executor().run(10, 4, body);
  EXPECT_EQ(chunks, (std::set<std::pair<std::size_t, std::size_t>>{{0, 4}, {4, 8}, {8, 10}}));
}

TEST_P(ExecutorContract, RunsALoopOfOneChunkOnTheCallingThread) {
  std::thread::id ran_on;
  for_each_index(executor(), 8, 8, [&](std::size_t) { ran_on = std::this_thread::get_id(); });
  EXPECT_EQ(ran_on, std::this_thread::get_id());
}

TEST_P(ExecutorContract, GivesTheSameSlotsAsAPlainLoop) {
  constexpr std::size_t count = 5000;
  const Stream stream(42);
  const auto draw = [&](std::size_t i) { return stream.fork(i).bits(); };
  std::vector<std::uint64_t> expected(count);
  for (std::size_t i = 0; i < count; ++i) expected[i] = draw(i);
  std::vector<std::uint64_t> slots(count);
  for_each_index(executor(), count, 16, [&](std::size_t i) { slots[i] = draw(i); });
  EXPECT_EQ(slots, expected);
}

TEST_P(ExecutorContract, AsManyThreadsAsAskedForReallyRunTogether) {
  rendezvous(executor());
  EXPECT_EQ(executor().threads_used(), executor().threads());
}

TEST_P(ExecutorContract, AnExceptionInABodyComesOut) {
  const auto fail_at_77 = [](std::size_t i) {
    if (i == 77) throw InputError("chunk 77");
  };
  try {
    for_each_index(executor(), 100, 1, fail_at_77);
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "chunk 77");
  }
}

TEST_P(ExecutorContract, TheExceptionOfTheLowestChunkComesOutWhenAllThrow) {
  const auto fail = [](std::size_t i) { throw std::runtime_error(fmt::format("chunk {}", i)); };
  for (int round = 0; round < 20; ++round) {
    try {
      for_each_index(executor(), 64, 1, fail);
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      ASSERT_STREQ(error.what(), "chunk 0");
    }
  }
}

// With threads to spare the lowest chunk throws last: it waits until the other one is on its way out.
TEST_P(ExecutorContract, TheExceptionOfTheLowestChunkComesOutEvenWhenItIsTheLastToThrow) {
  std::atomic<bool> higher_has_thrown = false;
  struct Announce {
    std::atomic<bool>& flag;
    ~Announce() {
      flag = true;
      flag.notify_all();
    }
  };
  const auto body = [&](std::size_t i) {
    if (i == 0) {
      if (parallel()) higher_has_thrown.wait(false);
      throw std::runtime_error("low");
    }
    const Announce announce{higher_has_thrown};  // on the way out of the body
    throw std::runtime_error("high");
  };
  try {
    for_each_index(executor(), 2, 1, body);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "low");
  }
}

TEST_P(ExecutorContract, EveryChunkBelowTheOneThatThrewStillRuns) {
  std::vector<std::atomic<int>> visited(200);
  const auto body = [&](std::size_t i) {
    ++visited[i];
    if (i >= 150) throw std::runtime_error("late");
  };
  EXPECT_THROW(for_each_index(executor(), visited.size(), 1, body), std::runtime_error);
  for (std::size_t i = 0; i <= 150; ++i) EXPECT_EQ(visited[i], 1) << i;
}

TEST_P(ExecutorContract, WorksAgainAfterAnException) {
  const auto fail = [](std::size_t) { throw std::runtime_error("once"); };
  EXPECT_THROW(for_each_index(executor(), 50, 1, fail), std::runtime_error);
  EXPECT_EQ(visits(executor(), 50, 1), Indices(50, 1));
}

// Three levels of 6 x 5 x 4 indices.
TEST_P(ExecutorContract, ALoopMayRunLoopsOfTheSameExecutorInItsBody) {
  std::vector<std::atomic<int>> visited(6 * 5 * 4);
  for_each_index(executor(), 6, 1, [&](std::size_t a) {
    for_each_index(executor(), 5, 1, [&](std::size_t b) {
      for_each_index(executor(), 4, 1, [&](std::size_t c) { ++visited[(a * 5 + b) * 4 + c]; });
    });
  });
  EXPECT_EQ(Indices(visited.begin(), visited.end()), Indices(6 * 5 * 4, 1));
}

TEST_P(ExecutorContract, ALoopMayRunLoopsOfAnotherExecutorInItsBodyAndThoseGetTheirThreadsToo) {
  const std::size_t outer_loops = 3;
  std::vector<int> used(outer_loops);
  for_each_index(executor(), outer_loops, 1, [&](std::size_t i) {
    const std::unique_ptr<Executor> inner = another();
    rendezvous(*inner);
    used[i] = inner->threads_used();
  });
  EXPECT_EQ(used, std::vector<int>(outer_loops, executor().threads()));
}

TEST_P(ExecutorContract, ALoopMayRunLoopsOfEveryOtherKindInItsBody) {
  for (const std::string& name : executors_under_test()) {
    const std::unique_ptr<Executor> inner = make_executor(name, 2);
    std::vector<std::atomic<int>> visited(8 * 9);
    for_each_index(executor(), 8, 1, [&](std::size_t a) {
      for_each_index(*inner, 9, 1, [&](std::size_t b) { ++visited[a * 9 + b]; });
    });
    EXPECT_EQ(Indices(visited.begin(), visited.end()), Indices(8 * 9, 1)) << name;
  }
}

TEST_P(ExecutorContract, AnExceptionComesOutOfNestedLoops) {
  const auto inner = [](std::size_t i) {
    if (i == 3) throw std::runtime_error("inner");
  };
  const auto outer = [&](std::size_t) { for_each_index(executor(), 10, 1, inner); };
  EXPECT_THROW(for_each_index(executor(), 10, 1, outer), std::runtime_error);
}

TEST_P(ExecutorContract, SeveralThreadsMayUseItAtTheSameTime) {
  constexpr std::size_t callers = 4;
  constexpr int rounds = 50;
  std::vector<int> complete(callers, 0);
  std::vector<std::thread> threads;
  for (std::size_t caller = 0; caller < callers; ++caller) {
    threads.emplace_back([&, caller] {
      for (int round = 0; round < rounds; ++round) {
        complete[caller] += visits(executor(), 100 + caller, 3) == Indices(100 + caller, 1) ? 1 : 0;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(complete, std::vector<int>(callers, rounds));
}

TEST_P(ExecutorContract, AnExceptionReachesTheCallerItBelongsToAndNoOther) {
  constexpr std::size_t callers = 4;
  std::vector<std::string> seen(callers);
  std::vector<std::thread> threads;
  for (std::size_t caller = 0; caller < callers; ++caller) {
    threads.emplace_back([&, caller] {
      const auto body = [&](std::size_t) { throw std::runtime_error(fmt::format("caller {}", caller)); };
      try {
        for_each_index(executor(), 20, 1, body);
      } catch (const std::runtime_error& error) {
        seen[caller] = error.what();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(seen, (std::vector<std::string>{"caller 0", "caller 1", "caller 2", "caller 3"}));
}

INSTANTIATE_TEST_SUITE_P(Executors, ExecutorContract, executors_and_threads(), test_name);

TEST(Executors, TwoKindsAndTwoSizesAtATimeAllGetTheirThreads) {
  std::vector<std::unique_ptr<Executor>> executors;
  for (const std::string& name : executors_under_test()) {
    for (const int threads : {2, 5, 3}) executors.push_back(make_executor(name, threads));
  }
  for (const std::unique_ptr<Executor>& executor : executors) {
    rendezvous(*executor);
    EXPECT_EQ(executor->threads_used(), executor->threads()) << executor->name();
  }
}

// 4 outer chunks on 3 threads, each with an inner loop: three threads in all, not three times three.
TEST(Executors, NestedLoopsOfOneOpenMpExecutorShareItsThreads) {
  if (thread_sanitizer) return;
  const std::unique_ptr<Executor> executor = make_executor("openmp", 3);
  for_each_index(*executor, 4, 1, [&](std::size_t) { for_each_index(*executor, 50, 1, [](std::size_t) {}); });
  EXPECT_LE(executor->threads_used(), 3);
}

TEST(Executors, AreListedInTheOrderInWhichHelpTextsShowThem) {
  EXPECT_EQ(executor_names(), (std::vector<std::string>{"serial", "openmp", "tbb", "threads"}));
}

TEST(Executors, TheDefaultIsOneOfThemAndUnderTheThreadSanitizerTheOneItSeesThrough) {
  const std::vector<std::string> names = executor_names();
  EXPECT_NE(std::find(names.begin(), names.end(), default_backend()), names.end()) << default_backend();
  if (thread_sanitizer) {
    EXPECT_EQ(default_backend(), "threads");
  }
}

TEST(Executors, AnUnknownNameIsRefusedWithTheNearestMatch) {
  try {
    make_executor("opnmp", 2);
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "unknown backend 'opnmp'; the nearest match is 'openmp'");
  }
}

TEST(Executors, ThreadsOutsideOneTo256AreRefusedByEveryExecutor) {
  for (const std::string& name : executor_names()) {
    for (const int threads : {-1, 0, 257})
      EXPECT_THROW(make_executor(name, threads), InputError) << name << threads;
    EXPECT_NO_THROW(make_executor(name, 256)) << name;
  }
}

}  // namespace
}  // namespace pathrace::bench
