// The genetic algorithm of the AS-R robot: the paper's maps, its budget, and what the extensions promise.
#include <gtest/gtest.h>

#include "core/gap.hpp"
#include "scenarios/library.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::testing {
namespace {

const std::string any_map =
    "xie2010:insertion=general,repair=local_search,initial_genes=8,mutation=stretch,mutation_rate=0.5";

Budget evaluations(std::uint64_t count) {
  Budget budget;
  budget.evaluations = count;
  return budget;
}

int optima(const std::string& call, const std::string& id) {
  const Scenario scenario = scenarios::Library().load(id);
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    TrialSetting setting{call};
    setting.seed = seed;
    const TrialRecord record = run(setting, scenario);
    if (record.verdict != Verdict::solved) continue;
    found += record.metrics->lattice == scenario.optimum.length ? 1 : 0;
  }
  return found;
}

TEST(Xie2010, FindsTheOptimaOfThePapersMapsWithThePapersParameters) {
  for (const char* id : {"asr/fig2", "asr/fig5", "asr/fig6"}) {
    EXPECT_GE(optima("xie2010", id), 90) << id;
    EXPECT_GE(optima("xie2010:insertion=general", id), 90) << id;
  }
}

TEST(Xie2010, ReadsTheOpenPointsOfThePaperInMoreThanOneWayWithTheSameOutcome) {
  for (const char* reading : {"insertion=blind", "first_generation=repaired", "crossover=free",
                              "tournament=3", "elitism=false", "refills=0"}) {
    for (const char* id : {"asr/fig2", "asr/fig5", "asr/fig6"}) {
      EXPECT_GE(optima(std::string("xie2010:") + reading, id), 90) << id << ' ' << reading;
    }
  }
}

TEST(Xie2010, TheDefaultBudgetIsTenGenerationsOfTwentyAfterTheFirst) {
  const TrialRecord record = run({"xie2010"}, scenarios::Library().load("asr/fig5"));
  EXPECT_EQ(record.work.iterations, 10U);
  EXPECT_EQ(record.work.evaluations, 220U);
}

TEST(Xie2010, SpendsItsEvaluationsToTheLastOne) {
  for (const char* id : {"asr/fig2", "dense/20-20/1"}) {
    const Scenario scenario = scenarios::Library().load(id);
    for (const std::uint64_t count : {1U, 19U, 20U, 21U, 40U, 219U, 777U}) {
      for (const std::string& call : {std::string("xie2010"), any_map, std::string("xie2010:population=1")}) {
        EXPECT_EQ(run({call, evaluations(count)}, scenario).work.evaluations, count) << call << ' ' << id;
      }
    }
  }
}

TEST(Xie2010, DeletedIndividualsAreEvaluationsToo) {
  // The start cannot be left to the right or down: every individual and each of its refills is deleted.
  const Scenario scenario = scenario_of({grid_of({"...", ".##", "..#", "#.."}), {0, 2}, {2, 0}});
  Budget one_generation;
  one_generation.iterations = 1;
  const TrialRecord record = run({"xie2010:population=4,refills=3", one_generation}, scenario);
  EXPECT_EQ(record.verdict, Verdict::budget);
  EXPECT_EQ(record.work.evaluations, 4U + 4U * (1U + 3U));
  ASSERT_FALSE(record.counters.empty());
  EXPECT_EQ(record.counters.front(), (Counter{"deleted", 16}));
}

TEST(Xie2010, StepsRightAndDownOnlySolveWhatNeedsNoOthers) {
  // The goal lies to the upper left of the start: out of the paper's scope, and within general's. (On a map
  // of a few cells a random chromosome may happen to be a path.)
  const Scenario back = scenario_of({OccupancyGrid(20, 20), {19, 19}, {0, 0}});
  EXPECT_EQ(run({"xie2010"}, back).verdict, Verdict::budget);
  EXPECT_EQ(run({"xie2010:insertion=general"}, back).verdict, Verdict::solved);
  const Scenario trap = scenarios::Library().load("curated/trap-u-east-20");
  EXPECT_EQ(run({"xie2010", evaluations(500)}, trap).verdict, Verdict::budget);
  EXPECT_EQ(run({any_map, evaluations(500)}, trap).verdict, Verdict::solved);
}

TEST(Xie2010, WithDetoursOfAnyLengthAnswersWheneverThereIsAWay) {
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Question question = random_question(Stream(311).fork(i), 12, 0.4);
    for (const MoveRule rule : all_rules) {
      const TrialRecord record = run({any_map, evaluations(60)}, scenario_of(question, rule));
      EXPECT_EQ(record.verdict == Verdict::solved,
                oracle_reachable(question.grid, rule, question.start, question.goal))
          << i << ' ' << name(rule) << ": " << record.note;
    }
  }
}

TEST(Xie2010, IsNearTheOptimumOnMapsOfTwentyCellsASide) {
  const scenarios::Library library;
  for (const std::string family : {"dense/20-20/", "dense/20-30/", "trap-u/20/"}) {
    int close = 0;
    for (int seed = 1; seed <= 10; ++seed) {
      const Scenario scenario = library.load(family + std::to_string(seed));
      const TrialRecord record = run({any_map, evaluations(5000)}, scenario);
      ASSERT_EQ(record.verdict, Verdict::solved) << scenario.id;
      close += *gap(*record.metrics, scenario.optimum) < 0.1 ? 1 : 0;
    }
    EXPECT_GE(close, 8) << family;
  }
}

TEST(Xie2010, GivesTheSameRecordOnEveryExecutorAndNumberOfThreads) {
  // 200 individuals of some thirty cells are divided among threads; 20 are not worth it.
  const std::string many = any_map + ",population=200";
  for (const std::string& call : {std::string("xie2010:population=600"), any_map, many}) {
    for (const char* id : {"asr/fig5", "trap-u/20/3"}) {
      const Scenario scenario = scenarios::Library().load(id);
      Budget cut = evaluations(1300);
      cut.checks = 10'000;  // ends in the middle of a generation
      for (const Budget& budget : {evaluations(1301), cut}) {
        const std::uint64_t expected = digest(run({call, budget}, scenario));
        for (const std::string& backend : executors_under_test()) {
          for (const int threads : {1, 2, 4}) {
            EXPECT_EQ(digest(run({call, budget, backend, threads}, scenario)), expected)
                << call << ' ' << id << ' ' << backend << ' ' << threads;
          }
        }
      }
    }
  }
}

TEST(Xie2010, EachOperatorChangesTheSearch) {
  const Scenario scenario = scenarios::Library().load("dense/20-20/2");
  const std::uint64_t expected = digest(run({any_map, evaluations(1000)}, scenario));
  for (const char* change : {"crossover_rate=0", "elitism=false", "tournament=1", "crossover=free",
                             "first_generation=repaired", "reach=1", "population=21"}) {
    EXPECT_NE(digest(run({any_map + "," + change, evaluations(1000)}, scenario)), expected) << change;
  }
}

}  // namespace
}  // namespace pathrace::testing
