// Trials for tests: a planner call on a question, under a budget, on an executor.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench/executors.hpp"
#include "bench/roster.hpp"
#include "bench/trial.hpp"
#include "core/record.hpp"
#include "core/referee.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/sanitizers.hpp"

namespace pathrace::testing {

/// Executors that this build can test.
inline std::vector<std::string> executors_under_test() {
  return thread_sanitizer ? std::vector<std::string>{"serial", "threads"} : bench::executor_names();
}

inline Scenario scenario_of(const Question& question, MoveRule rule = MoveRule::strict) {
  Scenario scenario;
  scenario.id = "test";
  scenario.terrain = terrain_of(question.grid, rule);
  scenario.start = question.start;
  scenario.goal = question.goal;
  return scenario;
}

struct TrialSetting {
  std::string call;
  Budget budget = {};
  std::string backend = "serial";
  int threads = 1;
  std::uint64_t seed = 1;
};

/// Whatever the setting says of backend and threads.
inline TrialRecord run_on(Executor& executor, const TrialSetting& setting, const Scenario& scenario) {
  const Entrant entrant = bench::roster().enter(parse_call(setting.call));
  const Budget budget = setting.budget.unlimited() ? entrant.card->default_budget : setting.budget;
  return bench::run_trial(entrant, scenario, Referee(scenario.terrain), budget,
                          root_stream(setting.seed, scenario.id, 0), executor);
}

inline TrialRecord run(const TrialSetting& setting, const Scenario& scenario) {
  return run_on(*bench::make_executor(setting.backend, setting.threads), setting, scenario);
}

/// Every planner of static maps with its defaults, and the variants whose code paths differ.
inline std::vector<std::string> calls_under_test() {
  std::vector<std::string> calls;
  for (const PlannerCard& card : bench::roster().cards()) {
    if (!card.navigates()) calls.push_back(card.name);
  }
  calls.insert(calls.end(),
               {"as:dead_end=backtrack", "as:dead_end=revisit_with_loop_erasure",
                "as:heuristic=inv_step,beta=2.5,alpha=1.5", "as:answer=argmax_pheromone,both_ways=false",
                "acs:dead_end=backtrack", "mmas:dead_end=backtrack,evaporation=0.5,restart_after=1",
                "tan2016:dead_table=global_literal", "tan2016:dead_end=die,dead_table=none",
                "pu2022:dead_table=global_literal", "pu2022:teaching=parameters",
                "pu2022:teaching=none,update=all_ants"});
  calls.insert(
      calls.end(),
      {"xie2010:insertion=general",
       "xie2010:insertion=blind,crossover=free,first_generation=repaired,elitism=false",
       "xie2010:insertion=general,repair=local_search,mutation=stretch,mutation_rate=0.5,initial_genes=8"});
  calls.insert(calls.end(), {"pso:particles=10,life=8,waypoints_max=4",
                             "pso:particles=12,life=6,topology=global,inertia=linear,birth=uniform"});
  return calls;
}

}  // namespace pathrace::testing
