#include "results/schema.hpp"

#include <fmt/format.h>

namespace pathrace::results {
namespace {

constexpr const char* tables = R"(
CREATE TABLE meta (name TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE machine (
  session INTEGER NOT NULL, name TEXT NOT NULL, value TEXT NOT NULL, PRIMARY KEY (session, name)) WITHOUT ROWID;
CREATE TABLE scenario (number INTEGER PRIMARY KEY, id TEXT NOT NULL, rule TEXT NOT NULL);
CREATE INDEX scenario_by_id ON scenario (id);
CREATE TABLE reference (
  scenario INTEGER NOT NULL REFERENCES scenario (number), track TEXT NOT NULL, length,
  PRIMARY KEY (scenario, track)) WITHOUT ROWID;
CREATE TABLE question (
  scenario INTEGER PRIMARY KEY REFERENCES scenario (number), width INTEGER NOT NULL, height INTEGER NOT NULL,
  start_x INTEGER NOT NULL, start_y INTEGER NOT NULL, goal_x INTEGER NOT NULL, goal_y INTEGER NOT NULL,
  hash TEXT NOT NULL);
CREATE TABLE feature (
  scenario INTEGER NOT NULL REFERENCES scenario (number), name TEXT NOT NULL, value,
  UNIQUE (scenario, name));
CREATE VIEW features AS SELECT s.id AS scenario, s.rule AS rule, f.name AS name, f.value AS value
  FROM feature AS f LEFT JOIN scenario AS s ON s.number = f.scenario;
CREATE TABLE planner (
  number INTEGER PRIMARY KEY, label TEXT NOT NULL, call TEXT NOT NULL, version INTEGER NOT NULL,
  track TEXT NOT NULL, budget TEXT NOT NULL, draws INTEGER);
CREATE INDEX planner_by_label ON planner (label);
CREATE TABLE trial (
  number INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE,
  scenario INTEGER NOT NULL REFERENCES scenario (number),
  planner INTEGER NOT NULL REFERENCES planner (number),
  repetition NOT NULL, seed NOT NULL, verdict TEXT NOT NULL, note TEXT NOT NULL,
  length, gap, turns INTEGER, turn_angle, clearance_min, clearance_mean,
  evaluations NOT NULL, iterations NOT NULL, checks NOT NULL, digest TEXT NOT NULL, timed INTEGER NOT NULL,
  wall_s NOT NULL, setup_s NOT NULL, backend TEXT NOT NULL, threads INTEGER NOT NULL,
  threads_used INTEGER NOT NULL, crowded INTEGER NOT NULL,
  steps, travelled, collisions, struck, min_clearance, oscillations, world_hash TEXT, least_steps,
  step_ms_median, step_ms_p99, user_s, system_s, session INTEGER NOT NULL, checksum TEXT);
CREATE TABLE answer (
  trial INTEGER PRIMARY KEY REFERENCES trial (number), path_track TEXT, path TEXT, trace TEXT NOT NULL,
  counters TEXT NOT NULL, checksum TEXT);
)";

constexpr const char* slim_columns =
    "t.key AS key, s.id AS scenario, p.label AS planner, t.repetition AS repetition, t.seed AS seed, "
    "t.verdict AS verdict, p.track AS track, t.length AS length, r.length AS optimum, t.gap AS gap, "
    "t.turns AS turns, t.evaluations AS evaluations, t.iterations AS iterations, t.checks AS checks, "
    "t.digest AS digest, t.wall_s AS wall_s, s.rule AS rule, p.call AS call, p.version AS version, "
    "p.budget AS budget, t.note AS note, t.turn_angle AS turn_angle, t.clearance_min AS clearance_min, "
    "t.clearance_mean AS clearance_mean, t.timed AS timed, t.setup_s AS setup_s, t.backend AS backend, "
    "t.threads AS threads, t.threads_used AS threads_used, t.crowded AS crowded, "
    "t.steps AS steps, t.travelled AS travelled, t.collisions AS collisions, t.struck AS struck, "
    "t.min_clearance AS min_clearance, t.oscillations AS oscillations, t.world_hash AS world_hash, "
    "t.least_steps AS least_steps, t.step_ms_median AS step_ms_median, t.step_ms_p99 AS step_ms_p99, "
    "t.user_s AS user_s, t.system_s AS system_s, t.session AS session, p.draws AS draws";

// Left joins: a trial whose scenario, planner or answer is gone shows up with nulls and is reported.
constexpr const char* joined =
    "trial AS t LEFT JOIN scenario AS s ON s.number = t.scenario LEFT JOIN planner AS p ON p.number = "
    "t.planner LEFT JOIN reference AS r ON r.scenario = t.scenario AND r.track = p.track";

std::string view_of_trials() {
  return fmt::format("CREATE VIEW trials AS SELECT {} FROM {};", slim_columns, joined);
}

}  // namespace

std::string schema() {
  return fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {};\n{}\n{}", application_id,
                     schema_version, tables, view_of_trials());
}

