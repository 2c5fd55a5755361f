// What OMPL demands of its planners' parameters: RRTstar.cpp, ImplicitGraph.cpp (BIT*) and the setup() of
// KPIECE log or throw where these rules are broken, or the planner crashes.
#ifdef PATHRACE_OMPL

#include <gtest/gtest.h>

#include "scenarios/library.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::testing {
namespace {

std::string refusal(const std::string& call) {
  try {
    bench::roster().enter(parse_call(call));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(OmplConstraints, OrderedSamplesComeFromAnInformedOrARejectingSampler) {
  EXPECT_EQ(refusal("ompl-rrt-star:ordered_sampling=true"),
            "planner 'ompl-rrt-star': ordered_sampling=true and informed_sampling=false and "
            "sample_rejection=false and focus_search=false contradict each other: ordered_sampling needs "
            "informed_sampling, sample_rejection or focus_search");
  const Scenario scenario = scenarios::Library().load("dense/20-20/1");
  Budget budget;
  budget.evaluations = 300;
  for (const char* other : {"informed_sampling", "sample_rejection", "focus_search"}) {
    const std::string call = std::string("ompl-rrt-star:ordered_sampling=true,") + other + "=true";
    EXPECT_NE(run({call, budget}, scenario).verdict, Verdict::crashed) << call;
  }
  EXPECT_EQ(refusal("ompl-informed-rrt-star:ordered_sampling=true"), "accepted");
}

TEST(OmplConstraints, SwitchesThatExcludeOrNeedEachOther) {
  for (const char* call :
       {"ompl-rrt-star:sample_rejection=true,informed_sampling=true",
        "ompl-rrt-star:sample_rejection=true,focus_search=true",
        "ompl-rrt-sharp:sample_rejection=true,informed_sampling=true",
        "ompl-rrtx:sample_rejection=true,informed_sampling=true", "ompl-rrt-star:pruned_measure=true",
        "ompl-rrt-star:pruned_measure=true,tree_pruning=true",
        "ompl-rrt-star:pruned_measure=true,informed_sampling=true",
        "ompl-bit-star:drop_unconnected_samples_on_prune=true,use_graph_pruning=false",
        "ompl-stride:min_degree=17", "ompl-stride:max_degree=15", "ompl-stride:degree=11",
        "ompl-spars2:dense_delta_fraction=0.1,sparse_delta_fraction=0.05"}) {
    EXPECT_NE(refusal(call).find(" contradict each other: "), std::string::npos) << call;
  }
  for (const char* call : {"ompl-rrt-star:sample_rejection=true", "ompl-rrt-star:focus_search=true",
                           "ompl-rrt-star:pruned_measure=true,informed_sampling=true,tree_pruning=true",
                           "ompl-rrt-star:pruned_measure=true,focus_search=true",
                           "ompl-bit-star:drop_unconnected_samples_on_prune=true",
                           "ompl-stride:min_degree=4,degree=4,max_degree=4",
                           "ompl-spars2:dense_delta_fraction=0.1,sparse_delta_fraction=0.1"}) {
    EXPECT_EQ(refusal(call), "accepted") << call;
  }
}

TEST(OmplConstraints, SharesThatTheLibraryRefusesInSetupAreOutOfRange) {
  for (const char* planner : {"ompl-kpiece", "ompl-bkpiece", "ompl-lbkpiece"}) {
    for (const char* value : {"0", "1.5"}) {
      EXPECT_NE(refusal(std::string(planner) + ":min_valid_path_fraction=" + value).find("[1e-06, 1]"),
                std::string::npos)
          << planner;
      EXPECT_NE(refusal(std::string(planner) + ":border_fraction=" + value).find("[1e-06, 1]"),
                std::string::npos)
          << planner;
    }
  }
  EXPECT_EQ(refusal("ompl-stride:min_valid_path_fraction=0"), "accepted");
}

TEST(OmplConstraints, SamplingJustInTimeIsRefusedForTheLibraryWouldIgnoreIt) {
  for (const char* call : {"ompl-bit-star:use_just_in_time_sampling=true",
                           "ompl-abit-star:use_just_in_time_sampling=true,use_k_nearest=false"}) {
    EXPECT_NE(
        refusal(call).find("use_just_in_time_sampling=true: use_just_in_time_sampling is not supported"),
        std::string::npos)
        << refusal(call);
  }
}

// A sample is an evaluation at least, so that no batch is larger than the budget.
TEST(OmplConstraints, ABatchBeyondTheBudgetGivesTheSameRecordHoweverLargeItIs) {
  const Scenario scenario = scenarios::Library().load("dense/20-20/1");
  Budget budget;
  budget.evaluations = 150;
  for (const std::string parameter : {"ompl-bit-star:samples_per_batch=", "ompl-abit-star:samples_per_batch=",
                                      "ompl-fmt-star:num_samples=", "ompl-bfmt-star:num_samples="}) {
    const TrialRecord large = run({parameter + "1000000", budget}, scenario);
    EXPECT_EQ(large.verdict, Verdict::budget) << parameter;
    EXPECT_EQ(digest(large), digest(run({parameter + "400", budget}, scenario))) << parameter;
  }
}

TEST(OmplConstraints, AGivenNumberOfNeighboursConnectsALazyRoadmap) {
  const Scenario scenario = scenarios::Library().load("dense/20-20/1");
  Budget budget;
  budget.evaluations = 5000;
  for (const char* count : {"3", "10"}) {
    const std::string call = std::string("ompl-lazy-prm:max_calls=20000,max_nearest_neighbors=") + count;
    EXPECT_EQ(run({call, budget}, scenario).verdict, Verdict::solved) << call;
  }
}

}  // namespace
}  // namespace pathrace::testing

#endif
