#include "core/meter.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "core/budget.hpp"

namespace pathrace {
namespace {

Budget evaluations(std::uint64_t count) {
  Budget budget;
  budget.evaluations = count;
  return budget;
}

Budget iterations(std::uint64_t count) {
  Budget budget;
  budget.iterations = count;
  return budget;
}

Budget checks(std::uint64_t count) {
  Budget budget;
  budget.checks = count;
  return budget;
}

Budget wall(double seconds) {
  Budget budget;
  budget.wall_s = seconds;
  return budget;
}

TEST(Budget, IsPrintedInTheOrderOfItsFields) {
  EXPECT_EQ(to_string(Budget{}), "none");
  EXPECT_EQ(to_string(evaluations(5000)), "evaluations=5000");
  EXPECT_EQ(to_string(Budget{5000, 7, 200000, 1.5}),
            "evaluations=5000,iterations=7,checks=200000,wall_s=1.5");
  EXPECT_EQ(to_string(Budget{{}, {}, 3, 0.25}), "checks=3,wall_s=0.25");
}

TEST(Budget, IsUnlimitedOnlyWithoutAnyLimit) {
  EXPECT_TRUE(Budget{}.unlimited());
  for (const Budget& budget : {evaluations(0), iterations(0), checks(0), wall(0)}) {
    EXPECT_FALSE(budget.unlimited()) << to_string(budget);
  }
}

TEST(Budget, EachWorkLimitChangesTheWorkHash) {
  const std::set<std::uint64_t> hashes = {
      work_hash({}),
      work_hash(evaluations(0)),
      work_hash(evaluations(9)),
      work_hash(iterations(0)),
      work_hash(iterations(9)),
      work_hash(checks(0)),
      work_hash(checks(9)),
  };
  EXPECT_EQ(hashes.size(), 7U);
}

TEST(Budget, AWallLimitIsNoPartOfTheWorkHash) {
  EXPECT_EQ(work_hash(wall(3)), work_hash({}));
  EXPECT_EQ(work_hash(Budget{5, {}, {}, 3}), work_hash(Budget{5, {}, {}, {}}));
}

TEST(Meter, WithoutLimitsIsNeverExhausted) {
  Meter meter({});
  meter.spend_evaluations(1000000);
  meter.spend_checks(1000000);
  for (int i = 0; i < 1000; ++i) meter.end_iteration();
  EXPECT_FALSE(meter.exhausted());
  EXPECT_FALSE(meter.spent());
  EXPECT_FALSE(meter.exceeded());
  EXPECT_FALSE(meter.timed());
  EXPECT_EQ(meter.evaluations_left(), Meter::unlimited);
  EXPECT_EQ(meter.checks_left(), Meter::unlimited);
  EXPECT_EQ(meter.admitted(123), 123U);
  EXPECT_EQ(meter.work(), (Work{1000000, 1000, 1000000}));
}

TEST(Meter, IsExhaustedExactlyWhenALimitIsReached) {
  Meter by_evaluations(evaluations(3));
  by_evaluations.spend_evaluations(2);
  EXPECT_FALSE(by_evaluations.exhausted());
  by_evaluations.spend_evaluations(1);
  EXPECT_TRUE(by_evaluations.exhausted());
  EXPECT_TRUE(by_evaluations.spent());

  Meter by_iterations(iterations(2));
  by_iterations.end_iteration();
  EXPECT_FALSE(by_iterations.exhausted());
  by_iterations.end_iteration();
  EXPECT_TRUE(by_iterations.exhausted());

  Meter by_checks(checks(10));
  by_checks.spend_checks(9);
  EXPECT_FALSE(by_checks.exhausted());
  by_checks.spend_checks(1);
  EXPECT_TRUE(by_checks.exhausted());
}

TEST(Meter, WhicheverLimitComesFirstEndsTheTrial) {
  Meter meter(Budget{100, 100, 5, {}});
  meter.spend_evaluations(1);
  meter.spend_checks(5);
  EXPECT_TRUE(meter.exhausted());
}

TEST(Meter, ABudgetOfNothingIsExhaustedAtOnce) {
  EXPECT_TRUE(Meter(evaluations(0)).exhausted());
  EXPECT_TRUE(Meter(iterations(0)).exhausted());
  EXPECT_TRUE(Meter(checks(0)).exhausted());
}

TEST(Meter, CutsTheLastBatchSoThatTheBudgetIsNeverExceeded) {
  Meter meter(evaluations(50));
  std::uint64_t batches = 0;
  while (!meter.exhausted()) {
    meter.spend_evaluations(meter.admitted(20));
    ++batches;
  }
  EXPECT_EQ(batches, 3U);  // 20, 20, 10
  EXPECT_EQ(meter.work().evaluations, 50U);
  EXPECT_EQ(meter.admitted(20), 0U);
  EXPECT_FALSE(meter.exceeded());
}

TEST(Meter, HasNothingLeftRatherThanAHugeNumberWhenOverspent) {
  Meter meter(Budget{5, {}, 5, {}});
  meter.spend_evaluations(7);
  meter.spend_checks(7);
  EXPECT_EQ(meter.evaluations_left(), 0U);
  EXPECT_EQ(meter.checks_left(), 0U);
  EXPECT_EQ(meter.admitted(1), 0U);
}

TEST(Meter, SeesWhenAPlannerBrokeAnyLimit) {
  Meter by_evaluations(evaluations(5));
  by_evaluations.spend_evaluations(5);
  EXPECT_FALSE(by_evaluations.exceeded());
  by_evaluations.spend_evaluations(1);
  EXPECT_TRUE(by_evaluations.exceeded());

  Meter by_iterations(iterations(0));
  EXPECT_FALSE(by_iterations.exceeded());
  by_iterations.end_iteration();
  EXPECT_TRUE(by_iterations.exceeded());

  Meter by_checks(checks(5));
  by_checks.spend_checks(6);
  EXPECT_TRUE(by_checks.exceeded());
}

TEST(Meter, AWallLimitOfZeroIsOverAtOnceAndMarksTheTrialTimed) {
  const Meter meter(wall(0));
  EXPECT_FALSE(meter.timed());  // nobody has looked at the clock yet
  EXPECT_FALSE(meter.spent());
  EXPECT_TRUE(meter.out_of_time());
  EXPECT_TRUE(meter.timed());
  EXPECT_TRUE(meter.spent());
  EXPECT_TRUE(meter.exhausted());
  EXPECT_FALSE(meter.exceeded());
}

TEST(Meter, AWorkLimitThatComesFirstDoesNotMarkTheTrialTimed) {
  Meter meter(Budget{1, {}, {}, 0.0});
  meter.spend_evaluations(1);
  EXPECT_TRUE(meter.exhausted());
  EXPECT_FALSE(meter.timed());
}

TEST(Meter, WithAnHourLeftIsNotOutOfTime) {
  const Meter meter(wall(3600));
  EXPECT_FALSE(meter.out_of_time());
  EXPECT_FALSE(meter.exhausted());
  EXPECT_FALSE(meter.timed());
}

TEST(Meter, TheTraceStrictlyFallsAndCarriesTheWorkDone) {
  Meter meter({});
  meter.spend_evaluations(1);
  meter.improved(10);
  meter.spend_evaluations(1);
  meter.spend_checks(4);
  meter.improved(10);  // no better
  meter.improved(12);  // worse
  meter.end_iteration();
  meter.improved(9.5);
  ASSERT_EQ(meter.trace().size(), 2U);
  EXPECT_EQ(meter.trace()[0].cost, 10.0);
  EXPECT_EQ(meter.trace()[0].work, (Work{1, 0, 0}));
  EXPECT_EQ(meter.trace()[1].cost, 9.5);
  EXPECT_EQ(meter.trace()[1].work, (Work{2, 1, 4}));
  EXPECT_GE(meter.trace()[0].wall_s, 0.0);
  EXPECT_GE(meter.trace()[1].wall_s, meter.trace()[0].wall_s);
}

// A cost that is no number would be a first improvement that nothing can beat.
TEST(Meter, ACostThatIsNotFiniteIsNoImprovement) {
  Meter meter({});
  meter.improved(std::numeric_limits<double>::quiet_NaN());
  meter.improved(std::numeric_limits<double>::infinity());
  EXPECT_TRUE(meter.trace().empty());
  meter.improved(5);
  meter.improved(std::numeric_limits<double>::quiet_NaN());
  meter.improved(4);
  ASSERT_EQ(meter.trace().size(), 2U);
  EXPECT_EQ(meter.trace()[1].cost, 4.0);
}

TEST(Meter, APlannerMayConcludeBeforeItsBudgetIsSpent) {
  Meter meter(evaluations(5));
  EXPECT_FALSE(meter.concluded());
  meter.conclude();
  EXPECT_TRUE(meter.concluded());
  EXPECT_FALSE(meter.spent());
}

}  // namespace
}  // namespace pathrace
