// From a ScenarioRow to the tables of the store.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include "results/references.hpp"
#include "results/row_writer.hpp"
#include "results/scenario_row.hpp"

namespace pathrace::results {

class ScenarioWriter {
 public:
  explicit ScenarioWriter(SQLite::Database& database);

  /// Writes the question and its features over what is there; features that the row does not name stay. The
  /// caller opens and commits the transaction. Throws SQLite::Exception,
  /// InputError as References::put does.
  void write(const ScenarioRow& row);
  /// To be called when the transaction was rolled back.
  void forget() {
    numbers_.forget();
    references_.forget();
  }

 private:
  ScenarioNumbers numbers_;
  References references_;
  SQLite::Statement put_question_;
  SQLite::Statement put_feature_;
};

}  // namespace pathrace::results
