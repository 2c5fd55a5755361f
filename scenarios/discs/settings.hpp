// What an id of a dynamic world may say: `discs/<kind>[,key=value...]/<seed>`.
//
// Each kind has defaults of its own over those below; an id names a value only where it differs from its
// kind's default, in the order of the table, so that one question has one id.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/names.hpp"
#include "core/parameters.hpp"
#include "core/stream.hpp"
#include "core/world.hpp"

namespace pathrace::scenarios {

/// What a ring of discs goes around.
enum class Inside { nobody, robot, goal };

}  // namespace pathrace::scenarios

namespace pathrace {
template <>
inline constexpr auto names_of<scenarios::Inside> =
    std::to_array<std::pair<scenarios::Inside, std::string_view>>({
        {scenarios::Inside::nobody, "nobody"},
        {scenarios::Inside::robot, "robot"},
        {scenarios::Inside::goal, "goal"},
    });
}  // namespace pathrace

namespace pathrace::scenarios {

/// Defaults of algorithms.md 4: the paper's own values are lost.
struct DiscsSettings {
  int size = 100;
  int discs = 10;
  double r_min = 3;
  double r_max = 8;
  double robot_radius = 1;
  double v_robot = 3;
  double v_goal = 0.5;  ///< as a share of v_robot, like the next two
  double v_obs = 0.3;
  double arrival = 1;
  double p_goal = 0.5;
  double p_obs = 0.5;
  GoalLaw goal = GoalLaw::random;
  double gap = 0;
  double lane = 24;
  Inside inside = Inside::nobody;
  int max_steps = 500;
};

/// A world that a kind has begun to draw: walls, start and goal; loose discs are added to it.
struct DiscsSketch {
  World world;
  bool placed = false;  ///< start and goal are where they should be
};

struct DiscsKind {
  std::string_view name;
  std::string_view summary;
  ParameterValues defaults;           ///< where they differ from DiscsSettings
  std::vector<std::string_view> own;  ///< parameters that mean something to this kind alone
  /// Walls, and start and goal where the kind has its own.
  void (*draw)(const DiscsSettings&, Stream&, DiscsSketch&);
};

const std::vector<DiscsKind>& discs_kinds();

const Schema<DiscsSettings>& discs_schema();

}  // namespace pathrace::scenarios
