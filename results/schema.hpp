// The tables of a store, schema version 6.
//
// meta      name and value: campaign, toml, hash, seed, trials (planned), recorded (rows of `trial`)
// machine   name and value of what a session ran on: processor, system, compiler, libraries; a session is one
//           run that made or resumed the store, and counts from 1
// scenario  what trials share about their question
// reference what gaps count from, in cell edges, per scenario and track; null where there is proven no way
// question  what the map and the query of a scenario are; written when a run begins
// feature   name and value of a scenario's features, in long form: a new feature needs no new column
// planner   what trials share about their player, its budget included; `draws`: whether it draws random
// numbers trial     one slim row per trial; `number` counts in order of insertion; `steps` to `world_hash`
// are null
//           but for runs through dynamic worlds; `checksum` is of all that the view `trials` shows of it
// answer    the path, the anytime trace and the counters of a trial, as text, with their checksum
// trials    a view that joins scenario, planner and trial into the columns of trials.csv
// features  a view of the features under the scenarios' ids
//
// Keys and digests are sixteen hexadecimal digits. Columns of numbers that must come back bit for bit have no
// declared type: a column declared REAL turns -0.0 into 0, and one declared INTEGER rounds what exceeds
// 2^63 - 1, which counters and seeds may; they are then decimal text.
#pragma once

#include <cstdint>
#include <string>

namespace pathrace::results {

inline constexpr std::int32_t application_id = 0x70617468;  // "path", in the file's header
inline constexpr int schema_version = 6;
inline constexpr int oldest_schema_version = 5;

/// All statements that make an empty store, its numbers in the header included.
std::string schema();
/// Statements that let a connection read a store of version 5 as one of version 6, with null for what it does
/// not have; the file stays as it is.
std::string view_version_5();
/// Statements that make version 6 of a store of version 5; checksums stay null, to be filled in.
std::string migrate_version_5();

/// Every trial in order of insertion, with the columns of the view `trials`, followed by `checksum`.
std::string select_slim();
/// The same, followed by the columns `path_track`, `path`, `trace`, `counters` and their checksum.
std::string select_full();
/// The columns of an OutcomeCount.
std::string select_outcomes();
/// Every described scenario in order of insertion, a row per feature, or one without a name of a feature.
std::string select_scenarios();
/// The names of all features, in the order in which they were first stored.
std::string select_feature_names();

}  // namespace pathrace::results
