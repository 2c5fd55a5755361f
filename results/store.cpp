#include "results/store.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "results/altered_store.hpp"
#include "results/binder.hpp"
#include "results/columns.hpp"
#include "results/database.hpp"
#include "results/number_text.hpp"
#include "results/quote.hpp"
#include "results/row_reader.hpp"
#include "results/row_writer.hpp"
#include "results/scenario_writer.hpp"
#include "results/schema.hpp"
#include "results/writer_lock.hpp"

namespace pathrace::results {

namespace fs = std::filesystem;

// Members end in reverse order: the statements of the writer, the connection, then the lock.
class Store::Impl {
 public:
  Impl(fs::path where, std::unique_ptr<WriterLock> held, Access access)
      : file(std::move(where)),
        lock(std::move(held)),
        noted(WriterLock::noted(file)),
        database(open_database(file, access)) {
    try {
      identity = read_identity(database);
      rows = require_all_rows(database, noted);
      if (access == Access::append) {
        writer.emplace(database);
        describer.emplace(database);
      }
    } catch (const SQLite::Exception& error) {
      throw reading_error(file, error);
    } catch (const AlteredStore& error) {
      throw AlteredStore(fmt::format("{}: {}", file.string(), error.what()));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: the store is damaged: {}", file.string(), error.what()));
    }
  }

  // Steps through a query; `use` gets the statement at each row and the key of the row before, to update.
  template <typename Use>
  void scan(const std::string& sql, const Use& use) const {
    std::uint64_t last_key = 0;
    try {
      SQLite::Statement statement(database, sql);
      while (statement.executeStep()) use(statement, last_key);
    } catch (const SQLite::Exception& error) {
      throw reading_error(file, error, last_key);
    }
  }

  template <typename Read>
  void visit_rows(const std::string& sql, const Read& read, const Visit& visit) const {
    TrialRow row;  // one for all, so that its strings keep their memory
    scan(sql, [&](SQLite::Statement& statement, std::uint64_t& last_key) {
      row.key = 0;
      read_or_name(statement, read, row, last_key);
      last_key = row.key;
      visit(row);
    });
  }

  Visit unaltered(const Visit& visit) const {
    return [this, &visit](const TrialRow& row) {
      if (row.altered) {
        throw AlteredStore(fmt::format("{}: the row with key {} was changed after it was recorded",
                                       file.string(), hex(row.key)));
      }
      visit(row);
    };
  }

  const fs::path file;
  std::unique_ptr<WriterLock> lock;
  const std::uint64_t noted;  // read before the rows are counted, since a writer may be at work
  SQLite::Database database;
  StoreIdentity identity;
  std::uint64_t rows = 0;  // the writer's
  std::optional<RowWriter> writer;
  std::optional<ScenarioWriter> describer;

  // A transaction of the one writer; `body` throws SQLite::Exception or InputError, and all is as before.
  template <typename Body>
  void transact(const Body& body) {
    if (!writer) throw std::logic_error("append to a store that was opened to be read");
    try {
      SQLite::Transaction transaction(database);
      body();
      transaction.commit();
    } catch (const SQLite::Exception& error) {
      forget();
      throw_writing_error(file, error);
    } catch (const InputError& error) {
      forget();
      throw InputError(fmt::format("{}: {}", file.string(), error.what()));
    } catch (...) {
      forget();
      throw;
    }
  }

 private:
  // Numbers of rows that were rolled back name nothing.
  void forget() {
    writer->forget();
    describer->forget();
  }

