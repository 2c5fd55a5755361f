// `micro`: the micro-benchmarks, a program of their own beside this one.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "bench/cli/command.hpp"
#include "core/error.hpp"

namespace pathrace::bench::cli {
namespace {

struct MicroCommand {
  std::string filter;
  std::string json;
};

// Becomes the other program; comes back only when that is not there.
int micro_command(const MicroCommand& command) {
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
  const std::string program = self.parent_path() / "pathrace_micro";
  std::vector<std::string> arguments{program};
  if (!command.filter.empty()) arguments.push_back("--benchmark_filter=" + command.filter);
  if (!command.json.empty()) {
    arguments.push_back("--benchmark_out=" + command.json);
    arguments.emplace_back("--benchmark_out_format=json");
  }
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  std::fflush(stdout);
  execv(program.c_str(), pointers.data());
  throw EnvironmentError(
      fmt::format("{} cannot be run: ./pathrace micro builds it (it needs libbenchmark-dev)", program));
}

}  // namespace

void add_micro(CLI::App& app) {
  auto command = std::make_shared<MicroCommand>();
  CLI::App* options = add_command(app, "micro", "run the micro-benchmarks, where they are built",
                                  "pathrace micro --filter 'colony/die' --json micro.json",
                                  [command] { return micro_command(*command); });
  options->add_option("--filter", command->filter, "only those whose name matches")->type_name("REGEX");
  options->add_option("--json", command->json, "write Google Benchmark's JSON as well")->type_name("FILE");
}

}  // namespace pathrace::bench::cli
