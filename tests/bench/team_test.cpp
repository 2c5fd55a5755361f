// Teams by themselves, with plain threads for helpers, so that the thread sanitizer sees all of them.
#include "bench/executors/team.hpp"

#include <gtest/gtest.h>

#include <barrier>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

#include "core/stream.hpp"

namespace pathrace::bench {
namespace {

// Leads a team of this many helpers.
void lead(std::size_t helpers, const std::function<void(Team&)>& body) {
  Team team;
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < helpers; ++k) threads.emplace_back([&team] { team.serve(); });
  body(team);
  team.dismiss();
  for (std::thread& thread : threads) thread.join();
}

template <typename Body>
void run(Team& team, std::size_t count, const Body& body) {
  ThreadCensus census;
  const auto chunk = [&body](std::size_t begin, std::size_t) { body(begin); };
  Chunks chunks(count, 1, chunk, census);
  team.run(chunks);
  chunks.rethrow();
}

TEST(ExecutorTeam, ALeaderWithoutHelpersDoesEverything) {
  lead(0, [](Team& team) {
    std::vector<int> visited(9, 0);
    run(team, visited.size(), [&](std::size_t k) { ++visited[k]; });
    EXPECT_EQ(visited, std::vector<int>(9, 1));
  });
}

TEST(ExecutorTeam, ManyShortLoopsEachVisitEveryChunkOnceAndTheLeaderSeesWhatHelpersWrote) {
  lead(3, [](Team& team) {
    for (int loop = 1; loop <= 3000; ++loop) {
      std::vector<int> slots(7, 0);  // of plain memory: a sanitizer sees who reads too early
      run(team, slots.size(), [&](std::size_t k) { slots[k] += loop; });
      ASSERT_EQ(slots, std::vector<int>(7, loop));
    }
  });
}

TEST(ExecutorTeam, HelpersSeeWhatTheLeaderWroteBeforeTheLoop) {
  lead(3, [](Team& team) {
    std::vector<int> input(7, 0);
    std::vector<int> output(7, 0);
    for (int loop = 1; loop <= 3000; ++loop) {
      for (int& value : input) value = loop;
      run(team, input.size(), [&](std::size_t k) { output[k] = input[k]; });
      ASSERT_EQ(output, input);
    }
  });
}

TEST(ExecutorTeam, AllHelpersComeWhenTheyAreNeededHoweverLongTheyHaveWaited) {
  std::uint64_t sum = 0;
  lead(3, [&sum](Team& team) {
    for (int loop = 0; loop < 200; ++loop) {
      std::barrier together(4);  // every chunk waits until all four have begun
      run(team, 4, [&](std::size_t) { together.arrive_and_wait(); });
      Stream stream(1);  // about a millisecond's work now and then: helpers have long gone to sleep by then
      for (int draw = 0; draw < (loop % 10 == 0 ? 1000000 : 0); ++draw) sum += stream.bits();
    }
  });
  EXPECT_NE(sum, 0U);
}

TEST(ExecutorTeam, HelpersThatNeverHadALoopGoHomeToo) {
  for (int round = 0; round < 50; ++round) lead(4, [](Team&) {});
}

TEST(ExecutorTeam, ALoopWithoutChunksIsDoneAtOnce) {
  lead(2, [](Team& team) {
    run(team, 0, [](std::size_t) { FAIL(); });
    int visited = 0;
    run(team, 1, [&](std::size_t) { ++visited; });
    EXPECT_EQ(visited, 1);
  });
}

}  // namespace
}  // namespace pathrace::bench
