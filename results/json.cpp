#include "results/json.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

#include "core/hash.hpp"

namespace pathrace::results {
namespace {

using Json = nlohmann::ordered_json;

template <typename T>
Json nullable(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

template <typename T>
Json nullable(const T& value) {
  return Json(value);
}

// Whole numbers without ".0": cells are integers.
Json coordinate(double value) {
  constexpr double exact_integers = 0x1p53;
  const bool whole = std::fabs(value) < exact_integers && std::trunc(value) == value;
  return whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

Json points_of(const Answer& answer) {
  if (!answer) return nullptr;
  Json points = Json::array();
  for (const Point point : answer->points) points.push_back({coordinate(point.x), coordinate(point.y)});
  return points;
}

void add_run(Json& object, const TrialRow& row) {
  const auto figure = [&row](auto member) { return row.run ? nullable((*row.run).*member) : Json(nullptr); };
  object["steps"] = figure(&RunMetrics::steps);
  object["least_steps"] = nullable(row.least_steps);
  object["travelled"] = figure(&RunMetrics::travelled);
  object["collisions"] = figure(&RunMetrics::collisions);
  object["struck"] = figure(&RunMetrics::struck);
  object["min_clearance"] = figure(&RunMetrics::min_clearance);
  object["oscillations"] = figure(&RunMetrics::oscillations);
  object["world_hash"] = row.run ? Json(hex(row.run->world_hash)) : Json(nullptr);
  object["step_ms_median"] = nullable(row.costs.step_ms_median);
  object["step_ms_p99"] = nullable(row.costs.step_ms_p99);
}

Json place_of(PlaceInMetres place) {
  return {place.x, place.y};
}

void add_metres(Json& object, const std::optional<InMetres>& metres) {
  for (const char* key : {"length_m", "start_m", "goal_m", "points_m"}) object[key] = nullptr;
  if (!metres) return;
  object["length_m"] = nullable(metres->length);
  object["start_m"] = place_of(metres->start);
  object["goal_m"] = place_of(metres->goal);
  if (!metres->points) return;
  object["points_m"] = Json::array();
  for (const PlaceInMetres place : *metres->points) object["points_m"].push_back(place_of(place));
}

Json object_of(const TrialRow& row, const Scenario& scenario, const std::optional<InMetres>& metres) {
  Json object;
  object["scenario"] = scenario.id;
  object["planner"] = row.planner;
  object["verdict"] = name(row.verdict);
  object["track"] = name(row.track);
  object["rule"] = name(scenario.terrain.rule);
  object["length"] = nullable(row.length);
  object["optimum"] = nullable(row.optimum);
  object["gap"] = nullable(row.gap);
  object["turns"] = nullable(row.turns);
  object[row.track == Track::lattice ? "cells" : "points"] = points_of(row.answer);
  if (!scenario.world) add_metres(object, metres);
  object["evaluations"] = row.work.evaluations;
  object["iterations"] = row.work.iterations;
  object["checks"] = row.work.checks;
  object["digest"] = hex(row.digest);
  object["backend"] = row.costs.backend;
  object["threads"] = row.costs.threads;
  object["threads_used"] = row.costs.threads_used;
  object["wall_s"] = row.costs.wall_s;
  object["user_s"] = nullable(row.costs.user_s);
  object["system_s"] = nullable(row.costs.system_s);
  object["note"] = row.note.empty() ? Json(nullptr) : Json(row.note);
  object["counters"] = Json::object();
  if (scenario.world) add_run(object, row);
  for (const Counter& counter : row.counters) object["counters"][counter.name] = counter.value;
  return object;
}

// Bytes that are no UTF-8 become U+FFFD: a strange label must not cost the answer.
std::string dumped(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string to_json(const TrialRow& row, const Scenario& scenario, const std::optional<InMetres>& metres) {
  std::string text = "{";
  const char* separator = "\n";
  const Json object = object_of(row, scenario, metres);
  for (const auto& item : object.items()) {
    text += separator;
    text += "  " + dumped(item.key()) + ": " + dumped(item.value());
    separator = ",\n";
  }
  return text + "\n}";
}

}  // namespace pathrace::results
