// `plan`: one trial, looked at closely.
#include <fmt/format.h>
#include <unistd.h>

#include <memory>
#include <sstream>

#include "bench/cli/command.hpp"
#include "bench/cli/options.hpp"
#include "bench/cli/or_dash.hpp"
#include "bench/cli/picture_file.hpp"
#include "bench/cli/plan_question.hpp"
#include "bench/cli/way_in_metres.hpp"
#include "bench/dynamic_trial.hpp"
#include "bench/executors.hpp"
#include "bench/reference.hpp"
#include "bench/roster.hpp"
#include "bench/run_folder.hpp"
#include "bench/ticker.hpp"
#include "bench/trial.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/plain_text.hpp"
#include "core/referee.hpp"
#include "results/json.hpp"
#include "results/outcome_count.hpp"
#include "results/picture_png.hpp"
#include "results/row.hpp"
#include "results/svg.hpp"
#include "results/trace_csv.hpp"

namespace pathrace::bench::cli {
namespace {

struct PlanCommand {
  PlanQuestion question;
  std::string planner;
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

void print_summary(const results::TrialRow& row, bool moves, const std::optional<results::InMetres>& metres) {
  fmt::print("scenario     {} ({})\n", escape_controls(row.scenario), moves ? "dynamic" : name(row.rule));
  fmt::print("planner      {}\n", row.planner);
  fmt::print("verdict      {}{}{}\n", name(row.verdict), row.note.empty() ? "" : ": ",
             escape_controls(row.note));
  if (moves) {
    print_run(row);
  } else if (metres) {
    print_way_in_metres(row, *metres);
  } else {
    print_way(row);
  }
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
  auto [scenario, frame] = ask(command.question);
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
  std::optional<results::InMetres> metres;
  if (frame) metres = in_metres(*frame, scenario, row);
  if (command.json) {
    fmt::print("{}\n", results::to_json(row, scenario, metres));
  } else {
    if (!command.question.in_metres()) metres.reset();
    print_summary(row, scenario.world != nullptr, metres);
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
  add_question_options(*options, command->question);
  options
      ->add_option("--planner", command->planner,
                   "a planner, with parameters where they differ from the defaults")
      ->type_name("NAME[:key=value,...]")
      ->required();
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
