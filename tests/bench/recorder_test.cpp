#include "bench/recorder.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "core/error.hpp"
#include "tests/support/process.hpp"

namespace pathrace::bench {
namespace {

using testing::ScratchFolder;

results::TrialRow row_of(std::uint64_t key) {
  results::TrialRow row;
  row.key = key;
  row.scenario = "trap-u/20/1";
  row.planner = "astar";
  row.call = "astar";
  row.verdict = Verdict::no_path;
  return row;
}

results::Store new_store(const ScratchFolder& scratch) {
  return results::Store::create(scratch / "results.db", {"x", "", 0, 1, 0});
}

TEST(Recorder, LetsTrialsWaitForTheStore) {
  constexpr std::size_t count = 3 * Recorder::most_waiting;
  const ScratchFolder scratch;
  results::Store store = new_store(scratch);
  std::atomic<bool> stop{false};
  std::atomic<std::size_t> added{0};
  std::size_t most_behind = 0;
  {
    Recorder recorder(store, stop, [&](std::size_t written) {
      most_behind = std::max(most_behind, added.load() - written);
    });
    for (std::size_t i = 0; i < count; ++i) {
      ++added;
      recorder.add(row_of(i + 1));
    }
    recorder.finish();
  }
  EXPECT_EQ(store.size(), count);
  EXPECT_LE(most_behind, Recorder::most_waiting + 1);  // and the one that waits to be added
}

TEST(Recorder, LetsNobodyWaitForAStoreThatRefuses) {
  const ScratchFolder scratch;
  results::Store store = new_store(scratch);
  std::atomic<bool> stop{false};
  Recorder recorder(store, stop, [](std::size_t) {});
  for (std::size_t i = 0; i < 2 * Recorder::most_waiting; ++i) recorder.add(row_of(7));  // a key twice
  EXPECT_THROW(recorder.finish(), std::logic_error);
  EXPECT_TRUE(stop.load());
}

}  // namespace
}  // namespace pathrace::bench
