// `plan`: one trial, looked at closely.
#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <memory>
#include <sstream>

#include "bench/cli/command.hpp"
#include "bench/cli/options.hpp"
#include "bench/cli/picture_file.hpp"
#include "bench/dynamic_trial.hpp"
#include "bench/executors.hpp"
#include "bench/reference.hpp"
#include "bench/roster.hpp"
#include "bench/run_folder.hpp"
#include "bench/ticker.hpp"
#include "bench/trial.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/referee.hpp"
#include "results/json.hpp"
#include "results/outcome_count.hpp"
#include "results/picture_png.hpp"
#include "results/row.hpp"
#include "results/svg.hpp"
#include "results/trace_csv.hpp"
#include "scenarios/library.hpp"
#include "scenarios/map_reader.hpp"

namespace pathrace::bench::cli {
namespace {

struct PlanCommand {
  std::string scenario;
  std::string map;
  std::string start;
  std::string goal;
  std::string start_m;
  std::string goal_m;
  MapFileOptions map_options;
  std::string maps;
  std::string planner;
  std::string rule;
  std::uint64_t seed = 1;
  std::uint64_t repetition = 0;
  Budget budget;
  RunOptions options;
  bool json = false;
  std::string svg;
  std::string png;
  std::string trace;
  std::string frames;

