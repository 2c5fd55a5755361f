// What `plan` is asked: a scenario of the library, or two places on a map file, in cells or in metres.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "bench/cli/options.hpp"
#include "core/scenario.hpp"
#include "scenarios/ros/map_frame.hpp"

namespace pathrace::bench::cli {

struct PlanQuestion {
  std::string scenario;
  std::string map;
  std::string start;
  std::string goal;
  std::string start_m;
  std::string goal_m;
  MapFileOptions map_options;
  std::string maps;
  std::string rule;

  bool in_metres() const { return !start_m.empty() || !goal_m.empty(); }
};

/// --scenario, --map, --start, --goal, --start-m, --goal-m, --rule, --maps and those of map files.
void add_question_options(CLI::App& command, PlanQuestion& question);

struct Asked {
  Scenario scenario;  ///< with its proven optimum
  /// Of a map file whose cells are measured, or that was asked about in metres.
  std::optional<scenarios::MapFrame> frame;
};

/// Throws InputError or InvalidScenario for what is no question.
Asked ask(const PlanQuestion& question);

}  // namespace pathrace::bench::cli
