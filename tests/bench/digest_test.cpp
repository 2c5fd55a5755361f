// The promise of determinism, on the smoke campaign: one digest for every backend, number of threads and
// jobs, after a kill and a resume, and in every build.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <thread>

#include "results/store.hpp"
#include "tests/support/process.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::bench {
namespace {

using testing::Finished;
using testing::run_program;
using testing::ScratchFolder;

// From running the code; every preset and compiler compares with it. A commit that moves it says so.
constexpr const char* smoke_digest = "6d0fb97511b5b0ec";

std::vector<std::string> smoke(const std::string& folder, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"run", "--campaign", "smoke", "--out", folder};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::string digest_of(const std::string& folder) {
  std::string text = run_program(PATHRACE_BINARY, {"digest", folder}).out;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

TEST(SmokeDigest, IsTheCommittedConstant) {
  const ScratchFolder scratch;
  const Finished run = run_program(PATHRACE_BINARY, smoke(scratch / "run"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(digest_of(scratch / "run"), smoke_digest);
}

TEST(SmokeDigest, IsTheSameForEveryBackendThreadsAndJobs) {
  const ScratchFolder scratch;
  int n = 0;
  for (const std::string& backend : testing::executors_under_test()) {
    for (const char* threads : {"1", "2", "4"}) {
      for (const char* jobs : {"1", "2"}) {
        const std::string folder = scratch / std::to_string(n++);
        const Finished run =
            run_program(PATHRACE_BINARY, {"run", "--campaign", "smoke", "--out", folder, "--backend", backend,
                                          "--threads", threads, "--jobs", jobs});
        ASSERT_EQ(run.exit_code, 0) << run.err;
        EXPECT_EQ(digest_of(folder), smoke_digest)
            << backend << ", " << threads << " threads, " << jobs << " jobs";
      }
    }
  }
}

TEST(SmokeDigest, AnotherSeedGivesAnother) {
  const ScratchFolder scratch;
  ASSERT_EQ(run_program(PATHRACE_BINARY, smoke(scratch / "run", {"--seed", "2"})).exit_code, 0);
  EXPECT_NE(digest_of(scratch / "run"), smoke_digest);
  EXPECT_EQ(digest_of(scratch / "run").size(), 16U);
}

// Waits until the run has recorded something, by looking at its store, and kills it.
std::uint64_t kill_in_the_middle(pid_t child, const std::string& folder) {
  std::uint64_t recorded = 0;
  while (recorded == 0 && waitpid(child, nullptr, WNOHANG) == 0) {
    std::this_thread::yield();
    if (!std::filesystem::exists(folder + "/results.db")) continue;
    try {
      recorded = results::Store::open(folder + "/results.db", results::Access::read).size();
    } catch (const std::exception&) {  // not there yet, or half made
    }
  }
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  return results::Store::open(folder + "/results.db", results::Access::read).size();
}

TEST(SmokeDigest, SurvivesAKillInTheMiddle) {
  // Smoke itself is over in a blink, and rows are written twice a second: a campaign of some seconds on the
  // same planners, once whole and once killed.
  const ScratchFolder scratch;
  constexpr int repetitions = testing::thread_sanitizer ? 4 : 25;  // instrumented code is slow
  constexpr std::uint64_t trials = 2 * 6 * repetitions;
  const std::string campaign = scratch.file("long.toml", fmt::format(R"([campaign]
name = "long"
repetitions = {}
[budget]
evaluations = 12000
[[planner]]
name = "as"
params = {{ dead_end = ["die", "backtrack"] }}
[[scenarios]]
select = ["dense/20-20/1..4", "trap-u/20/1..2"]
)",
                                                                     repetitions));
  const std::vector<std::string> serial{"--backend", "serial", "--jobs", "1"};
  const auto arguments = [&](const std::string& folder) {
    std::vector<std::string> all{"run", campaign, "--out", folder};
    all.insert(all.end(), serial.begin(), serial.end());
    return all;
  };
  const pid_t child = testing::start_program(PATHRACE_BINARY, arguments(scratch / "killed"));
  const std::uint64_t recorded = kill_in_the_middle(child, scratch / "killed");
  ASSERT_GT(recorded, 0U);
  ASSERT_LT(recorded, trials) << "the run was over before it could be killed";

  EXPECT_EQ(run_program(PATHRACE_BINARY, {"digest", scratch / "killed"}).exit_code, 0);
  EXPECT_EQ(run_program(PATHRACE_BINARY, {"leaderboard", scratch / "killed"}).exit_code, 0);
  const Finished resumed = run_program(PATHRACE_BINARY, {"run", "--resume", "--out", scratch / "killed",
                                                         "--backend", "threads", "--jobs", "2"});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_NE(resumed.err.find("recorded already"), std::string::npos) << resumed.err;

  ASSERT_EQ(run_program(PATHRACE_BINARY, arguments(scratch / "whole")).exit_code, 0);
  EXPECT_EQ(digest_of(scratch / "killed"), digest_of(scratch / "whole"));
}

}  // namespace
}  // namespace pathrace::bench
