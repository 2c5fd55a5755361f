// Stores of older schema versions, to be read or gone on with.
#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>

#include "results/store.hpp"

namespace pathrace::results {

/// Makes a store of version `version`, 5 or 6, one of the current version: to append, in the file, all or
/// nothing; to read, for this connection alone. Throws SQLite::Exception, InputError that names the file when
/// a row is damaged.
void bring_up_to_date(const std::filesystem::path& file, SQLite::Database& database, int version,
                      Access access);

}  // namespace pathrace::results
