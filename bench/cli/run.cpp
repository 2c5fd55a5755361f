// `run`: a campaign from its file to a leaderboard.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <iostream>
#include <memory>

#include "bench/campaign_maps.hpp"
#include "bench/cli/command.hpp"
#include "bench/cli/options.hpp"
#include "bench/describe.hpp"
#include "bench/failure_lines.hpp"
#include "bench/machine.hpp"
#include "bench/progress.hpp"
#include "bench/recorder.hpp"
#include "bench/roster.hpp"
#include "bench/run_folder.hpp"
#include "bench/stop.hpp"
#include "core/checkpoint.hpp"
#include "core/error.hpp"
#include "core/plain_text.hpp"
#include "results/leaderboard.hpp"

namespace pathrace::bench::cli {
namespace {

struct RunCommand {
  std::string file;
  std::string builtin;
  std::string out;
  std::string maps;
  std::optional<std::uint64_t> queries_per_map;
  std::optional<int> max_side;
  std::optional<std::uint64_t> seed;
  bool resume = false;
  bool dry_run = false;
  bool in_process = false;
  bool no_features = false;
  RunOptions options;
};

void say(const std::string& line) {
  fmt::print(stderr, "{}\n", escape_controls(line));
}

bool has_store(const RunFolder& folder) {
  std::error_code ignored;
  return std::filesystem::exists(folder.store(), ignored);
}

Campaign chosen_campaign(const RunCommand& command, const RunFolder& folder) {
  if (!command.file.empty() && !command.builtin.empty()) {
    throw InputError(
        fmt::format("both a campaign file '{}' and --campaign '{}' are given; expected one of them",
                    command.file, command.builtin));
  }
  if (!command.file.empty()) return read_campaign(command.file);
  if (command.builtin.empty() && command.resume) {  // go on with what the folder holds
    return parse_campaign(open_store(folder).identity().toml, folder.store().string());
  }
  Campaign campaign = builtin_campaign(command.builtin.empty() ? "starter" : command.builtin);
  const std::vector<std::string> absent = leave_out_absent(campaign, roster());
  if (!absent.empty()) {
    say(fmt::format("left out: {}; each needs {}", fmt::join(absent, ", "),
                    roster().absent(absent.front())->needs));
  }
  return campaign;
}

std::optional<std::filesystem::path> given_folder(const RunCommand& command) {
  if (command.maps.empty()) return std::nullopt;
  return command.maps;
}

void set_limits(const RunCommand& command, Campaign& campaign) {
  if (command.queries_per_map) campaign.limits.queries_per_map = *command.queries_per_map;
  if (command.max_side) campaign.limits.max_side = *command.max_side;
  const bool limited = command.queries_per_map || command.max_side;
  if (limited && command.maps.empty() && !campaign.maps) {
    throw InputError("--queries-per-map and --max-side need a folder of maps: name one with --maps");
  }
}

void say_what_repeats(const std::vector<std::string>& repeated) {
  constexpr std::size_t most_named = 3;
  if (repeated.empty()) return;
  const auto last = repeated.begin() + static_cast<std::ptrdiff_t>(std::min(repeated.size(), most_named));
  say(fmt::format("{} of the scenarios ask{} the question of an earlier one: {}{}", repeated.size(),
                  repeated.size() == 1 ? "s" : "", fmt::join(repeated.begin(), last, ", "),
                  repeated.size() > most_named ? ", ..." : ""));
}

TrialPlan make_plan(const RunCommand& command, const RunFolder& folder) {
  Campaign campaign = chosen_campaign(command, folder);
  if (command.seed) campaign.seed = *command.seed;
  set_limits(command, campaign);
  std::vector<std::string> left_out;
  settle_maps(campaign, given_folder(command), maps_folder(""), left_out);
  const scenarios::Library library(campaign.maps);
  TrialPlan plan = plan_trials(campaign, library, roster());
  left_out.insert(left_out.end(), plan.left_out.begin(), plan.left_out.end());
  for (const std::string& line : left_out) say("left out: " + line);
  say_what_repeats(plan.repeated);
  return plan;
}

results::Store open_or_create(const RunCommand& command, const RunFolder& folder, const TrialPlan& plan) {
  const results::StoreIdentity identity{plan.campaign.name, to_toml(plan.campaign), plan.hash(),
                                        plan.campaign.seed, plan.size()};
  if (!has_store(folder)) {
    write_file(folder.campaign(), identity.toml);
    return results::Store::create(folder.store(), identity);
  }
  if (!command.resume) {
    throw InputError(fmt::format("{}: holds a results.db already; go on with --resume, or name another --out",
                                 folder.path.string()));
  }
  results::Store store = results::Store::open(folder.store(), results::Access::append);
  if (store.identity().hash != identity.hash) {
    throw InputError(fmt::format(
        "{}: holds another campaign ('{}', seed {}, {} trials) than the one to resume ('{}', "
        "seed {}, {} trials); planners, their versions, budgets, scenarios and map files must be the same",
        folder.store().string(), store.identity().campaign, store.identity().seed, store.identity().trials,
        identity.campaign, identity.seed, identity.trials));
  }
  return store;
}

std::vector<std::size_t> missing_trials(const TrialPlan& plan, const results::Store& store) {
  std::vector<std::size_t> missing;
  const std::unordered_set<std::uint64_t> recorded = store.keys();
  for (std::size_t i = 0; i < plan.size(); ++i) {
    if (recorded.find(plan.trial(i).hash) == recorded.end()) missing.push_back(i);
  }
  return missing;
}

std::string announcement(const TrialPlan& plan, std::size_t recorded, const RunOptions& options) {
  return fmt::format("{}: {} trials ({} planners, {} scenarios){}; {} job{} of {} thread{}",
                     plan.campaign.name, plan.size(), plan.entrants.size(), plan.scenarios.size(),
                     recorded > 0 ? fmt::format(", {} recorded already", recorded) : "", options.jobs,
                     options.jobs == 1 ? "" : "s", options.threads, options.threads == 1 ? "" : "s");
}

void race(const TrialPlan& plan, const std::vector<std::size_t>& missing, const RunOptions& options,
          results::Store& store) {
  const int session = store.begin_session(machine_facts());
  Progress progress(plan.size() - missing.size(), plan.size());
  Recorder recorder(store, stop_requested, [&](std::size_t done_count) { progress.update(done_count); });
  run_trials(plan, missing, options, stop_requested,
             [&](const Trial& trial, const Scenario& scenario, const TrialRecord& record) {
               results::TrialRow row =
                   results::make_row(trial.key, scenario, plan.entrants[trial.entrant], trial.budget, record);
               row.session = session;
               recorder.add(std::move(row));
             });
  recorder.finish();
  progress.close();
}

void describe_and_race(const RunCommand& command, const TrialPlan& plan,
                       const std::vector<std::size_t>& missing, results::Store& store) {
  store_scenarios(plan, !command.no_features, command.options, stop_requested, store);
  if (missing.empty()) {
    say(fmt::format("{}: all {} trials are recorded already", plan.campaign.name, plan.size()));
    return;
  }
  say(announcement(plan, plan.size() - missing.size(), command.options));
  race(plan, missing, command.options, store);
}

int run_command(const RunCommand& command) {
  require_backend(command.options);
  RunFolder folder{command.out};
  if (command.out.empty() && command.resume)
    throw InputError("--resume needs the folder to go on with: --out DIR");
  if (command.resume && !has_store(folder)) {
    throw InputError(
        fmt::format("{}: holds no results.db to go on with; begin without --resume", folder.path.string()));
  }
  const TrialPlan plan = make_plan(command, folder);
  if (command.dry_run) {
    fmt::print("{}\n", announcement(plan, 0, command.options));
    return done;
  }
  if (command.out.empty()) folder = next_free_folder(plan.campaign.name);
  make_folder(folder);
  results::Store store = open_or_create(command, folder, plan);
  const std::vector<std::size_t> missing = missing_trials(plan, store);
  stop_on_signals();
  try {
    describe_and_race(command, plan, missing, store);
  } catch (const Interrupted&) {  // told below; what is recorded is kept
  }
  write_tables(folder, store);
  if (stop_requested.load()) {
    say(fmt::format("interrupted; {} of {} trials are recorded: go on with --resume --out {}", store.size(),
                    plan.size(), folder.path.string()));
    return interrupted;
  }
  results::print_console(std::cout, results::leaderboard(store, results::Grouping::all));
  std::cout.flush();
  for (const std::string& line : failure_lines(store.outcomes())) say(line);
  say(fmt::format("results in {}", folder.path.string()));
  return done;
}

}  // namespace

void add_run(CLI::App& app) {
  auto command = std::make_shared<RunCommand>();
  CLI::App* options = add_command(app, "run", "run a campaign and print its leaderboard",
                                  "pathrace run --campaign smoke --out runs/first",
                                  [command] { return run_command(*command); });
  options->add_option("file", command->file, "a campaign file; without one, the built-in campaign 'starter'")
      ->type_name("CAMPAIGN.toml");
  options->add_option("--campaign", command->builtin, "a built-in campaign: starter or smoke")
      ->type_name("NAME");
  options
      ->add_option_function<std::uint64_t>(
          "--seed", [command](std::uint64_t seed) { command->seed = seed; }, "replaces the campaign's seed")
      ->check(CLI::Range(std::uint64_t{0}, static_cast<std::uint64_t>(INT64_MAX)))
      ->type_name("N");
  options
      ->add_option("--out", command->out, "folder for the results (default: a new one, runs/<campaign>-<n>)")
      ->type_name("DIR");
  add_executor_options(*options, command->options, true);
  options->add_flag("--in-process", command->in_process, "run the trials in this process (the default)");
  options->add_flag("--resume", command->resume, "go on with the folder of --out: recorded trials are kept");
  options
      ->add_option(
          "--maps", command->maps,
          "folder of maps to race on as well (MovingAI, ROS, pictures, text grids); for a campaign that "
          "selects recorded maps, where they lie")
      ->type_name("DIR");
  options
      ->add_option_function<std::uint64_t>(
          "--queries-per-map", [command](std::uint64_t n) { command->queries_per_map = n; },
          "of a folder of maps: so many queries of each scen file, and of each map without one (default: 2)")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("N");
  options
      ->add_option_function<int>(
          "--max-side", [command](int n) { command->max_side = n; },
          "of a folder of maps: leave out those with more cells a side (default: 512)")
      ->check(CLI::Range(1, OccupancyGrid::max_side))
      ->type_name("N");
  options->add_flag("--no-features", command->no_features,
                    "leave the scenarios' features out of results.db and scenarios.csv");
  options->add_flag("--dry-run", command->dry_run,
                    "print the numbers of trials, planners and scenarios, run nothing");
}

}  // namespace pathrace::bench::cli
