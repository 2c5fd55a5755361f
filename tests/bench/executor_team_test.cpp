// Executors that keep their threads at hand: loops inside of with_team.
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "core/error.hpp"
#include "tests/bench/executor_contract.hpp"

namespace pathrace::bench {
namespace {

class ExecutorWithTeam : public EveryExecutor {};

TEST_P(ExecutorWithTeam, WithATeamTheBodyRunsOnceOnTheCallingThread) {
  std::vector<std::thread::id> ran_on;
  executor().with_team([&] { ran_on.push_back(std::this_thread::get_id()); });
  EXPECT_EQ(ran_on, std::vector{std::this_thread::get_id()});
}

TEST_P(ExecutorWithTeam, WithATeamEveryLoopVisitsEveryIndexOnce) {
  executor().with_team([&] {
    for (std::size_t count = 0; count < 300; ++count) {
      ASSERT_EQ(visits(executor(), count, 1 + count % 5), Indices(count, 1)) << count;
    }
  });
}

TEST_P(ExecutorWithTeam, WithATeamAllThreadsComeTogetherLoopAfterLoop) {
  executor().restart_census();
  executor().with_team([&] {
    for (int round = 0; round < 20; ++round) rendezvous(executor());
  });
  EXPECT_EQ(executor().threads_used(), executor().threads());
}

TEST_P(ExecutorWithTeam, ATeamIsGatheredAgainAfterItWasLetGo) {
  for (int round = 0; round < 20; ++round) {
    executor().with_team([&] { rendezvous(executor()); });
    rendezvous(executor());
  }
}

TEST_P(ExecutorWithTeam, AnExceptionComesOutOfALoopAndOutOfTheBodyWithATeam) {
  const auto fail_at_7 = [](std::size_t i) {
    if (i == 7) throw InputError("chunk 7");
  };
  EXPECT_THROW(executor().with_team([] { throw InputError("body"); }), InputError);
  executor().with_team([&] {
    EXPECT_THROW(for_each_index(executor(), 20, 1, fail_at_7), InputError);
    EXPECT_EQ(visits(executor(), 20, 1), Indices(20, 1));
  });
  EXPECT_THROW(executor().with_team([&] { for_each_index(executor(), 20, 1, fail_at_7); }), InputError);
  EXPECT_EQ(visits(executor(), 20, 1), Indices(20, 1));
}

TEST_P(ExecutorWithTeam, TeamsMayBeAskedForInsideOfTeamsAndOfLoops) {
  std::vector<std::atomic<int>> visited(6 * 5);
  const auto inner = [&](std::size_t a) {
    executor().with_team(
        [&] { for_each_index(executor(), 5, 1, [&](std::size_t b) { ++visited[a * 5 + b]; }); });
  };
  executor().with_team([&] { executor().with_team([&] { for_each_index(executor(), 6, 1, inner); }); });
  EXPECT_EQ(Indices(visited.begin(), visited.end()), Indices(6 * 5, 1));
}

TEST_P(ExecutorWithTeam, WhileOneThreadLeadsATeamAnotherMayUseTheExecutorToo) {
  Indices others;
  executor().with_team([&] {
    std::thread other([&] { others = visits(executor(), 50, 1); });
    EXPECT_EQ(visits(executor(), 70, 1), Indices(70, 1));
    other.join();
  });
  EXPECT_EQ(others, Indices(50, 1));
}

TEST_P(ExecutorWithTeam, LoopsOfAnotherExecutorGetItsThreadsInsideOfATeam) {
  const std::unique_ptr<Executor> inner = another();
  executor().with_team([&] {
    inner->with_team([&] {
      rendezvous(*inner);
      rendezvous(executor());
    });
    rendezvous(executor());
  });
  EXPECT_EQ(inner->threads_used(), inner->threads());
}

TEST_P(ExecutorWithTeam, ItsLoopsGetTheTeamAlsoInsideOfATeamOfAnother) {
  const std::unique_ptr<Executor> inner = another();
  executor().restart_census();
  executor().with_team([&] {
    inner->with_team([&] { for_each_index(*inner, 1, 1, [&](std::size_t) { rendezvous(executor()); }); });
  });
  EXPECT_EQ(executor().threads_used(), executor().threads());
}

// Helpers that come when everything is over.
TEST_P(ExecutorWithTeam, ATeamMayBeLetGoAndItsExecutorEndBeforeAnybodyHasCome) {
  for (int round = 0; round < 200; ++round) {
    const std::unique_ptr<Executor> brief = another();
    std::atomic<int> calls{0};
    brief->with_team([&] { for_each_index(*brief, 2, 1, [&](std::size_t) { ++calls; }); });
    ASSERT_EQ(calls, 2);
  }
}

TEST_P(ExecutorWithTeam, AnExecutorMayBeginLeadATeamAndEndInsideOfALoop) {
  std::atomic<int> calls{0};
  for (int round = 0; round < 50; ++round) {
    for_each_index(executor(), 3, 1, [&](std::size_t) {
      const std::unique_ptr<Executor> brief = another();
      brief->with_team([&] { for_each_index(*brief, 2, 1, [&](std::size_t) { ++calls; }); });
    });
  }
  EXPECT_EQ(calls, 50 * 3 * 2);
}

INSTANTIATE_TEST_SUITE_P(Executors, ExecutorWithTeam, executors_and_threads(), test_name);

}  // namespace
}  // namespace pathrace::bench
