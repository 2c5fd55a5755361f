// What every colony can be told, whatever its pheromone rule. A variant's settings derive from these and
// change defaults in their constructor; its schema is `colony_schema` with the variant's own fields.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "algorithms/aco/dead_end.hpp"
#include "core/names.hpp"
#include "core/parameters.hpp"

namespace pathrace::algorithms {

enum class AntHeuristic { inv_goal, inv_step };
enum class AntAnswer { best_so_far, argmax_pheromone };

/// Defaults: those of the public Ant System codes for grids.
struct ColonySettings {
  int ants = 50;
  double alpha = 1;
  double beta = 7;
  double evaporation = 0.3;
  double deposit = 1;
  double initial_pheromone = 0;
  double pheromone_floor = 1e-12;
  double goal_attraction = 100;
  bool both_ways = true;
  AntHeuristic heuristic = AntHeuristic::inv_goal;
  DeadEnd dead_end = DeadEnd::die;
  AntAnswer answer = AntAnswer::best_so_far;
  std::int64_t max_steps = 0;
};

/// The fields of ColonySettings.
const std::vector<Field<ColonySettings>>& colony_fields();

/// The common fields, then the variant's own, and its conditions.
template <typename Settings>
Schema<Settings> colony_schema(std::vector<Field<Settings>> own = {},
                               std::vector<Condition<Settings>> conditions = {}) {
  std::vector<Field<Settings>> fields;
  for (const Field<ColonySettings>& field : colony_fields()) {
    fields.push_back({field.card, field.read, field.print});
  }
  for (Field<Settings>& field : own) fields.push_back(std::move(field));
  return {std::move(fields), std::move(conditions)};
}

}  // namespace pathrace::algorithms

namespace pathrace {
template <>
inline constexpr auto names_of<algorithms::AntHeuristic> =
    std::to_array<std::pair<algorithms::AntHeuristic, std::string_view>>({
        {algorithms::AntHeuristic::inv_goal, "inv_goal"},
        {algorithms::AntHeuristic::inv_step, "inv_step"},
    });
template <>
inline constexpr auto names_of<algorithms::AntAnswer> =
    std::to_array<std::pair<algorithms::AntAnswer, std::string_view>>({
        {algorithms::AntAnswer::best_so_far, "best_so_far"},
        {algorithms::AntAnswer::argmax_pheromone, "argmax_pheromone"},
    });
}  // namespace pathrace
