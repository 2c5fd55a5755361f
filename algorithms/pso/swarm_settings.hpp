// What every swarm can be told, whatever its particles stand for. A planner's settings derive from these and
// change defaults in their constructor; its schema is `swarm_schema` with the planner's own fields.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/names.hpp"
#include "core/parameters.hpp"

namespace pathrace::algorithms {

enum class InertiaRule {
  linear,        ///< falls from w_start to w_end, eq. (4)
  constant,      ///< w_start throughout
  constriction,  ///< M. Clerc, J. Kennedy, IEEE Trans. Evolutionary Computation 6(1), 2002
};
enum class Topology {
  global,  ///< everybody follows the best of all
  ring,    ///< everybody follows the best of its neighbours by index
};

/// Defaults: those of Nasrollahy and Javadi, where the text states one.
struct SwarmSettings {
  int particles = 30;
  InertiaRule inertia = InertiaRule::linear;
  double w_start = 0.95;
  double w_end = 0.4;
  double c1 = 2;
  double c2 = 2;
  double v_max = 0.5;
  Topology topology = Topology::global;
  int neighbours = 1;
};

/// The fields of SwarmSettings.
const std::vector<Field<SwarmSettings>>& swarm_fields();

/// The common fields, then the planner's own, and its conditions. `sources` names the origin of defaults that
/// the planner changes.
template <typename Settings>
Schema<Settings> swarm_schema(std::vector<Field<Settings>> own, const std::map<std::string, Source>& sources,
                              std::vector<Condition<Settings>> conditions = {}) {
  std::vector<Field<Settings>> fields;
  for (const Field<SwarmSettings>& field : swarm_fields()) {
    fields.push_back({field.card, field.read, field.print});
    const auto source = sources.find(field.card.name);
    if (source != sources.end()) fields.back().card.source = source->second;
  }
  for (Field<Settings>& field : own) fields.push_back(std::move(field));
  return {std::move(fields), std::move(conditions)};
}

/// v := scale * (inertia * v + c1 r1 (pbest - x) + c2 r2 (gbest - x)).
struct Momentum {
  double inertia = 1;
  double scale = 1;
};

/// Of iteration k of K, k from 1; `linear` reaches w_end at k = K and keeps it.
Momentum momentum(const SwarmSettings& settings, std::size_t k, std::size_t last);

}  // namespace pathrace::algorithms

namespace pathrace {
template <>
inline constexpr auto names_of<algorithms::InertiaRule> =
    std::to_array<std::pair<algorithms::InertiaRule, std::string_view>>({
        {algorithms::InertiaRule::linear, "linear"},
        {algorithms::InertiaRule::constant, "constant"},
        {algorithms::InertiaRule::constriction, "constriction"},
    });
template <>
inline constexpr auto names_of<algorithms::Topology> =
    std::to_array<std::pair<algorithms::Topology, std::string_view>>({
        {algorithms::Topology::global, "global"},
        {algorithms::Topology::ring, "ring"},
    });
}  // namespace pathrace
