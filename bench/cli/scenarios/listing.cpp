#include "bench/cli/scenarios/listing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "bench/features/feature.hpp"
#include "core/hash.hpp"
#include "results/scenarios_csv.hpp"

namespace pathrace::bench::cli {
namespace {

using Json = nlohmann::ordered_json;

Json value_of(const Feature& feature, const std::optional<double>& value) {
  if (!value) return nullptr;
  return feature.type == FeatureType::integer ? Json(static_cast<std::int64_t>(*value)) : Json(*value);
}

Json nullable(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json object_of(const results::ScenarioRow& row, bool with_features) {
  Json object = {{"id", row.id},
                 {"family", row.family()},
                 {"width", row.width},
                 {"height", row.height},
                 {"rule", name(row.rule)},
                 {"start", {row.start.x, row.start.y}},
                 {"goal", {row.goal.x, row.goal.y}},
                 {"optimum", nullable(row.optimum)},
                 {"any_angle_optimum", nullable(row.any_angle_optimum)},
                 {"hash", hex(row.hash)}};
  if (!with_features) return object;
  Json& values = object["features"] = Json::object();
  for (std::size_t i = 0; i < row.features.size(); ++i) {
    values[row.features[i].name] = value_of(features()[i], row.features[i].value);
  }
  return object;
}

std::string size_of(const results::ScenarioRow& row) {
  return fmt::format("{}x{}", row.width, row.height);
}

std::string optimum_of(const results::ScenarioRow& row) {
  if (row.family() == "discs") return "-";  // no shortest path among what moves
  return row.optimum ? fmt::format("{:.4f}", *row.optimum) : "no way";
}

std::string cell_of(const Feature& feature, const std::optional<double>& value) {
  if (!value) return "-";
  return feature.type == FeatureType::integer ? fmt::format("{:.0f}", *value) : fmt::format("{:.3f}", *value);
}

int id_width(const std::vector<results::ScenarioRow>& rows) {
  std::size_t width = 24;
  for (const results::ScenarioRow& row : rows) width = std::max(width, row.id.size());
  return static_cast<int>(width);
}

void print_features(const std::vector<results::ScenarioRow>& rows) {
  const int id = id_width(rows);
  fmt::print("{:<{}} {:>9} {:>10}", "id", id, "size", "optimum");
  for (const Feature& feature : features()) fmt::print("  {}", feature.name);
  fmt::print("\n");
  for (const results::ScenarioRow& row : rows) {
    fmt::print("{:<{}} {:>9} {:>10}", row.id, id, size_of(row), optimum_of(row));
    for (std::size_t i = 0; i < row.features.size(); ++i) {
      const Feature& feature = features()[i];
      fmt::print("  {:>{}}", cell_of(feature, row.features[i].value), feature.name.size());
    }
    fmt::print("\n");
  }
}

}  // namespace

void print_json(const std::vector<results::ScenarioRow>& rows, bool with_features) {
  Json array = Json::array();
  for (const results::ScenarioRow& row : rows) array.push_back(object_of(row, with_features));
  fmt::print("{}\n", array.dump(1));
}

void print_csv(const std::vector<results::ScenarioRow>& rows, bool with_features) {
  std::vector<std::string> names;
  if (with_features) {
    for (const Feature& feature : features()) names.emplace_back(feature.name);
  }
  results::write_scenarios_header(std::cout, names);
  for (const results::ScenarioRow& row : rows) results::write_scenario_line(std::cout, row, names);
  std::cout.flush();
}

void print_table(const std::vector<results::ScenarioRow>& rows, bool with_features) {
  if (with_features) return print_features(rows);
  fmt::print("{:<24} {:>9} {:<7} {:>10}  hash\n", "id", "size", "rule", "optimum");
  for (const results::ScenarioRow& row : rows) {
    fmt::print("{:<24} {:>9} {:<7} {:>10}  {}\n", row.id, size_of(row), name(row.rule), optimum_of(row),
               hex(row.hash));
  }
}

}  // namespace pathrace::bench::cli
