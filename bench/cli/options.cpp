#include "bench/cli/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <thread>

#include "bench/executors.hpp"
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
  command.add_option("--backend", options.backend, "serial, openmp, tbb or threads (default: tbb)")
      ->type_name("NAME");
}

void require_backend(const RunOptions& options) {
  const std::vector<std::string> known = executor_names();
  if (std::find(known.begin(), known.end(), options.backend) == known.end()) {
    throw InputError(unknown_name("backend", options.backend, known));
  }
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
  const std::size_t comma = text.find(',');
  const auto number = [](std::string_view part, int& value) {
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    return error == std::errc{} && end == part.data() + part.size();
  };
  Cell cell;
  const std::string_view view = text;
  if (comma == std::string::npos || !number(view.substr(0, comma), cell.x) ||
      !number(view.substr(comma + 1), cell.y)) {
    throw InputError(fmt::format("{}: expected a cell X,Y such as 3,4, got '{}'", option, text));
  }
  return cell;
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
