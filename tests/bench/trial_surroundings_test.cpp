// What a planner leaves behind in its thread, its map or its processor's registers is nobody else's.
#include "bench/trial_surroundings.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cfenv>
#include <cmath>
#include <limits>

#include "bench/trial.hpp"
#include "tests/support/trials.hpp"

#if defined(__SSE2__)
#include <pmmintrin.h>
#endif

namespace pathrace::bench {
namespace {

using testing::grid_of;
using testing::scenario_of;

void make_floats_strange() {
  std::fesetround(FE_UPWARD);
#if defined(__SSE2__)
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
#endif
}

// Rounds to nearest and keeps subnormal numbers: computed, whatever registers say.
bool floats_are_usual() {
  volatile double one = 1;
  volatile double least = std::numeric_limits<double>::min();
  volatile double tiny = 0x1p-60;
  return one + tiny == 1 && -one - tiny == -1 && least / 2 != 0;
}

// The test's own thread as it was before.
struct Restored {
  Restored() { std::fegetenv(&before); }
  ~Restored() { std::fesetenv(&before); }
  std::fenv_t before;
};

class Surrounded : public ::testing::Test {
 protected:
  TrialRecord run(PlanFunction plan, Executor& executor, bool check_map = false) const {
    PlannerCard card;
    card.name = "test";
    card.track = Track::lattice;
    card = without_parameters(std::move(card), unprepared(std::move(plan)));
    const Entrant entrant{&card, {}, "test"};
    return run_trial(entrant, scenario_, Referee(scenario_.terrain), {}, Stream(1), executor, nullptr,
                     nullptr, check_map);
  }

  const Scenario scenario_ = scenario_of({grid_of({"..", ".."}), {0, 0}, {1, 1}});
  const Path answer_ = lattice_path({{0, 0}, {1, 1}});
};

TEST_F(Surrounded, ATrialBeginsWithUsualFloatsAndLeavesThoseOfItsCaller) {
  const Restored afterwards;
  const auto executor = make_executor("serial", 1);
  bool usual = false;
  const auto look_and_change = [&](const Problem&, Context&) -> Answer {
    usual = floats_are_usual();
    make_floats_strange();
    return answer_;
  };
  run(look_and_change, *executor);
  EXPECT_TRUE(usual);
  EXPECT_TRUE(floats_are_usual());

  make_floats_strange();
  usual = false;
  run(look_and_change, *executor);
  EXPECT_TRUE(usual);
  EXPECT_FALSE(floats_are_usual());
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
}

TEST_F(Surrounded, EveryChunkOfEveryThreadHasUsualFloats) {
  for (const std::string& backend : testing::executors_under_test()) {
    SCOPED_TRACE(backend);
    const Restored afterwards;
    make_floats_strange();  // threads that are started now inherit it
    const auto executor = make_executor(backend, 3);
    std::atomic<int> strange{0};
    const TrialRecord record = run(
        [&](const Problem&, Context& context) -> Answer {
          make_floats_strange();
          for (int loop = 0; loop < 3; ++loop) {
            for_each_index(context.executor, 30, 1, [&strange](std::size_t) {
              if (!floats_are_usual()) ++strange;
              make_floats_strange();
            });
          }
          if (floats_are_usual()) strange += 1000;  // the planner's own setting stays
          return answer_;
        },
        *executor);
    EXPECT_EQ(record.verdict, Verdict::solved) << record.note;
    EXPECT_EQ(strange, 0);
  }
}

TEST_F(Surrounded, APlannerThatChangesTheMapIsInvalidAndChangesNobodyElses) {
  const auto executor = make_executor("serial", 1);
  const OccupancyGrid before = scenario_.grid();
  const auto meddle = [this](const Problem& problem, Context&) -> Answer {
    const_cast<OccupancyGrid&>(problem.grid).block({1, 0});
    return answer_;
  };
  const TrialRecord record = run(meddle, *executor, true);
  EXPECT_EQ(record.verdict, Verdict::invalid);
  EXPECT_NE(record.note.find("changed the map"), std::string::npos) << record.note;
  EXPECT_FALSE(record.metrics.has_value());
  EXPECT_EQ(scenario_.grid(), before);
  const auto behave = [this](const Problem&, Context&) -> Answer { return answer_; };
  EXPECT_EQ(run(behave, *executor, true).verdict, Verdict::solved);
}

// Works until its thread has used that much of its processor.
void work_for(double seconds) {
  const ProcessorTime begin = thread_time();
  while ((thread_time() - begin).total_s() < seconds) {
  }
}

TEST_F(Surrounded, CostsHaveTheProcessorTimeOfThePlannersThread) {
  const auto executor = make_executor("serial", 1);
  const TrialRecord record = run(
      [this](const Problem&, Context&) -> Answer {
        work_for(0.02);
        return answer_;
      },
      *executor);
  ASSERT_TRUE(record.costs.user_s && record.costs.system_s);
  EXPECT_GE(*record.costs.user_s + *record.costs.system_s, 0.02);
}

TEST_F(Surrounded, CostsHaveTheProcessorTimeOfHelpersToo) {
  const auto executor = make_executor("threads", 2);
  const TrialRecord record = run(
      [this](const Problem&, Context& context) -> Answer {
        for_each_index(context.executor, 2, 1, [](std::size_t) { work_for(0.02); });
        return answer_;
      },
      *executor);
  ASSERT_TRUE(record.costs.user_s && record.costs.system_s);
  EXPECT_GE(*record.costs.user_s + *record.costs.system_s, 0.04);
}

TEST(Disturbed, MeansMoreThanAFifthAndTenMillisecondsWithoutAProcessor) {
  EXPECT_TRUE(disturbed(1.0, {0.70, 0.05}));
  EXPECT_FALSE(disturbed(1.0, {0.80, 0.05}));
  EXPECT_TRUE(disturbed(0.030, {0.015, 0}));
  EXPECT_FALSE(disturbed(0.030, {0.025, 0}));  // 5 ms
  EXPECT_FALSE(disturbed(0.005, {0, 0}));      // shorter than what the clocks tell
}

}  // namespace
}  // namespace pathrace::bench