  bool draws() const { return !svg.empty() || !png.empty() || !frames.empty(); }
};

// One end of the way, in cells or in metres.
Cell chosen_cell(const std::string& option, const std::string& cell, const std::string& metres,
                 const scenarios::MapFrame& frame) {
  if (cell.empty() == metres.empty()) {
    throw InputError(fmt::format("--map needs either {0} X,Y or {0}-m X,Y", option));
  }
  if (metres.empty()) return parse_cell(option, cell);
  const Point point = parse_point(option + "-m", metres);
  const std::optional<Cell> found = frame.cell_at({point.x, point.y});
  if (!found) throw InputError(fmt::format("{}-m: expected a point on the map, got '{}'", option, metres));
  return *found;
}

Scenario scenario_on_map(const PlanCommand& command) {
  const scenarios::GridMap map = scenarios::read_map(command.map, map_options(command.map_options));
  Scenario scenario;
  scenario.start = chosen_cell("--start", command.start, command.start_m, map.frame);
  scenario.goal = chosen_cell("--goal", command.goal, command.goal_m, map.frame);
  scenario.terrain.grid = map.grid_for(scenario.start, scenario.goal);
  scenario.id = command.map;
  require_valid(scenario);
  scenario.id = fmt::format("map/{}/{},{}/{},{}", std::filesystem::path(command.map).stem().string(),
                            scenario.start.x, scenario.start.y, scenario.goal.x, scenario.goal.y);
  return scenario;
}

Scenario chosen_scenario(const PlanCommand& command) {
  if (command.scenario.empty() == command.map.empty()) {
    throw InputError("expected either --scenario ID or --map FILE --start X,Y --goal X,Y");
  }
  Scenario scenario = command.map.empty()
                          ? scenarios::Library(maps_folder(command.maps)).load(command.scenario)
                          : scenario_on_map(command);
  if (!command.rule.empty()) {
    const auto rule = parse_name<MoveRule>("move rule", command.rule);
    if (scenario.world) throw InputError("--rule: there are no moves of cells in a dynamic world");
    if (rule != scenario.terrain.rule) scenario.optimum = {};
    scenario.terrain.rule = rule;
  }
  scenarios::prove(scenario);
  return scenario;
}

std::string or_dash(const std::optional<double>& value, std::string_view format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "-";
}

std::string percent_or_dash(const std::optional<double>& share) {
  return share ? fmt::format("{:.2f} %", 100 * *share) : "-";
}

void print_way(const results::TrialRow& row) {
  fmt::print("length       {}   optimum {}   gap {}\n", or_dash(row.length, "{:.4f}"),
             or_dash(row.optimum, "{:.4f}"), percent_or_dash(row.gap));
  fmt::print("turns        {}   least clearance {}\n", row.turns ? std::to_string(*row.turns) : "-",
             or_dash(row.clearance_min, "{:.2f}"));
}

void print_run(const results::TrialRow& row) {
  if (!row.run) return;
  fmt::print("steps        {}   least {}   gap {}   travelled {:.4f}\n", row.run->steps,
             row.least_steps ? std::to_string(*row.least_steps) : "-", percent_or_dash(row.gap),
             row.run->travelled);
  fmt::print("collisions   {}   struck {}   least clearance {}   oscillations {}\n", row.run->collisions,
             row.run->struck, or_dash(row.run->min_clearance, "{:.2f}"), row.run->oscillations);
  fmt::print("world        {}\nper step     {} ms, 99th percentile {} ms\n", hex(row.run->world_hash),
             or_dash(row.costs.step_ms_median, "{:.4f}"), or_dash(row.costs.step_ms_p99, "{:.4f}"));
}

void print_summary(const results::TrialRow& row, bool moves) {
  fmt::print("scenario     {} ({})\n", row.scenario, moves ? "dynamic" : name(row.rule));
  fmt::print("planner      {}\n", row.planner);
  fmt::print("verdict      {}{}{}\n", name(row.verdict), row.note.empty() ? "" : ": ", row.note);
  moves ? print_run(row) : print_way(row);
  fmt::print("work         {} evaluations, {} iterations, {} checks\n", row.work.evaluations,
             row.work.iterations, row.work.checks);
  fmt::print("time         {:.3f} ms ({}, {} of {} threads seen running)\n", 1000 * row.costs.wall_s,
             row.costs.backend, row.costs.threads_used, row.costs.threads);
  if (row.costs.user_s && row.costs.system_s) {
    fmt::print("processors   {:.3f} ms user, {:.3f} ms system{}\n", 1000 * *row.costs.user_s,
               1000 * *row.costs.system_s,
               row.costs.crowded ? "; the machine was busy with something else" : "");
  }
  fmt::print("digest       {}\n", hex(row.digest));
}

void write_pictures(const PlanCommand& command, const Scenario& scenario, const results::TrialRow& row,
                    const Overlay& overlay) {
  results::Shown shown{fmt::format("{} on {}", row.planner, row.scenario), row.answer, row.track, row.verdict,
                       overlay};
  if (!shown.solved()) shown.title += ": " + results::in_words(row.verdict);
  if (!command.svg.empty()) {
    std::ostringstream text;
    results::write_svg(text, scenario, shown);
    write_file(command.svg, text.str());
  }
  if (!command.png.empty()) {
    std::ostringstream bytes;
    results::write_png(bytes, scenario, shown);
    write_file(command.png, bytes.str());
  }
  if (!command.trace.empty()) {
    std::ostringstream text;
    results::write_trace_csv(text, row.trace);
    write_file(command.trace, text.str());
  }
}

// Everything of a run on one sheet: the swarms of all steps, evenly thinned where they are too many, and the
// rest of the last step.
Overlay collected(const std::vector<Overlay>& steps) {
  constexpr std::size_t most_points = 10'000;
  if (steps.empty()) return {};
  std::size_t total = 0;
  for (const Overlay& step : steps) total += step.points.size();
  const std::size_t stride = total / most_points + 1;
  Overlay all = steps.back();
  all.points.clear();
  std::size_t number = 0;
  for (const Overlay& step : steps) {
    for (const Point point : step.points) {
      if (number++ % stride == 0) all.points.push_back(point);
    }
  }
  return all;
}

// One picture before the first step, and one after each: 0000.png, 0001.png, ...
void write_frames(const PlanCommand& command, const Scenario& scenario, const results::TrialRow& row,
                  const std::vector<Overlay>& steps) {
  if (command.frames.empty() || !row.answer) return;
  make_folder({command.frames});
  results::Shown shown;
  shown.answer.emplace().track = Track::dynamic;
  for (std::size_t k = 0; k < row.answer->points.size(); ++k) {
    shown.title = fmt::format("{} on {}, step {}", row.planner, row.scenario, k);
    shown.answer->points.push_back(row.answer->points[k]);
    shown.overlay = k > 0 ? steps[k - 1] : Overlay{};
    std::ostringstream bytes;
    results::write_png(bytes, scenario, shown);
    write_file(std::filesystem::path(command.frames) / fmt::format("{:04}.png", k), bytes.str());
  }
}

int exit_code_of(Verdict verdict) {
  if (verdict == Verdict::bad_scenario) return bad_input;
  return is_fault(verdict) ? something_found : done;
}

// Proves what the gap counts from, too.
TrialRecord run_once(const PlanCommand& command, const Entrant& entrant, Scenario& scenario,
                     const Budget& budget, const Stream& stream, std::vector<Overlay>& overlays,
                     Ticker& ticker) {
  const std::unique_ptr<Executor> executor = make_executor(command.options.backend, command.options.threads);
  if (scenario.world) {
    WatchStep watch;
    if (command.draws()) {
      watch = [&overlays](const Snapshot&, Point, const Overlay& overlay) { overlays.push_back(overlay); };
    }
    return run_dynamic_trial(entrant, *scenario.world, budget, stream, *executor, watch, &ticker);
  }
  overlays.emplace_back();
  const Referee referee(scenario.terrain);
  prove_reference(scenario, entrant.card->track, referee);
  return run_trial(entrant, scenario, referee, budget, stream, *executor,
                   command.draws() ? &overlays.back() : nullptr, &ticker, command.options.check_map);
}

int plan_command(const PlanCommand& command) {
  require_backend(command.options);
  const Entrant entrant = roster().enter(parse_call(command.planner));
  auto ticker = std::make_unique<Ticker>(isatty(STDERR_FILENO) == 1);
  ticker->say("proves the optimum");
  Scenario scenario = chosen_scenario(command);
  if (!command.svg.empty()) require_svg_size(command.svg, scenario);
  if (!command.frames.empty() && !scenario.world) {
    throw InputError(
        fmt::format("--frames: expected a dynamic scenario such as discs/open/1, got '{}'", scenario.id));
  }
  const Budget budget = command.budget.unlimited() ? entrant.card->default_budget : command.budget;
  const TrialKey key{scenario.id,        content_hash(scenario), entrant.full_call(), entrant.version(),
                     command.repetition, command.seed,           work_hash(budget)};
  std::vector<Overlay> overlays;
  TrialRecord record = run_once(command, entrant, scenario, budget,
                                root_stream(key.seed, key.scenario, key.repetition), overlays, *ticker);
  ticker.reset();
  record.key = key.hash();
  record.costs.backend = command.options.backend;
  record.costs.threads = command.options.threads;
  const results::TrialRow row = results::make_row(key, scenario, entrant, budget, record);
  if (command.json) {
    fmt::print("{}\n", results::to_json(row, scenario));
  } else {
    print_summary(row, scenario.world != nullptr);
  }
  write_pictures(command, scenario, row, collected(overlays));
  write_frames(command, scenario, row, overlays);
  return exit_code_of(row.verdict);
}

}  // namespace

void add_plan(CLI::App& app) {
  auto command = std::make_shared<PlanCommand>();
  CLI::App* options =
      add_command(app, "plan", "run one planner on one scenario",
                  "pathrace plan --scenario dense/20-20/7 --planner as:dead_end=backtrack --svg path.svg",
                  [command] { return plan_command(*command); });
  options->add_option("--scenario", command->scenario, "a scenario of the library")->type_name("ID");
  options
      ->add_option("--map", command->map,
                   "a map file (.map .yaml .yml .pgm .png .bmp .csv .txt), with --start and --goal")
      ->type_name("FILE");
  options->add_option("--start", command->start, "a cell; 0,0 is the upper left")->type_name("X,Y");
  options->add_option("--goal", command->goal, "a cell")->type_name("X,Y");
  options->add_option("--start-m", command->start_m, "the same in metres of the map's frame")
      ->type_name("X,Y");
  options->add_option("--goal-m", command->goal_m, "the same in metres")->type_name("X,Y");
  add_map_file_options(*options, command->map_options);
  options
      ->add_option("--maps", command->maps, "folder of recorded maps, for movingai/... and ros/... scenarios")
      ->type_name("DIR");
  options
      ->add_option("--planner", command->planner,
                   "a planner, with parameters where they differ from the defaults")
      ->type_name("NAME[:key=value,...]")
      ->required();
  options
      ->add_option("--rule", command->rule, "four, strict, squeeze or free (default: the scenario's, strict)")
      ->type_name("RULE");
  options->add_option("--seed", command->seed, "the campaign's seed (default: 1)")->type_name("N");
  options
      ->add_option("--repetition", command->repetition, "which repetition of a campaign, from 0 (default: 0)")
      ->type_name("N");
  add_budget_options(*options, command->budget);
  add_executor_options(*options, command->options, false);
  options->add_flag("--json", command->json, "print one JSON object");
  options
      ->add_option(
          "--svg", command->svg,
          "draw map, path, and what the planner thought: pheromone, circles, swarms; of dynamic worlds, the "
          "trails of discs and goal")
      ->type_name("FILE");
  options->add_option("--png", command->png, "draw map and path, as pixels")->type_name("FILE");
  options
      ->add_option("--frames", command->frames,
                   "in a dynamic world: draw the state before the first step and after each, as PNG files")
      ->type_name("DIR");
  options->add_option("--trace", command->trace, "write each improvement with the work spent, as CSV")
      ->type_name("FILE.csv");
}

}  // namespace pathrace::bench::cli
