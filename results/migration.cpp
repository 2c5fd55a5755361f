#include "results/migration.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "results/binder.hpp"
#include "results/columns.hpp"
#include "results/row_reader.hpp"
#include "results/schema.hpp"

namespace pathrace::results {
namespace {

// The checksums of a row's columns and of its answer, from a row of select_full().
std::pair<std::string, std::string> checksums(SQLite::Statement& statement, TrialRow& row) {
  read_full(statement, row);
  return {hex(checksum(row)), hex(answer_checksum(statement))};
}

void add_checksums(SQLite::Database& database) {
  SQLite::Statement select(database, select_full());
  SQLite::Statement trial(database, "UPDATE trial SET checksum = ? WHERE key = ?");
  SQLite::Statement answer(
      database, "UPDATE answer SET checksum = ? WHERE trial = (SELECT number FROM trial WHERE key = ?)");
  TrialRow row;
  while (select.executeStep()) {
    const auto [columns, texts] = checksums(select, row);
    const std::string key = hex(row.key);
    Binder(trial).text(columns).text(key);
    trial.exec();
    Binder(answer).text(texts).text(key);
    answer.exec();
  }
}

}  // namespace

void bring_up_to_date(const std::filesystem::path& file, SQLite::Database& database, int version,
                      Access access) {
  if (version == schema_version) return;
  if (access == Access::read) {
    database.exec(view_version_5());
    return;
  }
  SQLite::Transaction transaction(database);
  database.exec(migrate_version_5());
  try {
    add_checksums(database);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: cannot be migrated from schema version {}: {}", file.string(), version,
                                 error.what()));
  }
  transaction.commit();
}

}  // namespace pathrace::results
