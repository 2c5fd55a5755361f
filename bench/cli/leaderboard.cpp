// `leaderboard`: the standings of a run, finished or not.
#include "results/leaderboard.hpp"

#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <sstream>

#include "bench/cli/command.hpp"
#include "bench/run_folder.hpp"
#include "core/error.hpp"

namespace pathrace::bench::cli {
namespace {

struct LeaderboardCommand {
  std::string folder;
  std::string by;
  std::string csv;
  bool wide = false;
};

int leaderboard_command(const LeaderboardCommand& command) {
  if (!command.by.empty() && command.by != "family") {
    throw InputError("--by: expected family, got '" + command.by + "'");
  }
  const results::Store store = open_store({command.folder});
  const auto standings =
      results::leaderboard(store, command.by.empty() ? results::Grouping::all : results::Grouping::family);
  if (!command.csv.empty()) {
    std::ostringstream text;
    results::write_csv(text, standings);
    write_file(command.csv, text.str());
  }
  results::print_console(std::cout, standings, command.wide ? 0 : results::console_width);
  return done;
}

}  // namespace

void add_leaderboard(CLI::App& app) {
  auto command = std::make_shared<LeaderboardCommand>();
  CLI::App* options = add_command(app, "leaderboard", "print the leaderboard of a run, finished or not",
                                  "pathrace leaderboard runs/starter-1 --by family",
                                  [command] { return leaderboard_command(*command); });
  options->footer(fmt::format("{}\n{}", results::ranking_rule, options->get_footer()));
  options->add_option("folder", command->folder, "the folder of a run")->required()->type_name("DIR");
  options->add_option("--by", command->by, "one table per scenario family")->type_name("family");
  options->add_flag("--wide", command->wide, "every column and whole labels, however long the lines");
  options
      ->add_option("--csv", command->csv,
                   "write the table as CSV as well; a text that would be a formula gets a ' in front")
      ->type_name("FILE");
}

}  // namespace pathrace::bench::cli
