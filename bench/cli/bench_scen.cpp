// `bench-scen`: a MovingAI scen file through one planner.
#include <fmt/format.h>

#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "bench/cli/command.hpp"
#include "bench/roster.hpp"
#include "bench/scen_bench.hpp"
#include "core/error.hpp"
#include "core/plain_text.hpp"

namespace pathrace::bench::cli {
namespace {

struct BenchScenCommand {
  std::string map;
  std::string scen;
  std::string planner = "astar";
  std::size_t limit = std::numeric_limits<std::size_t>::max();
  int repeat = 1;
  bool json = false;
};

void print_report(const BenchScenCommand& command, const Entrant& entrant, const ScenReport& report) {
  fmt::print("map          {}\nplanner      {}\n", escape_controls(command.map), entrant.label);
  fmt::print("queries      {}: {} matched, {} mismatched, {} bad\n", report.queries, report.matched,
             report.mismatched, report.bad_queries);
  if (report.proven_here > 0) {
    fmt::print("proven here  {}: {}\n", report.proven_here,
               entrant.card->track == Track::any_angle
                   ? "compared with the any-angle optimum, since the file's is 8-connected"
                   : "the file prints 0 between different cells, which stands for unknown");
  }
  fmt::print("time         {:.1f} us per query (median {:.1f}), set-up {:.1f} us\n", report.us_per_query_mean,
             report.us_per_query_median, report.setup_us);
  fmt::print("expansions   {}, {:.2f} million per second\n", report.expansions,
             report.expansions_per_second / 1e6);
}

nlohmann::ordered_json json(const BenchScenCommand& command, const Entrant& entrant,
                            const ScenReport& report) {
  return {{"map", command.map},
          {"planner", entrant.label},
          {"queries", report.queries},
          {"matched", report.matched},
          {"mismatched", report.mismatched},
          {"bad_queries", report.bad_queries},
          {"proven_here", report.proven_here},
          {"setup_us", report.setup_us},
          {"us_per_query_mean", report.us_per_query_mean},
          {"us_per_query_median", report.us_per_query_median},
          {"expansions", report.expansions},
          {"expansions_per_second", report.expansions_per_second}};
}

int bench_scen_command(const BenchScenCommand& command) {
  const Entrant entrant = roster().enter(parse_call(command.planner));
  if (entrant.card->navigates()) {
    throw InputError(
        fmt::format("--planner: expected a planner of static maps, got the navigator '{}'", entrant.label));
  }
  const scenarios::MapFile map = scenarios::MapFile::read(command.map);
  const scenarios::ScenFile scen = scenarios::ScenFile::read(command.scen);
  scenarios::require_same_map(scen, command.map);
  const ScenReport report = bench_scen(map, scen, entrant, command.limit, command.repeat);
  for (const std::string& remark : report.remarks) fmt::print(stderr, "{}\n", escape_controls(remark));
  if (command.json) {
    fmt::print("{}\n", json(command, entrant, report).dump(2));
  } else {
    print_report(command, entrant, report);
  }
  const bool nothing = report.matched + report.mismatched == 0;
  if (nothing) fmt::print(stderr, "nothing was measured: all {} queries are bad\n", report.queries);
  return nothing || report.mismatched > 0 ? something_found : done;
}

}  // namespace

void add_bench_scen(CLI::App& app) {
  auto command = std::make_shared<BenchScenCommand>();
  CLI::App* options = add_command(app, "bench-scen", "run a MovingAI scen file through one planner",
                                  "pathrace bench-scen --map arena.map --scen arena.map.scen --planner astar",
                                  [command] { return bench_scen_command(*command); });
  options->add_option("--map", command->map, "a .map file")->type_name("FILE")->required();
  options->add_option("--scen", command->scen, "a .scen file for that map")->type_name("FILE")->required();
  options->add_option("--planner", command->planner, "a planner (default: astar)")
      ->type_name("NAME[:key=value,...]");
  options->add_option("--limit", command->limit, "so many queries, spread evenly over the file")
      ->check(CLI::Range(std::size_t{1}, std::numeric_limits<std::size_t>::max()))
      ->type_name("N");
  options->add_option("--repeat", command->repeat, "run each query so often; the median counts (default: 1)")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("N");
  options->add_flag("--json", command->json, "print one JSON object");
}

}  // namespace pathrace::bench::cli
