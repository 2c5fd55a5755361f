// What gaps count from, into the store: one length per scenario and track, so that no two trials disagree.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/path.hpp"

namespace pathrace::results {

class References {
 public:
  explicit References(SQLite::Database& database);

  /// `length` in cell edges, or none where there is no way. Nothing is stored on the track `dynamic`, where
  /// runs count steps. Throws InputError that names scenario and track when another one is stored already.
  void put(std::int64_t scenario, const std::string& id, Track track, std::optional<double> length);
  /// After a rollback.
  void forget() { known_.clear(); }

 private:
  std::optional<double> stored(std::int64_t scenario, Track track, std::optional<double> length);

  SQLite::Statement find_;
  SQLite::Statement insert_;
  std::map<std::pair<std::int64_t, Track>, std::optional<double>> known_;
};

}  // namespace pathrace::results
