// Options that several commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "bench/runner.hpp"
#include "core/budget.hpp"
#include "core/cell.hpp"
#include "scenarios/map_reader.hpp"

namespace pathrace::bench::cli {

/// --backend, --threads, --check-map, and --jobs when `jobs` is true; defaults: the build's (tbb), 1 thread,
/// as many jobs as cores.
void add_executor_options(CLI::App& command, RunOptions& options, bool jobs);

/// Throws InputError for an unknown backend, naming the nearest match; EnvironmentError when the system does
/// not grant as many threads as all jobs together need.
void require_backend(const RunOptions& options);

/// --evaluations, --iterations, --checks, --wall. Any of them replaces the planner's default budget whole.
void add_budget_options(CLI::App& command, Budget& budget);

/// "3,4". Throws InputError that names the option.
Cell parse_cell(const std::string& option, const std::string& text);

/// "1.5,-2". Throws InputError that names the option.
Point parse_point(const std::string& option, const std::string& text);

/// What a map file leaves to be said.
struct MapFileOptions {
  std::string unknown = "blocked";
  double radius = 0;
  std::optional<double> resolution;
};

/// --unknown, --radius, --resolution.
void add_map_file_options(CLI::App& command, MapFileOptions& options);

/// Throws InputError for an unknown policy; names the nearest match.
scenarios::MapOptions map_options(const MapFileOptions& options);

int core_count();

/// The folder of recorded maps: the given one, else `movingai` in the folder that PATHRACE_DATA names, if
/// any.
std::optional<std::filesystem::path> maps_folder(const std::string& given);

}  // namespace pathrace::bench::cli
