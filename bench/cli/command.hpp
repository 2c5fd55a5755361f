// A command of the program: its options, and what it does with them.
//
// One command = one file in this folder and one line in commands.def.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace pathrace::bench::cli {

/// Exit codes (stable; scripts depend on them).
inline constexpr int done = 0;
inline constexpr int something_found = 1;
inline constexpr int bad_input = 2;
inline constexpr int environment_failed = 3;
inline constexpr int interrupted = 130;

/// Thrown out of a command's callback, so that its exit code comes through the option parser.
struct ExitCode {
  int code;
};

/// Adds a subcommand: `summary` in one line, `example` a line that can be pasted. `body` runs after parsing;
/// what it returns is the exit code.
CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& summary,
                      const std::string& example, std::function<int()> body);

}  // namespace pathrace::bench::cli
