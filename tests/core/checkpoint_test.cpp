#include "core/checkpoint.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/meter.hpp"

namespace pathrace {
namespace {

// Asks the process to stop for as long as it lives.
class StopRequest {
 public:
  StopRequest() { stop_requested.store(true); }
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;
  ~StopRequest() { stop_requested.store(false); }
};

Budget no_time() {
  Budget budget;
  budget.wall_s = 0;
  return budget;
}

TEST(Checkpoint, IsPassedOutsideOfTrialsAndWhileThereIsTime) {
  EXPECT_NO_THROW(checkpoint());
  const Meter meter({});
  const TrialScope scope(meter);
  EXPECT_NO_THROW(checkpoint());
}

TEST(Checkpoint, EndsATrialThatIsOutOfTime) {
  const Meter meter(no_time());
  {
    const TrialScope scope(meter);
    EXPECT_THROW(checkpoint(), OutOfTime);
  }
  EXPECT_TRUE(meter.timed());
  EXPECT_NO_THROW(checkpoint());  // the trial is over
}

TEST(Checkpoint, AsksTheInnermostTrial) {
  const Meter outer(no_time());
  const Meter inner({});
  const TrialScope outer_scope(outer);
  {
    const TrialScope inner_scope(inner);
    EXPECT_NO_THROW(checkpoint());
  }
  EXPECT_THROW(checkpoint(), OutOfTime);
}

TEST(Checkpoint, IsWhereWorkEndsOnceTheProcessIsAskedToStop) {
  const StopRequest stop;
  EXPECT_THROW(checkpoint(), Interrupted);
}

TEST(Checkpoint, EndsTheFillingOfLargeMemory) {
  const Meter meter(no_time());
  const TrialScope scope(meter);
  std::vector<int> values{1, 2, 3};
  EXPECT_THROW(assign_gradually(values, 1000, 7), OutOfTime);
}

TEST(Checkpoint, FillsAsAssignDoes) {
  for (const std::size_t count : {0U, 1U, 1048575U, 1048576U, 1048577U, 3000000U}) {  // portions: 2^20 ints
    std::vector<int> values{1, 2, 3};
    assign_gradually(values, count, 7);
    EXPECT_EQ(values, std::vector<int>(count, 7));
  }
}

TEST(Meter, IsOutOfTimeWithoutAnyLimitOnceTheProcessIsAskedToStop) {
  const Meter meter({});
  EXPECT_FALSE(meter.exhausted());
  EXPECT_FALSE(meter.interrupted());
  const StopRequest stop;
  EXPECT_FALSE(meter.interrupted());  // nobody was told to end
  EXPECT_TRUE(meter.out_of_time());
  EXPECT_TRUE(meter.exhausted());
  EXPECT_TRUE(meter.interrupted());
  EXPECT_FALSE(meter.timed());
}

TEST(Meter, WorkDoneBeforeAnybodyIsToldToEndIsNotInterrupted) {
  Budget one;
  one.evaluations = 1;
  Meter meter(one);
  meter.spend_evaluations(1);
  const StopRequest stop;
  EXPECT_TRUE(meter.exhausted());
  EXPECT_FALSE(meter.interrupted());
}

}  // namespace
}  // namespace pathrace
