// Ants sign in rounds, each in a place of its own.
#include "algorithms/aco/roll_call.hpp"

#include <gtest/gtest.h>

namespace pathrace::algorithms {
namespace {

TEST(RollCall, KnowsWhoHasSignedInThisRound) {
  for (const std::size_t walkers : {1U, 2U, 3U, 7U, 300U}) {
    constexpr std::size_t ants = 200;  // several pages for some of these, not one whole page for others
    RollCall roll_call(ants, walkers);
    for (const std::uint32_t round : {1U, 2U}) {
      for (std::size_t next = 0; next < ants; ++next) {
        for (std::size_t ant = 0; ant < ants; ++ant) {
          ASSERT_EQ(roll_call.has(ant, round), ant < next) << walkers << ' ' << ant;
        }
        roll_call.sign(next, round);
      }
      EXPECT_FALSE(roll_call.has(0, round + 1));
    }
  }
}

}  // namespace
}  // namespace pathrace::algorithms
