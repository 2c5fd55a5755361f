// The contract of scenario families.
#include "scenarios/family.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "scenarios/library.hpp"
#include "tests/support/oracle.hpp"

namespace pathrace::scenarios {
namespace {

using testing::oracle_optimum;

class FamilyContract : public ::testing::TestWithParam<std::string> {
 protected:
  const Family& family() const {
    for (const Family& candidate : families()) {
      if (candidate.name == GetParam()) return candidate;
    }
    throw std::logic_error("no such family");
  }
};

TEST_P(FamilyContract, EveryListedScenarioIsSolvableAndItsOptimumIsTheOracles) {
  const Library library;
  ASSERT_FALSE(family().library.empty());
  for (const std::string& id : family().library) {
    const Scenario scenario = library.load(id);
    EXPECT_EQ(scenario.id, id);
    EXPECT_NE(scenario.start, scenario.goal) << id;
    ASSERT_TRUE(scenario.optimum.proven && scenario.optimum.length) << id;
    if (scenario.grid().width() > 10 && id.back() != '1') continue;  // the oracle is slow
    EXPECT_EQ(scenario.optimum.length,
              oracle_optimum(scenario.grid(), scenario.terrain.rule, scenario.start, scenario.goal))
        << id;
  }
}

TEST_P(FamilyContract, TheSameIdGivesTheSameScenarioAndAnotherIdAnother) {
  const Library library;
  std::set<std::uint64_t> contents;
  for (const std::string& id : family().library) {
    const std::uint64_t content = content_hash(library.load(id));
    EXPECT_EQ(content, content_hash(library.load(id))) << id;
    contents.insert(content);
  }
  EXPECT_GE(contents.size() * 10, family().library.size() * 9);  // two seeds may draw the same small map
}

TEST_P(FamilyContract, MalformedIdsAreRefusedWithTheFormOrTheRange) {
  const Library library;
  const std::string& name = family().name;
  for (const std::string& id :
       {name, name + "/", name + "/x/1", name + "/20", name + "/20-/1", name + "/-20/1", name + "/4/1",
        name + "/5000/1", name + "/020/1", name + "/20/1/2", name + "/20/x", name + "/20/-1",
        name + "/20/99999999999", name + "/20-20/1x"}) {
    EXPECT_THROW(library.load(id), InputError) << id;
  }
}

std::vector<std::string> family_names() {
  std::vector<std::string> names;
  for (const Family& family : families()) names.push_back(family.name);
  return names;
}

std::string test_name(const ::testing::TestParamInfo<std::string>& test) {
  std::string text = test.param;
  std::replace(text.begin(), text.end(), '-', '_');
  return text;
}

INSTANTIATE_TEST_SUITE_P(All, FamilyContract, ::testing::ValuesIn(family_names()), test_name);

TEST(Families, EverySizeIsSolvableFromTheSmallestOn) {
  const Library library;
  for (const char* form : {"dense/{}-30/{}", "trap-l/{}/{}", "trap-u/{}/{}", "trap-pocket/{}/{}"}) {
    for (const int n : {5, 6, 7, 8, 9, 13, 31, 64}) {
      for (int seed = 0; seed < 20; ++seed) {
        const Scenario scenario = library.load(fmt::format(fmt::runtime(form), n, seed));
        EXPECT_EQ(scenario.grid().width(), n);
        EXPECT_TRUE(scenario.optimum.length.has_value());
      }
    }
  }
}

TEST(Dense, BlocksExactlyItsShareOfTheCells) {
  const Library library;
  for (const int n : {5, 10, 20, 33}) {
    for (const int percent : {0, 1, 10, 20, 30, 40}) {
      const Scenario scenario = library.load(fmt::format("dense/{}-{}/7", n, percent));
      const std::int64_t blocked = n * n - scenario.grid().free_cells();
      EXPECT_EQ(blocked, (n * n * percent + 50) / 100) << n << ' ' << percent;
      EXPECT_EQ(scenario.start, (Cell{0, 0}));
      EXPECT_EQ(scenario.goal, (Cell{n - 1, n - 1}));
    }
  }
}

TEST(Traps, MakeTheWayLongerThanOverOpenGround) {
  const Library library;
  for (int seed = 1; seed <= 30; ++seed) {
    for (const char* kind : {"trap-u", "trap-l"}) {
      const Scenario scenario = library.load(fmt::format("{}/20/{}", kind, seed));
      const OccupancyGrid open(20, 20);
      const auto straight = oracle_optimum(open, MoveRule::strict, scenario.start, scenario.goal);
      EXPECT_GT(*scenario.optimum.length, *straight) << kind << ' ' << seed;
    }
  }
}

TEST(Asr, OptimaAreThoseOfThePaper) {
  const Library library;
  EXPECT_EQ(library.load("asr/fig2").optimum.length, (LatticeLength{4, 2}));  // 6.8284
  EXPECT_EQ(library.load("asr/fig5").optimum.length,
            (LatticeLength{2, 3}));  // 6.2426, the paper's 312.1 cm / 50
  EXPECT_EQ(library.load("asr/fig6").optimum.length, (LatticeLength{4, 2}));  // 6.8284
}

TEST(Library, KeepsItsBitsOnEveryMachine) {
  // From running the code: moves when a family draws anything else, which takes a new library version.
  const Library library;
  Hasher hasher;
  for (const std::string& id : library.list())
    hasher.add(std::string_view(id)).add(content_hash(library.load(id)));
  EXPECT_EQ(hex(hasher.value()), "e8c320ec5eef163f");
}

}  // namespace
}  // namespace pathrace::scenarios
