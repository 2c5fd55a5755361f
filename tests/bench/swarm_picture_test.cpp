// Pictures of a swarm that steers: where its particles were, step by step and over a whole run.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/support/process.hpp"

namespace pathrace::bench {
namespace {

using testing::Finished;
using testing::run_program;
using testing::ScratchFolder;

std::string svg_of_run(const std::string& planner, const std::string& steps) {
  const ScratchFolder scratch;
  const Finished finished =
      run_program(PATHRACE_BINARY, {"plan", "--scenario", "discs/ring/1", "--planner", planner,
                                    "--iterations", steps, "--svg", scratch / "run.svg"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  std::ostringstream text;
  text << std::ifstream(scratch / "run.svg").rdbuf();
  return text.str();
}

std::size_t count(const std::string& text, const std::string& piece) {
  std::size_t found = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++found;
  return found;
}

// Seven swarms of 30 are drawn per step: at birth and after 1, 2, 4, 8, 16 and 32 iterations.
TEST(SwarmPicture, ShowsEveryParticleDrawnInAStep) {
  EXPECT_EQ(count(svg_of_run("nasrollahy2009", "1"), "r=\"1.6\""), 210U);
  EXPECT_EQ(count(svg_of_run("straight", "1"), "r=\"1.6\""), 0U);
}

TEST(SwarmPicture, ShowsALongRunWithFinerDotsAndEverySecondParticleFrom10000On) {
  EXPECT_EQ(count(svg_of_run("nasrollahy2009", "40"), "r=\"0.8\""), 40U * 210U);
  EXPECT_EQ(count(svg_of_run("nasrollahy2009", "60"), "r=\"0.8\""), 60U * 210U / 2);
}

}  // namespace
}  // namespace pathrace::bench
