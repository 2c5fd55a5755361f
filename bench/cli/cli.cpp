#include "bench/cli/cli.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <new>
#include <system_error>
#include <vector>

#include "bench/cli/command.hpp"
#include "core/checkpoint.hpp"
#include "core/error.hpp"
#include "core/names.hpp"
#include "core/plain_text.hpp"

namespace pathrace::bench::cli {

#define PATHRACE_COMMAND(add) void add(CLI::App& app);
#include "bench/cli/commands.def"
#undef PATHRACE_COMMAND

namespace {

// Whatever was quoted in it: no line ends, nothing that a terminal obeys.
std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return escape_controls(text);
}

int complain(const std::string& what, int code) {
  fmt::print(stderr, "pathrace: {}\n", one_line(what));
  return code;
}

void require_known_command(const CLI::App& app, int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands(nullptr)) {
    if (command->get_name() == argv[1]) return;
    known.push_back(command->get_name());
  }
  throw InputError(unknown_name("command", argv[1], known));
}

int dispatch(int argc, const char* const* argv) {
  CLI::App app("pathrace: race path planners on the same scenarios, under the same budgets", "pathrace");
  app.set_version_flag("--version", "pathrace 0.1.0");
  app.require_subcommand(1);
#define PATHRACE_COMMAND(add) add(app);
#include "bench/cli/commands.def"
#undef PATHRACE_COMMAND
  app.footer("pathrace COMMAND --help explains a command and shows an example.");
  if (argc < 2) {
    fmt::print("{}", app.help());
    return bad_input;
  }
  require_known_command(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    return complain(std::string(error.what()) + "; see --help", bad_input);
  }
  return done;
}

}  // namespace

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& summary,
                      const std::string& example, std::function<int()> body) {
  CLI::App* command = app.add_subcommand(name, summary);
  if (!example.empty()) command->footer("Example:\n  " + example);
  command->callback([body = std::move(body)] { throw ExitCode{body()}; });
  return command;
}

int run(int argc, const char* const* argv) {
  try {
    const int code = dispatch(argc, argv);
    std::fflush(stdout);
    return code;
  } catch (const ExitCode& finished) {
    if (std::fflush(stdout) != 0) return complain("the output cannot be written", environment_failed);
    return finished.code;
  } catch (const Interrupted&) {
    return complain("interrupted", interrupted);
  } catch (const InputError& error) {
    return complain(error.what(), bad_input);
  } catch (const EnvironmentError& error) {
    return complain(error.what(), environment_failed);
  } catch (const std::filesystem::filesystem_error& error) {
    return complain(error.what(), environment_failed);
  } catch (const std::system_error& error) {
    return complain(error.what(), environment_failed);
  } catch (const std::bad_alloc&) {
    return complain("out of memory", environment_failed);
  } catch (const std::exception& error) {
    return complain(std::string("an error of pathrace itself: ") + error.what(), environment_failed);
  }
}

}  // namespace pathrace::bench::cli
