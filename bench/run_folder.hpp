// The folder of a run: where results.db, campaign.toml and the tables lie.
#pragma once

#include <filesystem>
#include <string>

#include "bench/trial_plan.hpp"
#include "results/store.hpp"

namespace pathrace::bench {

struct RunFolder {
  std::filesystem::path path;

  std::filesystem::path store() const { return path / "results.db"; }
  std::filesystem::path campaign() const { return path / "campaign.toml"; }
  std::filesystem::path leaderboard() const { return path / "leaderboard.csv"; }
  std::filesystem::path trials() const { return path / "trials.csv"; }
  std::filesystem::path scenarios() const { return path / "scenarios.csv"; }
  std::filesystem::path machine() const { return path / "machine.csv"; }
};

/// `runs/<campaign>-<n>` with the least n >= 1 that does not exist yet.
RunFolder next_free_folder(const std::string& campaign);

/// Creates the folder. Throws InputError when the path is a file, EnvironmentError when it cannot be made or
/// written.
void make_folder(const RunFolder& folder);

/// Writes a whole file or leaves the old one (OutputFile). Throws EnvironmentError.
void write_file(const std::filesystem::path& file, const std::string& text);

/// The folder's store, for reading. Throws InputError when there is none.
results::Store open_store(const RunFolder& folder);

/// Writes leaderboard.csv, trials.csv, scenarios.csv and machine.csv from the store.
void write_tables(const RunFolder& folder, const results::Store& store);

/// Everything a store says about its campaign, looked up again. Throws InputError when the maps are gone.
TrialPlan plan_of(const results::Store& store);

}  // namespace pathrace::bench
