// `verify`: runs a store's trials again and compares.
#include "bench/verify.hpp"

#include <fmt/format.h>

#include <memory>

#include "bench/cli/command.hpp"
#include "bench/cli/options.hpp"
#include "bench/run_folder.hpp"
#include "core/error.hpp"
#include "results/altered_store.hpp"

namespace pathrace::bench::cli {
namespace {

struct VerifyCommand {
  std::string folder;
  std::optional<std::size_t> sample;
  RunOptions options;
};

int compare_rows(const VerifyCommand& command) {
  require_backend(command.options);
  const results::Store store = open_store({command.folder});
  const TrialPlan plan = plan_of(store);
  if (plan.hash() != store.identity().hash) {
    fmt::print(stderr, "note: the campaign's trials are named differently by this version of pathrace\n");
  }
  const Verification result = verify(store, plan, command.sample, command.options);
  for (const std::string& difference : result.differences) fmt::print("{}\n", difference);
  fmt::print("{} of {} planned trials recorded, {} run again, {} skipped: {}\n", result.rows, plan.size(),
             result.rerun, result.skipped,
             result.differences.empty() ? "all equal" : fmt::format("{} differ", result.differences.size()));
  return result.differences.empty() ? done : something_found;
}

int verify_command(const VerifyCommand& command) {
  try {
    return compare_rows(command);
  } catch (const results::AlteredStore& loss) {
    fmt::print("{}\n", loss.what());
    return something_found;
  }
}

}  // namespace

void add_verify(CLI::App& app) {
  auto command = std::make_shared<VerifyCommand>();
  CLI::App* options = add_command(app, "verify", "run recorded trials again and compare everything but costs",
                                  "pathrace verify runs/starter-1 --sample 100",
                                  [command] { return verify_command(*command); });
  options->add_option("folder", command->folder, "the folder of a run")->required()->type_name("DIR");
  options
      ->add_option_function<std::size_t>(
          "--sample", [command](std::size_t n) { command->sample = n; },
          "run only so many trials again, spread evenly")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000'000}))
      ->type_name("N");
  add_executor_options(*options, command->options, true);
}

}  // namespace pathrace::bench::cli
