// Named sets: what they hold, and that it does not move.
#include "scenarios/sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/error.hpp"
#include "core/hash.hpp"

namespace pathrace::scenarios {
namespace {

TEST(Sets, KeepTheirBitsForEver) {
  // From running the code: a set that moves takes a new version of the library.
  const std::map<std::string, std::string> hashes = {
      {"starter", "b051b679d852326a"}, {"small", "903d003d7f3ddb43"}, {"traps", "c79483718afd99b6"},
      {"dense", "255959a1b0842129"},   {"large", "d4b11022680f1bb1"}, {"dynamic", "0e70173e1917cdf9"}};
  ASSERT_EQ(library_version, 1);
  const Library library;
  ASSERT_EQ(sets().size(), hashes.size());
  for (const ScenarioSet& set : sets()) {
    EXPECT_EQ(hex(hash_of(ids_of(set, library), library)), hashes.at(set.name)) << set.name;
  }
}

TEST(Sets, HoldNoScenarioTwice) {
  const Library library;
  for (const ScenarioSet& set : sets()) {
    const std::vector<std::string> ids = ids_of(set, library);
    EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size()) << set.name;
  }
}

TEST(Sets, OfTrapsAndDenseHoldAllThirtySeeds) {
  const Library library;
  EXPECT_EQ(ids_of(find_set("traps"), library).size(), 10U * 30U + 9U);
  EXPECT_EQ(ids_of(find_set("dense"), library).size(), 6U * 30U);
}

TEST(Sets, AreSelectedByTheirName) {
  const Library library;
  EXPECT_EQ(library.select("set/dense"), ids_of(find_set("dense"), library));
}

TEST(Sets, AnUnknownOneIsNamedWithItsNearestMatch) {
  try {
    Library().select("set/trap");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "unknown set 'trap'; the nearest match is 'traps'");
  }
}

}  // namespace
}  // namespace pathrace::scenarios
