// The open MovingAI data: every optimum, by A* through the referee.
#include <gtest/gtest.h>

#include "bench/roster.hpp"
#include "bench/scen_bench.hpp"
#include "scenarios/movingai/folder.hpp"
#include "tests/support/data_folder.hpp"

namespace pathrace::bench {
namespace {

std::size_t matched_by(const std::string& planner, std::size_t limit) {
  const Entrant entrant = roster().enter({planner, {}});
  std::size_t matched = 0;
  for (const scenarios::ScenEntry& entry : scenarios::find_scens(*testing::data_folder() / "movingai")) {
    const ScenReport report = bench_scen(scenarios::MapFile::read(entry.map),
                                         scenarios::ScenFile::read(entry.scen), entrant, limit, 1);
    for (const std::string& remark : report.remarks) ADD_FAILURE() << remark;
    matched += report.matched;
  }
  return matched;
}

TEST(RecordedData, AStarFindsEveryRecordedOptimum) {
  if (!testing::data_folder()) GTEST_SKIP() << testing::without_data;
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_EQ(matched_by("astar", 1'000'000), 23419U);
#else
  EXPECT_EQ(matched_by("astar", 20), 31U * 20);  // instrumented code is slow: twenty queries of each file
#endif
}

TEST(RecordedData, DijkstraAgreesOnASample) {
  if (!testing::data_folder()) GTEST_SKIP() << testing::without_data;
  EXPECT_EQ(matched_by("dijkstra", 5), 31U * 5);
}

}  // namespace
}  // namespace pathrace::bench
