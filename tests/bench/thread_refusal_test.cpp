// A machine that grants no more threads: one line and exit code 3, whatever runs the loops. pthread_create is
// the one of tests/support/refuse_threads.cpp.
#include <gtest/gtest.h>

#include "tests/bench/command_line.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::bench {
namespace {

using testing::Finished;
using testing::ScratchFolder;

Finished with_threads(int live, std::vector<std::string> arguments) {
  std::vector<std::string> all{"LD_PRELOAD=" PATHRACE_REFUSE_THREADS,
                               "PATHRACE_LIVE_THREADS=" + std::to_string(live), PATHRACE_BINARY};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return testing::run_program("/usr/bin/env", all);
}

class ThreadRefusal : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (testing::instrumented) GTEST_SKIP() << "sanitizers want to be preloaded first";
  }
};

TEST_P(ThreadRefusal, EndsARunInOneLine) {
  const ScratchFolder scratch;
  for (const int live : {0, 1, 2, 3}) {
    SCOPED_TRACE(live);
    const Finished run = with_threads(live, {"run", "--campaign", "smoke", "--out", scratch / "run", "--jobs",
                                             "2", "--threads", "2", "--backend", GetParam()});
    expect_refusal(run, {"thread", "unavailable"}, 3);
  }
}

TEST_P(ThreadRefusal, EndsAPlanInOneLine) {
  expect_refusal(with_threads(0, {"plan", "--scenario", "trap-u/20/1", "--planner", "as", "--evaluations",
                                  "20", "--threads", "2", "--backend", GetParam()}),
                 {"thread", "unavailable"}, 3);
}

INSTANTIATE_TEST_SUITE_P(, ThreadRefusal, ::testing::Values("openmp", "tbb", "threads"),
                         [](const auto& backend) { return backend.param; });

TEST(ThreadRefusalOfTheRecorder, EndsARunInOneLine) {
  if (testing::instrumented) GTEST_SKIP() << "sanitizers want to be preloaded first";
  const ScratchFolder scratch;
  Finished run = with_threads(
      0, {"run", "--campaign", "smoke", "--out", scratch / "run", "--jobs", "1", "--backend", "serial"});
  run.err.erase(0, run.err.find('\n') + 1);  // what is to be run
  expect_refusal(run, {"thread", "unavailable"}, 3);
}

}  // namespace
}  // namespace pathrace::bench
