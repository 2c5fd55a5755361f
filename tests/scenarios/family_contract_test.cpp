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

TEST_P(FamilyContract, EveryListedMapIsSolvableAndItsOptimumIsTheOracles) {
  const Library library;
  ASSERT_FALSE(family().library.empty());
  for (const std::string& id : family().library) {
    const Scenario scenario = library.load(id);
    EXPECT_EQ(scenario.id, id);
    EXPECT_NE(scenario.start, scenario.goal) << id;
    ASSERT_EQ(scenario.world != nullptr, family().dynamic) << id;
    if (scenario.world) continue;  // what moves has no shortest path
    ASSERT_TRUE(scenario.optimum.proven && scenario.optimum.length) << id;
    if (scenario.grid().width() > 10 && id.back() != '1') continue;  // the oracle is slow
    EXPECT_EQ(scenario.optimum.length,
              oracle_optimum(scenario.grid(), scenario.terrain.rule, scenario.start, scenario.goal))
        << id;
  }
}

TEST_P(FamilyContract, TheSameIdGivesTheSameScenarioAndAnotherListedIdAnother) {
  const Library library;
  std::set<std::uint64_t> contents;
  for (const std::string& id : family().library) {
    const std::uint64_t content = content_hash(library.load(id));
    EXPECT_EQ(content, content_hash(library.load(id))) << id;
    contents.insert(content);
  }
  EXPECT_EQ(contents.size(), family().library.size());
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

// "dense/20-30/1" -> "dense/n-30/seed".
std::string resized(const std::string& id, int n, int seed) {
  const std::size_t size = id.find('/') + 1;
  const std::size_t end = id.find_first_of("-/", size);
  return fmt::format("{}{}{}{}", id.substr(0, size), n, id.substr(end, id.rfind('/') + 1 - end), seed);
}

TEST_P(FamilyContract, EverySizeIsSolvableFromTheSmallestOn) {
  const Library library;
  if (family().parameters.empty() || family().dynamic) return;  // single maps; worlds have no sizes in cells
  for (const int n : {5, 6, 7, 8, 9, 10, 11, 13, 31, 64, 257}) {
    for (int seed = 0; seed < (n > 64 ? 2 : 20); ++seed) {
      const Scenario scenario = library.load(resized(family().library.back(), n, seed));
      EXPECT_EQ(scenario.grid().width(), n);
      EXPECT_EQ(scenario.grid().height(), n);
      EXPECT_TRUE(scenario.optimum.length.has_value());
    }
  }
}

// The id with one more parameter, spelled where it belongs.
std::string with(const std::string& id, const std::string& parameter) {
  std::string longer = id;
  return longer.insert(longer.rfind('/'), "," + parameter);
}

TEST_P(FamilyContract, EveryIntegerParameterWorksAtBothEndsOfItsRange) {
  const Library library;
  if (family().dynamic) return;
  for (const ParameterCard& card : family().parameters) {
    if (card.type != "integer" || card.name == "difficulty") continue;
    const std::size_t dots = card.range.find("..");
    for (const std::string& value : {card.range.substr(0, dots), card.range.substr(dots + 2)}) {
      for (const int n : {5, 6, 10, 20, 33}) {
        std::string id = resized(family().library.back(), n, 3);
        const std::size_t dash = id.find('-', id.find('/'));
        const bool is_main = family().form.find("-<" + card.name + ">") != std::string::npos;
        if (is_main) {
          id = fmt::format("{}{}/3", id.substr(0, dash + 1), value);
        } else if (value != card.default_value) {
          id = with(id, card.name + "=" + value);
        }
        EXPECT_TRUE(library.load(id).optimum.length.has_value()) << id;
      }
    }
  }
}

TEST_P(FamilyContract, EveryRuleOfEndsGivesTwoDifferentEnds) {
  const Library library;
  if (family().parameters.empty() || family().dynamic) return;
  const std::string id = resized(family().library.back(), 20, 4);
  for (const std::string ends : {"corners", "far", "random", "random,difficulty=90"}) {
    const Scenario scenario = library.load(with(id, "ends=" + ends));
    EXPECT_NE(scenario.start, scenario.goal) << id << ' ' << ends;
  }
}

}  // namespace
}  // namespace pathrace::scenarios