// Views in the schema `temp` stand before tables of the same name in the file.
std::string view_version_5() {
  return R"(
CREATE TEMP VIEW meta AS
  SELECT * FROM main.meta UNION ALL SELECT 'recorded', CAST(count(*) AS TEXT) FROM main.trial;
CREATE TEMP VIEW machine AS SELECT 0 AS session, '' AS name, '' AS value WHERE 0;
CREATE TEMP VIEW planner AS SELECT *, NULL AS draws FROM main.planner;
CREATE TEMP VIEW trial AS
  SELECT *, NULL AS user_s, NULL AS system_s, 0 AS session, NULL AS checksum FROM main.trial;
CREATE TEMP VIEW answer AS SELECT *, NULL AS checksum FROM main.answer;
)";
}

std::string migrate_version_5() {
  return fmt::format(R"(
DROP VIEW trials;
CREATE TABLE machine (
  session INTEGER NOT NULL, name TEXT NOT NULL, value TEXT NOT NULL, PRIMARY KEY (session, name)) WITHOUT ROWID;
ALTER TABLE planner ADD COLUMN draws INTEGER;
ALTER TABLE trial ADD COLUMN user_s;
ALTER TABLE trial ADD COLUMN system_s;
ALTER TABLE trial ADD COLUMN session INTEGER NOT NULL DEFAULT 0;
ALTER TABLE trial ADD COLUMN checksum TEXT;
ALTER TABLE answer ADD COLUMN checksum TEXT;
INSERT INTO meta (name, value) SELECT 'recorded', CAST(count(*) AS TEXT) FROM trial;
PRAGMA user_version = {};
{})",
                     schema_version, view_of_trials());
}

std::string select_slim() {
  return fmt::format("SELECT {}, t.checksum AS checksum FROM {} ORDER BY t.number", slim_columns, joined);
}

std::string select_full() {
  return fmt::format(
      "SELECT {}, t.checksum AS checksum, a.path_track AS path_track, a.path AS path, a.trace AS trace, "
      "a.counters AS counters, a.checksum AS answer_checksum FROM {} "
      "LEFT JOIN answer AS a ON a.trial = t.number ORDER BY t.number",
      slim_columns, joined);
}

std::string select_outcomes() {
  return "SELECT p.label AS planner, t.verdict AS verdict, t.note <> '' AS noted, count(*) AS trials "
         "FROM trial AS t LEFT JOIN planner AS p ON p.number = t.planner GROUP BY 1, 2, 3 ORDER BY 1, 2, 3";
}

std::string select_scenarios() {
  return "SELECT s.id AS id, s.rule AS rule, l.length AS optimum, a.length AS any_angle_optimum, q.width AS "
         "width, q.height AS height, "
         "q.start_x AS start_x, q.start_y AS start_y, q.goal_x AS goal_x, q.goal_y AS goal_y, "
         "q.hash AS hash, f.name AS name, f.value AS value "
         "FROM question AS q LEFT JOIN scenario AS s ON s.number = q.scenario "
         "LEFT JOIN reference AS l ON l.scenario = q.scenario AND l.track = 'lattice' "
         "LEFT JOIN reference AS a ON a.scenario = q.scenario AND a.track = 'any_angle' "
         "LEFT JOIN feature AS f ON f.scenario = q.scenario ORDER BY q.scenario, f.rowid";
}

std::string select_feature_names() {
  return "SELECT name FROM feature GROUP BY name ORDER BY min(rowid)";
}

}  // namespace pathrace::results
