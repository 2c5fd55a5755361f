// The store: one SQLite file per campaign, written by one process, read by any number.
//
// Write-ahead log with synchronous = NORMAL: a batch that was appended survives a killed process, and readers
// never wait for the writer. Reads see the store as it was when they began. The tables are in schema.hpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <unordered_set>
#include <vector>

#include "core/record.hpp"
#include "results/outcome_count.hpp"
#include "results/row.hpp"
#include "results/scenario_row.hpp"

namespace pathrace::results {

/// What campaign a store belongs to.
struct StoreIdentity {
  std::string campaign;      ///< name
  std::string toml;          ///< the resolved campaign
  std::uint64_t hash = 0;    ///< of the campaign
  std::uint64_t seed = 0;    ///< of the campaign
  std::uint64_t trials = 0;  ///< planned

  friend bool operator==(const StoreIdentity&, const StoreIdentity&) = default;
};

/// Something that a session's times depend on: "processor", "compiler", ...
struct MachineFact {
  std::string name;
  std::string value;

  friend bool operator==(const MachineFact&, const MachineFact&) = default;
};

/// Of the library that reads and writes stores.
std::string sqlite_version();

enum class Access { read, append };

/// Every reading function throws InputError when the file turns out to be damaged; it names the file and,
/// where known, the trial's key; AlteredStore when a row was changed after it was recorded.
class Store {
 public:
  using Visit = std::function<void(const TrialRow&)>;
  using VisitFact = std::function<void(int session, const MachineFact&)>;
  using VisitScenario = std::function<void(const ScenarioRow&)>;

  /// An empty store, open for appending. Throws InputError when the file exists, EnvironmentError when it
  /// cannot be written.
  static Store create(const std::filesystem::path& file, const StoreIdentity& identity);
  /// Throws InputError when the file is missing, empty, not SQLite, damaged, not a pathrace store, of another
  /// schema version, or (to append) when another writer has it open; AlteredStore when rows are gone;
  /// EnvironmentError when it may not be read or written. A store of schema version 5 can be read as it is,
  /// and is migrated when it is opened to append.
  static Store open(const std::filesystem::path& file, Access access);

  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;
  ~Store();

  const std::filesystem::path& file() const;
  const StoreIdentity& identity() const;

  /// All rows or none. Throws std::logic_error when a key is already there, InputError when a row's optimum
  /// is not the one that is stored for its scenario and track, EnvironmentError when the disk is full or the
  /// file cannot be written.
  void append(const std::vector<TrialRow>& rows);

  /// Stores scenarios and their features, all or none, over what is there already; a feature that a row does
  /// not name is kept. Throws InputError and EnvironmentError as append does.
  void describe(const std::vector<ScenarioRow>& rows);

  /// Stores what the rows to come run on, and returns the number to put into TrialRow::session.
  int begin_session(const std::vector<MachineFact>& facts);

  /// Trials.
  std::uint64_t size() const;
  std::unordered_set<std::uint64_t> keys() const;
  std::vector<KeyedDigest> digests() const;
  /// Sorted by label, then by the verdict's name.
  std::vector<OutcomeCount> outcomes() const;
  /// Every row in order of insertion. The row that `visit` sees is overwritten by the next one.
  void for_each(const Visit& visit) const;
  /// The same, altered rows included.
  void inspect(const Visit& visit) const;
  /// As for_each, without path and trace: `answer` and `trace` stay empty. For tables over many rows.
  void for_each_slim(const Visit& visit) const;

  /// What each session ran on, session by session.
  void for_each_fact(const VisitFact& visit) const;

  /// Every described scenario with its features, in order of insertion.
  void for_each_scenario(const VisitScenario& visit) const;
  /// The names of all features that are stored, in the order of the first scenario.
  std::vector<std::string> feature_names() const;

 private:
  class Impl;
  explicit Store(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace pathrace::results
