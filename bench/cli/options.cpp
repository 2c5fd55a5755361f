#include "bench/cli/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <thread>

#include "bench/executors.hpp"
#include "bench/thread_probe.hpp"
#include "core/error.hpp"
#include "core/names.hpp"

namespace pathrace::bench::cli {
namespace {

constexpr std::uint64_t most = std::uint64_t{1} << 62;

template <typename Number>
void add_limit(CLI::App& command, const std::string& name, std::optional<Number>& limit,
               const std::string& text, Number low, Number high) {
  command
      .add_option_function<Number>(
          name, [&limit](const Number& value) { limit = value; }, text)
      ->check(CLI::Range(low, high))
      ->type_name("N")
      ->group("Budget (whichever ends first; replaces the planner's default)");
}

// "A,B".
template <typename Number>
std::optional<std::pair<Number, Number>> parse_pair(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  std::pair<Number, Number> pair{};
  const auto number = [](std::string_view part, Number& value) {
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    return error == std::errc{} && end == part.data() + part.size();
  };
  if (!number(text.substr(0, comma), pair.first) || !number(text.substr(comma + 1), pair.second)) {
    return std::nullopt;
  }
  return pair;
}

}  // namespace

int core_count() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void add_executor_options(CLI::App& command, RunOptions& options, bool jobs) {
  if (jobs) {
    options.jobs = std::min(core_count(), max_threads);
    command.add_option("--jobs", options.jobs, "trials side by side (default: the cores)")
        ->check(CLI::Range(1, max_threads))
        ->type_name("N");
  }
  command.add_option("--threads", options.threads, "threads of each planner (default: 1)")
      ->check(CLI::Range(1, max_threads))
      ->type_name("N");
  command
      .add_option("--backend", options.backend,
                  fmt::format("serial, openmp, tbb or threads (default: {})", default_backend()))
      ->type_name("NAME");
  command.add_flag("--check-map", options.check_map,
                   "give each planner a copy of the map, and call it invalid when it changes that");
}

void require_backend(const RunOptions& options) {
  const std::vector<std::string> known = executor_names();
  if (std::find(known.begin(), known.end(), options.backend) == known.end()) {
    throw InputError(unknown_name("backend", options.backend, known));
  }
  if (options.backend != "serial") require_threads(options.jobs * options.threads);
}

void add_budget_options(CLI::App& command, Budget& budget) {
  add_limit<std::uint64_t>(command, "--evaluations", budget.evaluations,
                           "paths or walks judged by their cost", 1, most);
  add_limit<std::uint64_t>(command, "--iterations", budget.iterations, "rounds of the planner's main loop", 1,
                           most);
  add_limit<std::uint64_t>(command, "--checks", budget.checks, "cells tested or visited", 1, most);
  add_limit<double>(command, "--wall", budget.wall_s, "seconds", 1e-6, 1e9);
}

Cell parse_cell(const std::string& option, const std::string& text) {
  const std::optional<std::pair<int, int>> cell = parse_pair<int>(text);
  if (!cell) throw InputError(fmt::format("{}: expected a cell X,Y such as 3,4, got '{}'", option, text));
  return {cell->first, cell->second};
}

Point parse_point(const std::string& option, const std::string& text) {
  const std::optional<std::pair<double, double>> point = parse_pair<double>(text);
  if (!point) {
    throw InputError(
        fmt::format("{}: expected a point X,Y in metres such as 1.5,-2, got '{}'", option, text));
  }
  return {point->first, point->second};
}

void add_map_file_options(CLI::App& command, MapFileOptions& options) {
  const std::string group = "Map files";
  command
      .add_option("--unknown", options.unknown,
                  "unknown cells of a ROS map or picture: free, blocked or threshold (default: blocked)")
      ->type_name("POLICY")
      ->group(group);
  command
      .add_option("--radius", options.radius,
                  "the robot's radius, kept from the edges of blocked cells (default: 0)")
      ->check(CLI::Range(0.0, 1e9))
      ->type_name("METRES")
      ->group(group);
  command
      .add_option("--resolution", options.resolution,
                  "metres per cell, for files that do not say (default: 1)")
      ->check(CLI::Range(1e-9, 1e9))
      ->type_name("METRES")
      ->group(group);
}

scenarios::MapOptions map_options(const MapFileOptions& options) {
  scenarios::MapOptions map;
  map.unknown = parse_name<scenarios::UnknownPolicy>("policy for unknown cells", options.unknown);
  map.radius = options.radius;
  map.resolution = options.resolution;
  return map;
}

std::optional<std::filesystem::path> maps_folder(const std::string& given) {
  if (!given.empty()) return given;
  const char* data = std::getenv("PATHRACE_DATA");
  if (data == nullptr || *data == '\0') return std::nullopt;
  const std::filesystem::path folder = std::filesystem::path(data) / "movingai";
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored)) return std::nullopt;
  return folder;
}

}  // namespace pathrace::bench::cli
