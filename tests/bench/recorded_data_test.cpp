// The open MovingAI data: every optimum, by each exact search, through the referee.
#include <gtest/gtest.h>

#include "bench/roster.hpp"
#include "bench/scen_bench.hpp"
#include "scenarios/movingai/folder.hpp"
#include "tests/support/data_folder.hpp"

namespace pathrace::bench {
namespace {

std::vector<ScenReport> reports_of(const std::string& planner, std::size_t limit) {
  const Entrant entrant = roster().enter({planner, {}});
  std::vector<ScenReport> reports;
  for (const scenarios::ScenEntry& entry : scenarios::find_scens(*testing::data_folder() / "movingai")) {
    reports.push_back(bench_scen(scenarios::MapFile::read(entry.map), scenarios::ScenFile::read(entry.scen),
                                 entrant, limit, 1));
  }
  return reports;
}

std::size_t matched_by(const std::string& planner, std::size_t limit) {
  std::size_t matched = 0;
  for (const ScenReport& report : reports_of(planner, limit)) {
    for (const std::string& remark : report.remarks) ADD_FAILURE() << remark;
    matched += report.matched;
  }
  return matched;
}

#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
constexpr bool slow_build = false;
#else
constexpr bool slow_build = true;  // twenty queries of each file
#endif

class RecordedData : public ::testing::TestWithParam<const char*> {};

TEST_P(RecordedData, EveryRecordedOptimumIsFound) {
  if (!testing::data_folder()) GTEST_SKIP() << testing::without_data;
  EXPECT_EQ(matched_by(GetParam(), slow_build ? 20 : 1'000'000), slow_build ? 31U * 20 : 23419U);
}

INSTANTIATE_TEST_SUITE_P(Exact, RecordedData, ::testing::Values("astar", "jps"));

TEST(RecordedDijkstra, FindsTheRecordedOptimaOfASample) {
  if (!testing::data_folder()) GTEST_SKIP() << testing::without_data;
  EXPECT_EQ(matched_by("dijkstra", 20), 31U * 20);
}

TEST(RecordedAnyAngle, TheProvenOptimumIsNeverLongerThanARecordedOne) {
  if (!testing::data_folder()) GTEST_SKIP() << testing::without_data;
  EXPECT_EQ(matched_by("any-angle-optimum", 5), 31U * 5);
}

TEST(RecordedAnyAngle, ThetaStarLiesBetweenTheProvenOptimumAndTheRecordedOne) {
  if (!testing::data_folder()) GTEST_SKIP() << testing::without_data;
  std::size_t judged = 0;
  for (const ScenReport& report : reports_of("theta-star", 5)) {
    judged += report.matched + report.mismatched;
    for (const std::string& remark : report.remarks) {
      EXPECT_NE(remark.find(", the proven optimum is "), std::string::npos) << remark;
      EXPECT_EQ(remark.find("the recorded one"), std::string::npos) << remark;
    }
  }
  EXPECT_EQ(judged, 31U * 5);
}

}  // namespace
}  // namespace pathrace::bench
