// The file below a store: making it, opening it, and saying what is wrong with it.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>

#include <cstdint>
#include <filesystem>

#include "core/error.hpp"
#include "results/store.hpp"

namespace pathrace::results {

/// Makes a complete store under another name first, so that a killed process leaves no half of one.
void create_database(const std::filesystem::path& file, const StoreIdentity& identity);

/// Throws InputError or EnvironmentError unless there is something to open. Does not open it itself: closing
/// it again would drop the locks of a connection of this process.
void require_readable_file(const std::filesystem::path& file);

/// Opens and checks the header. Throws as Store::open does.
SQLite::Database open_database(const std::filesystem::path& file, Access access);

/// Throws SQLite::Exception or InputError.
StoreIdentity read_identity(const SQLite::Database& database);

/// Returns the number of trials. Throws AlteredStore unless it is the number that was recorded, and at least
/// the number that the last writer noted (WriterLock). Throws SQLite::Exception.
std::uint64_t require_all_rows(const SQLite::Database& database, std::uint64_t noted);
/// Adds to the number of recorded trials; the caller opens and commits the transaction.
void count_recorded(SQLite::Database& database, std::size_t rows);

/// What an SQLite error means to a reader, after the row with this key (0: none yet), and to a writer.
InputError reading_error(const std::filesystem::path& file, const SQLite::Exception& error,
                         std::uint64_t last_key = 0);
[[noreturn]] void throw_writing_error(const std::filesystem::path& file, const SQLite::Exception& error);

}  // namespace pathrace::results
