// From a TrialRow to the tables of the store.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <functional>
#include <string>
#include <unordered_map>

#include "results/references.hpp"
#include "results/row.hpp"

namespace pathrace::results {

/// Numbers what many trials share: the number of an equal row of a small table, made when there is none.
class Interner {
 public:
  using Bind = std::function<void(SQLite::Statement&)>;

  /// Both statements take the same values in the same order.
  Interner(SQLite::Database& database, const std::string& find, const std::string& insert);

  std::int64_t number(const std::string& identity, const Bind& bind);
  /// After a rollback: numbers given since then name nothing.
  void forget() { known_.clear(); }

 private:
  SQLite::Database& database_;
  SQLite::Statement find_;
  SQLite::Statement insert_;
  std::unordered_map<std::string, std::int64_t> known_;
};

/// Numbers of the scenarios that trials and features belong to.
class ScenarioNumbers {
 public:
  explicit ScenarioNumbers(SQLite::Database& database);

  std::int64_t number(const std::string& id, MoveRule rule);
  void forget() { interner_.forget(); }

 private:
  Interner interner_;
};

class RowWriter {
 public:
  explicit RowWriter(SQLite::Database& database);

  /// Inserts one row; the caller opens and commits the transaction. Throws SQLite::Exception,
  /// InputError as References::put does.
  void write(const TrialRow& row);
  /// To be called when the transaction was rolled back.
  void forget();

 private:
  std::int64_t planner_number(const TrialRow& row);
  void write_trial(const TrialRow& row);
  void write_answer(const TrialRow& row);

  SQLite::Database& database_;
  ScenarioNumbers scenarios_;
  References references_;
  Interner planners_;
  SQLite::Statement insert_trial_;
  SQLite::Statement insert_answer_;
};

}  // namespace pathrace::results
