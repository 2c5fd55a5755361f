// From a row of the store to a TrialRow or a ScenarioRow, trusting nothing: the file may have been edited or
// damaged.
#pragma once

#include <SQLiteCpp/Statement.h>

#include "results/outcome_count.hpp"
#include "results/row.hpp"
#include "results/scenario_row.hpp"

namespace pathrace::results {

/// Reads the current row of select_slim() into `row`, path and trace excepted. Throws InputError that names
/// the column; `row.key` is then already read, unless it is the broken one. `row.altered` tells
/// whether they match their checksum.
void read_slim(SQLite::Statement& statement, TrialRow& row);
/// The same for select_full(), path and trace included.
void read_full(SQLite::Statement& statement, TrialRow& row);

/// Of path, trace and counters, from the current row of select_full().
std::uint64_t answer_checksum(SQLite::Statement& statement);

/// The current row of select_outcomes().
OutcomeCount read_outcome(SQLite::Statement& statement);

/// The question of the current row of select_scenarios(), and its feature if there is one.
void read_scenario(SQLite::Statement& statement, ScenarioRow& row);

}  // namespace pathrace::results
