// Ants that wait: each is handed out once, one's own before a neighbour's.
#include "algorithms/aco/ant_queue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <numeric>
#include <thread>
#include <vector>

namespace pathrace::algorithms {
namespace {

TEST(AntQueue, HandsOutItsAntsInOrderAndThenNone) {
  AntQueue queue(3, 6);
  EXPECT_EQ(queue.take(), 3U);
  EXPECT_EQ(queue.take(), 4U);
  EXPECT_EQ(queue.take(), 5U);
  EXPECT_EQ(queue.take(), AntQueue::none);
  EXPECT_EQ(queue.take(), AntQueue::none);
  queue.fill(0, 1);
  EXPECT_EQ(queue.take(), 0U);
  EXPECT_EQ(AntQueue().take(), AntQueue::none);
}

TEST(AntQueue, HandsOutEverySoManyth) {
  AntQueue queue;
  queue.fill(1, 8, 3);
  EXPECT_EQ(queue.take(), 1U);
  EXPECT_EQ(queue.take(), 4U);
  EXPECT_EQ(queue.take(), 7U);
  EXPECT_EQ(queue.take(), AntQueue::none);
}

// The ring 0 -> 2 -> 1 -> 0: who joins comes right before the one it names.
TEST(AntQueue, AnEmptyOneTakesFromItsNeighboursInTheOrderOfTheRing) {
  AntQueue queues[3];
  queues[1].join(queues[0]);
  queues[2].join(queues[1]);
  for (std::size_t k = 0; k < 3; ++k) queues[k].fill(10 * k, 10 * k + 2);
  std::vector<std::size_t> taken;
  for (std::size_t ant = queues[0].take(); ant != AntQueue::none; ant = queues[0].take()) {
    taken.push_back(ant);
  }
  EXPECT_EQ(taken, (std::vector<std::size_t>{0, 1, 20, 21, 10, 11}));
  for (AntQueue& queue : queues) EXPECT_EQ(queue.take(), AntQueue::none);
}

TEST(AntQueue, EveryAntIsHandedOutOnceToThreadsThatTakeFromEachOther) {
  constexpr std::size_t ants = 30000;
  constexpr std::size_t threads = 4;
  std::deque<AntQueue> queues;
  for (std::size_t k = 0; k < threads; ++k) queues.emplace_back().join(queues.front());
  for (std::size_t k = 0; k < threads; ++k) queues[k].fill(0, 0);
  queues[1].fill(0, ants / 3);  // two have nothing of their own
  queues[2].fill(ants / 3, ants);
  std::vector<std::vector<std::size_t>> taken(threads);
  std::vector<std::thread> crew;
  for (std::size_t k = 0; k < threads; ++k) {
    crew.emplace_back([&, k] {
      for (std::size_t ant = queues[k].take(); ant != AntQueue::none; ant = queues[k].take()) {
        taken[k].push_back(ant);
      }
    });
  }
  for (std::thread& thread : crew) thread.join();
  std::vector<std::size_t> all;
  for (const auto& some : taken) all.insert(all.end(), some.begin(), some.end());
  std::sort(all.begin(), all.end());
  std::vector<std::size_t> expected(ants);
  std::iota(expected.begin(), expected.end(), 0U);
  EXPECT_EQ(all, expected);
}

}  // namespace
}  // namespace pathrace::algorithms
