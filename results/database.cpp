#include "results/database.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <stdexcept>
#include <system_error>

#include "core/hash.hpp"
#include "results/altered_store.hpp"
#include "results/migration.hpp"
#include "results/number_text.hpp"
#include "results/schema.hpp"

namespace pathrace::results {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t smallest_page = 512;  // of any SQLite file, in bytes
constexpr int patience_ms = 10'000;            // how long to wait for a lock held by another process

InputError not_a_database(const fs::path& file) {
  return InputError(fmt::format(
      "{}: not an SQLite database, or one with a damaged header; expected a pathrace store", file.string()));
}

void write_meta(SQLite::Database& database, const StoreIdentity& identity) {
  SQLite::Statement insert(database, "INSERT INTO meta (name, value) VALUES (?, ?)");
  const auto put = [&insert](const char* name, const std::string& value) {
    insert.reset();
    insert.bind(1, name);
    insert.bind(2, value);
    insert.exec();
  };
  put("campaign", identity.campaign);
  put("toml", identity.toml);
  put("hash", hex(identity.hash));
  put("seed", std::to_string(identity.seed));
  put("trials", std::to_string(identity.trials));
  put("recorded", "0");
}

void write_empty_store(const fs::path& file, const StoreIdentity& identity) {
  SQLite::Database database(file, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  SQLite::Transaction transaction(database);
  database.exec(schema());
  write_meta(database, identity);
  transaction.commit();
}

void remove_quietly(fs::path file) {
  std::error_code ignored;
  fs::remove(file, ignored);
  file += "-journal";
  fs::remove(file, ignored);
}

std::string reason(int error) {
  return std::generic_category().message(error);
}

int header_number(const SQLite::Database& database, const char* pragma) {
  SQLite::Statement statement(database, fmt::format("PRAGMA {}", pragma));
  statement.executeStep();
  return statement.getColumn(0).getInt();
}

// Returns the version.
int require_our_schema(const fs::path& file, const SQLite::Database& database) {
  const int application = header_number(database, "application_id");
  const int version = header_number(database, "user_version");
  if (application != application_id) {
    throw InputError(fmt::format(
        "{}: an SQLite database, but not a pathrace store (application id {:#x}, expected {:#x})",
        file.string(), static_cast<unsigned>(application), static_cast<unsigned>(application_id)));
  }
  if (version < oldest_schema_version || version > schema_version) {
    throw InputError(fmt::format("{}: a pathrace store of schema version {}; this program expects version {}",
                                 file.string(), version, schema_version));
  }
  return version;
}

// A reader opens for writing too where it may: then the last one out folds the log of a killed run into the
// store. SQLite itself falls back to read-only.
SQLite::Database connect(const fs::path& file) {
  SQLite::Database database(file, SQLite::OPEN_READWRITE, patience_ms);
  header_number(database, "schema_version");  // opening is lazy: this reads the header and finds the log
  return database;
}

std::string uri_of(const fs::path& file) {
  std::string uri = "file:";
  for (const char byte : fs::absolute(file).string()) {
    const bool plain = (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') ||
                       (byte >= '0' && byte <= '9') || byte == '/' || byte == '.' || byte == '-' ||
                       byte == '_';
    uri += plain ? std::string(1, byte) : fmt::format("%{:02X}", static_cast<unsigned char>(byte));
  }
  return uri;
}

// In a folder that cannot be written SQLite cannot make the files beside a store in WAL mode; nobody can
// change such a store either, so it may be read as it is, unless a log says that it is not all.
SQLite::Database connect_immutable(const fs::path& file) {
  fs::path log = file;
  log += "-wal";
  std::error_code ignored;
  if (fs::exists(log, ignored) && fs::file_size(log, ignored) > 0) {
    throw EnvironmentError(fmt::format(
        "{}: a killed run left its last rows in {}, which cannot be read in a folder without write "
        "permission; copy both to another folder",
        file.string(), log.filename().string()));
  }
  return SQLite::Database(uri_of(file) + "?immutable=1", SQLite::OPEN_READONLY | SQLite::OPEN_URI);
}

SQLite::Database connect_to_read(const fs::path& file) {
  try {
    return connect(file);
  } catch (const SQLite::Exception& error) {
    if (error.getErrorCode() != SQLITE_CANTOPEN && error.getErrorCode() != SQLITE_READONLY) throw;
  }
  return connect_immutable(file);
}

void prepare_to_append(const fs::path& file, SQLite::Database& database) {
  if (sqlite3_db_readonly(database.getHandle(), "main") != 0) {
    throw EnvironmentError(fmt::format("{}: cannot be written ({})", file.string(), reason(EACCES)));
  }
  try {
    database.exec("PRAGMA journal_mode = WAL");
    database.exec("PRAGMA synchronous = NORMAL");
  } catch (const SQLite::Exception& error) {
    throw_writing_error(file, error);
  }
}

std::string meta_value(const SQLite::Database& database, const std::string& name) {
  SQLite::Statement select(database, "SELECT value FROM meta WHERE name = ?");
  select.bind(1, name);
  if (!select.executeStep()) throw InputError(fmt::format("table 'meta' has no '{}'", name));
  return select.getColumn(0).getString();
}

template <typename Parse>
auto parsed_meta(const SQLite::Database& database, const std::string& name, const Parse& parse) {
  const std::string value = meta_value(database, name);
  try {
    return parse(value);
  } catch (const InputError& error) {
    throw InputError(fmt::format("'{}' in table 'meta': {}", name, error.what()));
  }
}

}  // namespace

void require_readable_file(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) {
    throw InputError(fmt::format("{}: no such file; expected a pathrace store", file.string()));
  }
  if (error || ::faccessat(AT_FDCWD, file.c_str(), R_OK, AT_EACCESS) != 0) {
    throw EnvironmentError(
        fmt::format("{}: cannot be read ({})", file.string(), error ? error.message() : reason(errno)));
  }
  if (!fs::is_regular_file(status)) {
    throw InputError(fmt::format("{}: not a file; expected a pathrace store", file.string()));
  }
  const std::uintmax_t size = fs::file_size(file, error);
  if (size == 0 && !error) {
    throw InputError(fmt::format("{}: empty file; expected a pathrace store", file.string()));
  }
  if (size < smallest_page) throw not_a_database(file);  // SQLite would take it for a new, empty database
}

void create_database(const fs::path& file, const StoreIdentity& identity) {
  fs::path draft = file;
  draft += "-new";
  remove_quietly(draft);
  try {
    write_empty_store(draft, identity);
    fs::rename(draft, file);
  } catch (const SQLite::Exception& error) {
    remove_quietly(draft);
    throw_writing_error(file, error);
  } catch (const fs::filesystem_error& error) {
    remove_quietly(draft);
    throw EnvironmentError(fmt::format("{}: cannot be written ({})", file.string(), error.code().message()));
  }
}

SQLite::Database open_database(const fs::path& file, Access access) {
  require_readable_file(file);
  try {
    SQLite::Database database = access == Access::read ? connect_to_read(file) : connect(file);
    const int version = require_our_schema(file, database);
    if (access == Access::append) prepare_to_append(file, database);
    bring_up_to_date(file, database, version, access);
    if (access == Access::read) database.exec("PRAGMA query_only = 1");
    return database;
  } catch (const SQLite::Exception& error) {
    throw reading_error(file, error);
  }
}

StoreIdentity read_identity(const SQLite::Database& database) {
  StoreIdentity identity;
  identity.campaign = meta_value(database, "campaign");
  identity.toml = meta_value(database, "toml");
  identity.hash = parsed_meta(database, "hash", parse_hex);
  identity.seed = parsed_meta(database, "seed", parse_count);
  identity.trials = parsed_meta(database, "trials", parse_count);
  return identity;
}

std::uint64_t require_all_rows(const SQLite::Database& database, std::uint64_t noted) {
  // One statement, since a writer may append between two.
  SQLite::Statement select(database,
                           "SELECT value, (SELECT count(*) FROM trial) FROM meta WHERE name = 'recorded'");
  if (!select.executeStep()) throw InputError("table 'meta' has no 'recorded'");
  const std::string recorded = select.getColumn(0).getString();
  const auto rows = static_cast<std::uint64_t>(select.getColumn(1).getInt64());
  if (std::to_string(rows) != recorded) {
    throw AlteredStore(fmt::format("holds {} trials where {} were recorded", rows, recorded));
  }
  if (rows < noted) {
    throw AlteredStore(fmt::format(
        "holds {} trials where a killed run had recorded {}: put its results.db-wal back, or delete "
        "results.db-lock to go on with what is left",
        rows, noted));
  }
  return rows;
}

void count_recorded(SQLite::Database& database, std::size_t rows) {
  SQLite::Statement update(database,
                           "UPDATE meta SET value = CAST(CAST(value AS INTEGER) + ? AS TEXT) "
                           "WHERE name = 'recorded'");
  update.bind(1, static_cast<std::int64_t>(rows));
  update.exec();
}

InputError reading_error(const fs::path& file, const SQLite::Exception& error, std::uint64_t last_key) {
  if (error.getErrorCode() == SQLITE_NOTADB) {
    return InputError(
        fmt::format("{}: not an SQLite database, or one with a damaged header; expected a "
                    "pathrace store",
                    file.string()));
  }
  const std::string place = last_key == 0 ? "" : fmt::format(" after the row with key {}", hex(last_key));
  return InputError(fmt::format("{}: the store is damaged{} ({})", file.string(), place, error.what()));
}

void throw_writing_error(const fs::path& file, const SQLite::Exception& error) {
  switch (error.getErrorCode()) {
    case SQLITE_CONSTRAINT:
      throw std::logic_error(
          fmt::format("{}: a row breaks a rule of the store ({})", file.string(), error.what()));
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB: throw reading_error(file, error);
    default: throw EnvironmentError(fmt::format("{}: cannot be written ({})", file.string(), error.what()));
  }
}

}  // namespace pathrace::results
