// The tables of a store, schema version 1.
//
// meta      name and value: campaign, toml, hash, seed, trials
// scenario  what trials share about their question
// planner   what trials share about their player, its budget included
// trial     one slim row per trial; `number` counts in order of insertion
// answer    the path and the anytime trace of a trial, as text
// trials    a view that joins the first four into the columns of trials.csv
//
// Keys and digests are sixteen hexadecimal digits. Columns of numbers that must come back bit for bit have no
// declared type: a column declared REAL turns -0.0 into 0, and one declared INTEGER rounds what exceeds
// 2^63 - 1, which counters and seeds may; they are then decimal text.
#pragma once

#include <cstdint>
#include <string>

namespace pathrace::results {

inline constexpr std::int32_t application_id = 0x70617468;  // "path", in the file's header
inline constexpr int schema_version = 1;

/// All statements that make an empty store, its numbers in the header included.
std::string schema();

/// Every trial in order of insertion, with the columns of the view `trials`.
std::string select_slim();
/// The same, followed by the columns `path_track`, `path` and `trace`.
std::string select_full();
/// The columns `key`, `digest` and `timed` alone.
std::string select_digests();

}  // namespace pathrace::results
