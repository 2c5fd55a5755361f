// The campaigns that come with the program, as the files they would be.
#include <array>

#include "bench/campaign.hpp"
#include "core/error.hpp"
#include "core/names.hpp"

namespace pathrace::bench {
namespace {

struct Builtin {
  std::string_view name;
  std::string_view toml;
};

constexpr std::array<Builtin, 2> builtins = {{
    {"starter", R"(
[campaign]
name = "starter"
seed = 1
repetitions = 2

[budget]
evaluations = 5000
checks = 1000000

[[planner]]
name = "as"
[[planner]]
name = "as"
params = { dead_end = "backtrack", alpha = [1, 0] }
[[planner]]
name = "acs"
params = { dead_end = "backtrack", alpha = [1, 0] }
[[planner]]
name = "mmas"
params = { dead_end = "backtrack", alpha = [1, 0] }
[[planner]]
name = "tan2016"
params = { alpha = [1, 0] }
[[planner]]
name = "pu2022"
params = { alpha = [1, 0] }
[[planner]]
name = "xie2010"
params = { insertion = "general", repair = "local_search", initial_genes = 8, mutation = "stretch" }
[[planner]]
name = "pso"
[[planner]]
name = "greedy"
[[planner]]
name = "random-walk"
[[planner]]
name = "astar"
[[planner]]
name = "jps"
[[planner]]
name = "dijkstra"
[[planner]]
name = "theta-star"
[[planner]]
name = "any-angle-optimum"
[[planner]]
name = "nasrollahy2009"
[[planner]]
name = "straight"
[[planner]]
name = "potential-field"
[[planner]]
name = 'replan(astar)'

[[scenarios]]
select = ["set/starter"]
[[scenarios]]
select = ["discs/*/1..3"]
budget = { iterations = 500 }   # of a navigator: steps
)"},
    {"smoke", R"(
[campaign]
name = "smoke"
seed = 1
repetitions = 2

[budget]
evaluations = 250
checks = 60000

[[planner]]
name = "as"
params = { dead_end = ["die", "backtrack", "revisit_with_loop_erasure"], ants = 20 }
[[planner]]
name = "as"
label = "as literal"
params = { heuristic = "inv_step", beta = 2.5, alpha = 1.5, answer = "argmax_pheromone" }
[[planner]]
name = "greedy"
[[planner]]
name = "random-walk"
[[planner]]
name = "astar"
[[planner]]
name = "dijkstra"

[[scenarios]]
select = ["dense/10-20/1..2", "dense/20-20/1..2", "dense/20-30/1..2", "trap-*/10/1", "trap-*/20/1", "asr/*"]
)"},
}};

}  // namespace

Campaign builtin_campaign(std::string_view name) {
  for (const Builtin& builtin : builtins) {
    if (builtin.name == name) return parse_campaign(builtin.toml, "built-in campaign " + std::string(name));
  }
  throw InputError(unknown_name("campaign", name, builtin_campaigns()));
}

std::vector<std::string> builtin_campaigns() {
  std::vector<std::string> names;
  for (const Builtin& builtin : builtins) names.emplace_back(builtin.name);
  return names;
}

}  // namespace pathrace::bench
