// The signature: one number per planner that any change of behaviour moves.
//
// The numbers come from running the code; they say nothing about right or wrong. A commit that moves one on
// purpose raises the planner's version and says so.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "core/hash.hpp"
#include "scenarios/library.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::testing {
namespace {

std::uint64_t signature(const std::string& call) {
  Budget budget;
  budget.evaluations = 200;
  budget.checks = 40000;
  const scenarios::Library library;
  Hasher hasher;
  for (const char* id :
       {"dense/10-30/1", "dense/20-20/1", "trap-l/20/1", "trap-u/20/2", "trap-pocket/20/3", "asr/fig6"}) {
    hasher.add(digest(run({call, budget}, library.load(id))));
  }
  return hasher.value();
}

const std::map<std::string, std::string>& known_signatures() {
  static const std::map<std::string, std::string> signatures = {
#include "tests/bench/signatures.inc"
#ifdef PATHRACE_OMPL
#include "tests/bench/signatures_ompl.inc"
#endif
  };
  return signatures;
}

class Signature : public ::testing::TestWithParam<std::string> {};

TEST_P(Signature, IsTheKnownOne) {
  const auto known = known_signatures().find(GetParam());
  ASSERT_NE(known, known_signatures().end())
      << GetParam() << " has no signature yet: " << hex(signature(GetParam()));
  EXPECT_EQ(hex(signature(GetParam())), known->second) << GetParam();
}

INSTANTIATE_TEST_SUITE_P(All, Signature, ::testing::ValuesIn(calls_under_test()));

TEST(Signatures, BelongToPlannersUnderTest) {
  const auto calls = calls_under_test();
  for (const auto& entry : known_signatures()) {
    EXPECT_NE(std::find(calls.begin(), calls.end(), entry.first), calls.end()) << entry.first;
  }
}

}  // namespace
}  // namespace pathrace::testing
