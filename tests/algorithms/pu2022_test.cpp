// The grouped-teaching colony: what it is with everything off, and what its parts promise.
#include <gtest/gtest.h>

#include <cstdlib>

#include "scenarios/library.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::testing {
namespace {

const std::string everything_off = "update=all_ants,simplify=false,teaching=none,dead_table=none";

Budget evaluations(std::uint64_t count) {
  Budget budget;
  budget.evaluations = count;
  return budget;
}

TEST(Pu2022, WithEverythingOffIsAntSystemBitForBit) {
  const scenarios::Library library;
  for (const char* id : {"dense/20-20/2", "dense/20-30/5", "trap-u/20/1", "trap-l/20/4"}) {
    for (const std::string dead_end : {"die", "backtrack", "revisit_with_loop_erasure"}) {
      const Scenario scenario = library.load(id);
      const TrialRecord as = run({"as:dead_end=" + dead_end, evaluations(600)}, scenario);
      const TrialRecord pu =
          run({"pu2022:" + everything_off + ",dead_end=" + dead_end, evaluations(600)}, scenario);
      EXPECT_EQ(digest(pu), digest(as)) << id << ' ' << dead_end;
      EXPECT_EQ(pu.answer, as.answer);
      EXPECT_EQ(pu.work, as.work);
    }
  }
}

TEST(Pu2022, EachPartAloneChangesTheSearch) {
  const Scenario scenario = scenarios::Library().load("trap-u/20/2");
  const std::uint64_t off = digest(run({"pu2022:" + everything_off, evaluations(600)}, scenario));
  for (const char* one :
       {"simplify=false,teaching=none,dead_table=none", "update=all_ants,teaching=none,dead_table=none",
        "update=all_ants,simplify=false,dead_table=none",
        "update=all_ants,simplify=false,teaching=parameters,dead_table=none",
        "update=all_ants,simplify=false,teaching=none"}) {
    EXPECT_NE(digest(run({"pu2022:" + std::string(one), evaluations(600)}, scenario)), off) << one;
  }
}

TEST(Pu2022, AnswersWheneverThereIsAWayForObstaclesNeverCutTheGoalOff) {
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Question question = random_question(Stream(157).fork(i), 12, 0.4);
    for (const MoveRule rule : all_rules) {
      const bool reachable = oracle_reachable(question.grid, rule, question.start, question.goal);
      for (const char* variant :
           {"", ":dead_table=global_literal", ":teaching=parameters", ":teaching=none"}) {
        const TrialRecord record =
            run({std::string("pu2022") + variant, evaluations(150)}, scenario_of(question, rule));
        EXPECT_EQ(record.verdict == Verdict::solved, reachable)
            << i << ' ' << name(rule) << variant << ": " << record.note;
      }
    }
  }
}

TEST(Pu2022, LessonsAreEvaluationsAndTheBudgetIsSpentToTheLastOne) {
  const Scenario scenario = scenarios::Library().load("dense/20-10/1");
  for (const std::uint64_t count : {1U, 49U, 60U, 124U, 125U, 126U, 777U}) {
    EXPECT_EQ(run({"pu2022", evaluations(count)}, scenario).work.evaluations, count);
  }
  // 50 walks, of the average half 25 lessons and from peers 50.
  Budget one_iteration;
  one_iteration.iterations = 1;
  EXPECT_EQ(run({"pu2022", one_iteration}, scenario).work.evaluations, 125U);
  EXPECT_EQ(run({"pu2022:grouping=false", one_iteration}, scenario).work.evaluations, 149U);
  EXPECT_EQ(run({"pu2022:teaching=none", one_iteration}, scenario).work.evaluations, 50U);
}

TEST(Pu2022, ItsAnswerHasNoRedundantCorner) {
  const scenarios::Library library;
  for (int seed = 1; seed <= 30; ++seed) {
    for (const char* family : {"dense/20-20/", "trap-u/20/"}) {
      const Scenario scenario = library.load(family + std::to_string(seed));
      // One iteration, whose best has often just been taught, or a few.
      const TrialRecord record = run({"pu2022:ants=20", evaluations(seed <= 20 ? 50 : 300)}, scenario);
      ASSERT_EQ(record.verdict, Verdict::solved);
      const std::vector<Point>& points = record.answer->points;
      for (std::size_t k = 2; k < points.size(); ++k) {
        const Cell a{static_cast<int>(points[k - 2].x), static_cast<int>(points[k - 2].y)};
        const Cell c{static_cast<int>(points[k].x), static_cast<int>(points[k].y)};
        EXPECT_FALSE(oracle_step(scenario.grid(), MoveRule::strict, a, c)) << scenario.id;
      }
    }
  }
}

TEST(Pu2022AnyAngle, IsTheSameSearchWithAnAnswerThatIsNeverLonger) {
  const scenarios::Library library;
  int shorter = 0;
  for (int seed = 1; seed <= 10; ++seed) {
    const Scenario scenario = library.load("dense/20-20/" + std::to_string(seed));
    const TrialRecord lattice = run({"pu2022", evaluations(500)}, scenario);
    const TrialRecord straight = run({"pu2022-any-angle", evaluations(500)}, scenario);
    ASSERT_EQ(straight.verdict, Verdict::solved) << straight.note;
    EXPECT_EQ(straight.work, lattice.work);
    EXPECT_LE(straight.metrics->length, lattice.metrics->length + 1e-9);
    shorter += straight.metrics->length < lattice.metrics->length - 1e-9 ? 1 : 0;
  }
  EXPECT_EQ(shorter, 10);  // every lattice path with a turn by 45 degrees in the open
  const Scenario squeezing = scenario_of({grid_of({".#", "#."}), {0, 0}, {1, 1}}, MoveRule::free);
  EXPECT_EQ(run({"pu2022-any-angle"}, squeezing).verdict, Verdict::unsupported);
}

TEST(Pu2022, WithFullEvaporationOnlyTheReinforcedPathCarriesPheromone) {
  // After one iteration the best so far is the iteration's best, and nothing else has been paid.
  const scenarios::Library library;
  Budget one_iteration;
  one_iteration.iterations = 1;
  const std::string call = "pu2022:teaching=none,simplify=false,dead_table=none,evaporation=1,answer=";
  for (int seed = 1; seed <= 10; ++seed) {
    const Scenario scenario = library.load("dense/20-20/" + std::to_string(seed));
    EXPECT_EQ(run({call + "argmax_pheromone", one_iteration}, scenario).answer,
              run({call + "best_so_far", one_iteration}, scenario).answer);
  }
}

TEST(Pu2022, GivesTheSameRecordOnEveryExecutor) {
  const Scenario scenario = scenarios::Library().load("trap-u/20/3");
  for (const char* variant :
       {"dead_table=none", "dead_table=global_literal", "dead_table=global_dominated", "teaching=none",
        "teaching=parameters", "teaching=parameters,grouping=false", "grouping=false"}) {
    const std::string call = std::string("pu2022:") + variant;
    const std::uint64_t expected = digest(run({call, evaluations(500)}, scenario));
    for (const std::string& backend : executors_under_test()) {
      for (const int threads : {1, 2, 4}) {
        EXPECT_EQ(digest(run({call, evaluations(500), backend, threads}, scenario)), expected)
            << variant << ' ' << backend << ' ' << threads;
      }
    }
  }
}

}  // namespace
}  // namespace pathrace::testing
