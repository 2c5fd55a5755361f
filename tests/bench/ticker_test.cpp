#include "bench/ticker.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include "tests/bench/command_line.hpp"
#include "tests/support/running.hpp"

namespace pathrace::bench {
namespace {

using testing::Running;

TEST(Ticker, TellsWhatIsLimitedAndWhatIsCounted) {
  Budget budget;
  budget.evaluations = 5000;
  Meter meter(budget);
  EXPECT_EQ(describe_progress(meter), "plans, 0.0 s gone, 0 of 5000 evaluations");
  meter.spend_evaluations(3200);
  meter.spend_checks(70000);
  meter.end_iteration();
  meter.improved(31.414);
  EXPECT_EQ(describe_progress(meter),
            "plans, 0.0 s gone, 3200 of 5000 evaluations, 1 iterations, 70000 checks, best 31.41");
}

TEST(Ticker, TellsTheWallLimit) {
  Budget budget;
  budget.wall_s = 90;
  EXPECT_EQ(describe_progress(Meter(budget)), "plans, 0.0 s gone of 90 s");
}

std::vector<std::string> long_plan() {
  return {"plan",          "--scenario", "dense/20-20/7", "--planner", "as",
          "--evaluations", "1000000000", "--backend",     "serial"};
}

TEST(Ticker, ALongPlanOnATerminalShowsHowItGetsOn) {
  Running plan(PATHRACE_BINARY, long_plan(), Running::Stderr::terminal);
  EXPECT_TRUE(plan.says(" of 1000000000 evaluations")) << plan.err();
  EXPECT_TRUE(plan.says(", best ")) << plan.err();
  EXPECT_EQ(plan.err().find('\n'), std::string::npos) << plan.err();  // one line that renews itself
}

TEST(Ticker, ALongPlanElsewhereIsSilent) {
  Running plan(PATHRACE_BINARY, long_plan());
  ASSERT_TRUE(plan.works(2));  // on one thread: as long as that at least
  plan.send(SIGTERM);
  plan.wait();
  EXPECT_EQ(plan.err(), "");
}

}  // namespace
}  // namespace pathrace::bench
