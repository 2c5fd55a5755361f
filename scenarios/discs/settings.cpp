#include "scenarios/discs/settings.hpp"

namespace pathrace::scenarios {

const Schema<DiscsSettings>& discs_schema() {
  using S = DiscsSettings;
  static const Schema<S> schema{{
      integer("size", &S::size, 20, 1000, "units", Source::field, "side of the square workspace"),
      integer("discs", &S::discs, 0, 500, "discs", Source::field, "discs that move"),
      real("r_min", &S::r_min, 0.1, 100, "units", Source::field, "least radius of a moving disc"),
      real("r_max", &S::r_max, 0.1, 100, "units", Source::field, "greatest radius of a moving disc"),
      real("robot_radius", &S::robot_radius, 0, 10, "units", Source::ours, "0: a point"),
      real("v_robot", &S::v_robot, 0.01, 50, "units", Source::field, "V_robot, per step"),
      real("v_goal", &S::v_goal, 0, 0.99, "V_robot", Source::field, "V_goal, per step"),
      real("v_obs", &S::v_obs, 0, 2, "V_robot", Source::field, "V_obs, per step"),
      real("arrival", &S::arrival, 0.01, 10, "V_robot", Source::field, "the threshold"),
      real("p_goal", &S::p_goal, 0, 1, "", Source::field, "P_goal, per step"),
      real("p_obs", &S::p_obs, 0, 1, "", Source::field, "P_obs, per step"),
      choice("goal", &S::goal, Source::inferred, "how the goal moves; flee is chase's alone"),
      real("gap", &S::gap, 0, 50, "units", Source::ours, "ring, c-trap: between neighbours; 0: they touch"),
      real("lane", &S::lane, 4, 900, "units", Source::ours, "corridor: from wall to wall"),
      choice("inside", &S::inside, Source::ours, "ring: what it goes around"),
      integer("max_steps", &S::max_steps, 1, 100000, "steps", Source::field, "the run ends with them"),
  }};
  return schema;
}

}  // namespace pathrace::scenarios
