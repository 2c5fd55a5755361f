// What every executor inherits: empty loops, grains, and the census of threads.

#include "core/executor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

namespace pathrace {
namespace {

using Chunks = std::vector<std::pair<std::size_t, std::size_t>>;

// Runs chunks in order and remembers what it was asked for.
class Recorder final : public Executor {
 public:
  std::string_view name() const override { return "recorder"; }
  int threads() const override { return 1; }

  std::vector<std::size_t> counts;
  std::vector<std::size_t> grains;

 private:
  void run_chunks(std::size_t count, std::size_t grain, ChunkBody body) override {
    counts.push_back(count);
    grains.push_back(grain);
    for (std::size_t begin = 0; begin < count; begin += grain) {
      census_.note();
      body(begin, std::min(begin + grain, count));
    }
  }
};

TEST(Executor, AnEmptyLoopRunsNothing) {
  Recorder executor;
  executor.run(0, 5, [](std::size_t, std::size_t) { ADD_FAILURE() << "ran"; });
  for_each_index(executor, 0, 0, [](std::size_t) { ADD_FAILURE() << "ran"; });
  EXPECT_TRUE(executor.counts.empty());
}

TEST(Executor, AGrainOfZeroIsOne) {
  Recorder executor;
  executor.run(3, 0, [](std::size_t, std::size_t) {});
  EXPECT_EQ(executor.grains, (std::vector<std::size_t>{1}));
}

TEST(Executor, ABodySeesItsChunks) {
  Recorder executor;
  Chunks seen;
  executor.run(7, 3, [&](std::size_t begin, std::size_t end) { seen.emplace_back(begin, end); });
  EXPECT_EQ(seen, (Chunks{{0, 3}, {3, 6}, {6, 7}}));
}

TEST(Executor, EachIndexIsVisitedOnce) {
  Recorder executor;
  std::vector<std::size_t> visited;
  for_each_index(executor, 7, 3, [&](std::size_t i) { visited.push_back(i); });
  EXPECT_EQ(visited, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6}));
}

TEST(Executor, HasUsedOneThreadEvenBeforeItRan) {
  Recorder executor;
  EXPECT_EQ(executor.threads_used(), 1);
  executor.run(7, 1, [](std::size_t, std::size_t) {});
  EXPECT_EQ(executor.threads_used(), 1);
}

TEST(ThreadCensus, CountsEachThreadOnce) {
  ThreadCensus census;
  EXPECT_EQ(census.count(), 0);
  census.note();
  census.note();
  EXPECT_EQ(census.count(), 1);
  for (int i = 0; i < 3; ++i) {
    std::thread([&] {
      census.note();
      census.note();
    }).join();
  }
  EXPECT_EQ(census.count(), 4);
}

TEST(ThreadCensus, CountsThreadsThatArriveTogether) {
  ThreadCensus census;
  std::vector<std::thread> threads;
  for (int i = 0; i < 16; ++i) {
    threads.emplace_back([&] {
      for (int k = 0; k < 100; ++k) census.note();
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(census.count(), 16);
}

TEST(ThreadCensus, StartsAfreshWhenCleared) {
  ThreadCensus census;
  std::thread([&] { census.note(); }).join();
  census.note();
  census.clear();
  EXPECT_EQ(census.count(), 0);
  census.note();
  EXPECT_EQ(census.count(), 1);
}

}  // namespace
}  // namespace pathrace
