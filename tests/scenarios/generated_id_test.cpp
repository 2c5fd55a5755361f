// The grammar of generated ids: size, main parameter, named parameters, seed.
#include <gtest/gtest.h>

#include <functional>

#include "core/error.hpp"
#include "scenarios/library.hpp"

namespace pathrace::scenarios {
namespace {

std::string fault_of(const std::string& id) {
  try {
    Library().load(id);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(GeneratedId, NamesParametersBehindTheSize) {
  const Library library;
  EXPECT_EQ(library.load("trap-u/20,depth=40/1").id, "trap-u/20,depth=40/1");
  EXPECT_EQ(library.load("maze/33-1,loops=20,ends=corners/5").start, (Cell{0, 0}));
}

TEST(GeneratedId, GivesOneQuestionOneSpelling) {
  EXPECT_EQ(fault_of("trap-u/20,mouth=30,depth=40/1"),
            "scenario 'trap-u/20,mouth=30,depth=40/1': one question has one id; write it as "
            "trap-u/20,depth=40,mouth=30/1");
  EXPECT_NE(fault_of("trap-u/20,depth=0/1").find("write it as trap-u/20/1"), std::string::npos);
  EXPECT_NE(fault_of("dense/20-020/1").find("write it as dense/20-20/1"), std::string::npos);
  EXPECT_NE(fault_of("trap-u/20,depth=040/1").find("write it as trap-u/20,depth=40/1"), std::string::npos);
}

TEST(GeneratedId, RefusesWhatItDoesNotKnowWithTheNearestName) {
  EXPECT_NE(fault_of("trap-u/20,dept=40/1").find("'depth'"), std::string::npos);
  EXPECT_NE(fault_of("trap-u/20,facing=eest/1").find("'east'"), std::string::npos);
  EXPECT_NE(fault_of("trap-u/20,depth/1").find("expected key=value, got 'depth'"), std::string::npos);
  EXPECT_NE(fault_of("trap-u/20,depth=30,depth=40/1").find("gives 'depth' twice"), std::string::npos);
  EXPECT_NE(fault_of("trap-u/20,depth=95/1").find("0..80, got '95'"), std::string::npos);
  EXPECT_NE(fault_of("dense/20-41/1").find("0..40, got '41'"), std::string::npos);
  EXPECT_NE(fault_of("dense/20/1").find("dense/<n>-<percent>"), std::string::npos);
  EXPECT_NE(fault_of("trap-u/20-5/1").find("trap-u/<n>["), std::string::npos);
  EXPECT_NE(fault_of("trap-u/4/1").find("5..4096, got '4'"), std::string::npos);
}

TEST(GeneratedId, RefusesADifficultyThatNothingUses) {
  EXPECT_NE(fault_of("caves/20-42,difficulty=80/1").find("needs ends=random"), std::string::npos);
  EXPECT_EQ(fault_of("caves/20-42,ends=random,difficulty=80/1"), "");
}

}  // namespace
}  // namespace pathrace::scenarios
