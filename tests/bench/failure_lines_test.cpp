// What a run says about its failures when it ends.
#include "bench/failure_lines.hpp"

#include <gtest/gtest.h>

namespace pathrace::bench {
namespace {

using Lines = std::vector<std::string>;

TEST(FailureLines, AreEmptyWhereAllIsWell) {
  EXPECT_EQ(failure_lines({}), Lines{});
  EXPECT_EQ(failure_lines({{"a", Verdict::solved, false, 9},
                           {"a", Verdict::budget, false, 9},
                           {"b", Verdict::no_path, false, 9},
                           {"c", Verdict::unsupported, true, 9}}),
            Lines{});
}

TEST(FailureLines, CountEachVerdictAndNameItsPlanners) {
  EXPECT_EQ(failure_lines({{"a", Verdict::crashed, true, 1},
                           {"a", Verdict::solved, false, 100},
                           {"b", Verdict::crashed, true, 2},
                           {"b", Verdict::crashed, false, 3},
                           {"b", Verdict::out_of_memory, true, 7},
                           {"c", Verdict::gave_up, false, 24}}),
            Lines{"trials without a result: gave up 24 (c 24), out of memory 7 (b 7), crashed 6 (b 5, a 1)"});
}

TEST(FailureLines, NameTheWorstPlannersOfMany) {
  EXPECT_EQ(failure_lines({{"a", Verdict::invalid, true, 1},
                           {"b", Verdict::invalid, true, 6},
                           {"c", Verdict::invalid, true, 2},
                           {"d", Verdict::invalid, true, 4},
                           {"e", Verdict::invalid, true, 5},
                           {"f", Verdict::invalid, true, 3}}),
            Lines{"trials without a result: invalid 21 (b 6, e 5, d 4, f 3 and 2 more)"});
}

TEST(FailureLines, WarnOfClaimsAgainstAProof) {
  EXPECT_EQ(failure_lines({{"a", Verdict::gave_up, true, 3}, {"a", Verdict::gave_up, false, 2}}),
            (Lines{"trials without a result: gave up 5 (a 5)",
                   "warning: claims that there is no way where one is proven: 3 (a 3)"}));
}

}  // namespace
}  // namespace pathrace::bench
