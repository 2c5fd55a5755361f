#include "bench/run_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <sstream>

#include "bench/output_file.hpp"
#include "bench/roster.hpp"
#include "core/error.hpp"
#include "results/leaderboard.hpp"
#include "results/machine_csv.hpp"
#include "results/scenarios_csv.hpp"
#include "results/trials_csv.hpp"

namespace pathrace::bench {

namespace fs = std::filesystem;

namespace {

// A long file is streamed, never held in memory.
template <typename Write>
void stream_file(const fs::path& file, const Write& write) {
  OutputFile out(file);
  write(out.stream());
  out.commit();
}

}  // namespace

RunFolder next_free_folder(const std::string& campaign) {
  for (int n = 1;; ++n) {
    RunFolder folder{fs::path("runs") / fmt::format("{}-{}", campaign, n)};
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(folder.path, ignored))) return folder;
  }
}

void make_folder(const RunFolder& folder) {
  std::error_code error;
  if (fs::exists(folder.path, error) && !fs::is_directory(folder.path, error)) {
    throw InputError(fmt::format("{}: is a file; expected a folder for the results", folder.path.string()));
  }
  fs::create_directories(folder.path, error);
  if (error)
    throw EnvironmentError(fmt::format("{}: cannot be made: {}", folder.path.string(), error.message()));
  if (access(folder.path.c_str(), W_OK | X_OK) != 0) {
    throw EnvironmentError(
        fmt::format("{}: cannot be written: {}", folder.path.string(), std::strerror(errno)));
  }
}

void write_file(const fs::path& file, const std::string& text) {
  stream_file(file, [&text](std::ostream& out) { out << text; });
}

results::Store open_store(const RunFolder& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder.path, ignored)) {
    throw InputError(fmt::format("{}: no such folder; expected the folder of a run", folder.path.string()));
  }
  return results::Store::open(folder.store(), results::Access::read);
}

void write_tables(const RunFolder& folder, const results::Store& store) {
  std::ostringstream board;
  results::write_csv(board, results::leaderboard(store, results::Grouping::all));
  write_file(folder.leaderboard(), board.str());
  stream_file(folder.trials(), [&store](std::ostream& out) { results::write_trials_csv(out, store); });
  stream_file(folder.scenarios(), [&store](std::ostream& out) { results::write_scenarios_csv(out, store); });
  stream_file(folder.machine(), [&store](std::ostream& out) { results::write_machine_csv(out, store); });
}

TrialPlan plan_of(const results::Store& store) {
  const Campaign campaign = parse_campaign(store.identity().toml, "the store's campaign");
  const scenarios::Library library(campaign.maps);
  return plan_trials(campaign, library, roster());
}

}  // namespace pathrace::bench