  template <typename Read>
  void read_or_name(SQLite::Statement& statement, const Read& read, TrialRow& row,
                    std::uint64_t last_key) const {
    try {
      read(statement, row);
    } catch (const InputError& error) {
      const std::string place = row.key != 0 ? fmt::format("row with key {}", hex(row.key))
                                             : fmt::format("row after key {}", hex(last_key));
      throw InputError(fmt::format("{}: damaged {}: {}", file.string(), place, error.what()));
    }
  }
};

Store::Store(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

Store Store::create(const fs::path& file, const StoreIdentity& identity) {
  std::error_code error;
  if (fs::exists(fs::symlink_status(file, error))) {
    throw InputError(fmt::format("{}: already exists; expected a new file", file.string()));
  }
  auto lock = std::make_unique<WriterLock>(file);
  create_database(file, identity);
  return Store(std::make_unique<Impl>(file, std::move(lock), Access::append));
}

Store Store::open(const fs::path& file, Access access) {
  if (access == Access::read) return Store(std::make_unique<Impl>(file, nullptr, access));
  require_readable_file(file);
  return Store(std::make_unique<Impl>(file, std::make_unique<WriterLock>(file), access));
}

std::string sqlite_version() {
  return SQLite::getLibVersion();
}

const fs::path& Store::file() const {
  return impl_->file;
}
const StoreIdentity& Store::identity() const {
  return impl_->identity;
}

void Store::append(const std::vector<TrialRow>& rows) {
  impl_->transact([&] {
    for (const TrialRow& row : rows) impl_->writer->write(row);
    count_recorded(impl_->database, rows.size());
  });
  impl_->rows += rows.size();
  impl_->lock->note(impl_->rows);
}

void Store::describe(const std::vector<ScenarioRow>& rows) {
  impl_->transact([&] {
    for (const ScenarioRow& row : rows) impl_->describer->write(row);
  });
}

int Store::begin_session(const std::vector<MachineFact>& facts) {
  int session = 0;
  impl_->transact([&] {
    SQLite::Statement next(impl_->database, "SELECT ifnull(max(session), 0) + 1 FROM machine");
    next.executeStep();
    session = next.getColumn(0).getInt();
    SQLite::Statement insert(impl_->database, "INSERT INTO machine (session, name, value) VALUES (?, ?, ?)");
    for (const MachineFact& fact : facts) {
      Binder(insert).integer(std::int64_t{session}).text(fact.name).text(fact.value);
      insert.exec();
    }
  });
  return session;
}

std::uint64_t Store::size() const {
  std::int64_t count = 0;
  impl_->scan("SELECT count(*) FROM trial", [&](SQLite::Statement& statement, std::uint64_t&) {
    count = statement.getColumn(0).getInt64();
  });
  return static_cast<std::uint64_t>(count);
}

std::unordered_set<std::uint64_t> Store::keys() const {
  std::unordered_set<std::uint64_t> keys;
  for (const KeyedDigest& row : digests()) keys.insert(row.key);
  return keys;
}

std::vector<KeyedDigest> Store::digests() const {
  std::vector<KeyedDigest> digests;
  for_each_slim([&digests](const TrialRow& row) { digests.push_back({row.key, row.digest, row.timed}); });
  return digests;
}

std::vector<OutcomeCount> Store::outcomes() const {
  std::vector<OutcomeCount> outcomes;
  impl_->scan(select_outcomes(), [&](SQLite::Statement& statement, std::uint64_t&) {
    try {
      outcomes.push_back(read_outcome(statement));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: damaged: {}", impl_->file.string(), error.what()));
    }
  });
  return outcomes;
}

void Store::for_each(const Visit& visit) const {
  impl_->visit_rows(select_full(), read_full, impl_->unaltered(visit));
}
void Store::for_each_slim(const Visit& visit) const {
  impl_->visit_rows(select_slim(), read_slim, impl_->unaltered(visit));
}
void Store::inspect(const Visit& visit) const {
  impl_->visit_rows(select_full(), read_full, visit);
}

void Store::for_each_fact(const VisitFact& visit) const {
  impl_->scan("SELECT session, name, value FROM machine ORDER BY session, name",
              [&](SQLite::Statement& statement, std::uint64_t&) {
                Columns columns(statement);
                const int session = columns.integer();
                const std::string name(columns.text());
                visit(session, {name, std::string(columns.text())});
              });
}

void Store::for_each_scenario(const VisitScenario& visit) const {
  std::optional<ScenarioRow> whole;
  impl_->scan(select_scenarios(), [&](SQLite::Statement& statement, std::uint64_t&) {
    ScenarioRow row;
    try {
      read_scenario(statement, row);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: damaged scenario {}: {}", impl_->file.string(),
                                   results::quoted(row.id), error.what()));
    }
    if (whole && row.id == whole->id && row.rule == whole->rule && row.hash == whole->hash) {
      whole->features.insert(whole->features.end(), row.features.begin(), row.features.end());
      return;
    }
    if (whole) visit(*whole);
    whole = std::move(row);
  });
  if (whole) visit(*whole);
}

std::vector<std::string> Store::feature_names() const {
  std::vector<std::string> names;
  impl_->scan(select_feature_names(), [&](SQLite::Statement& statement, std::uint64_t&) {
    names.push_back(statement.getColumn(0).getString());
  });
  return names;
}

}  // namespace pathrace::results
