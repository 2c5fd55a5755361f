// How a world moves, step by step, from the stream of its id.
//
// Each disc, in order of index, moves by V_obs with probability P_obs in a uniform direction; a move that
// would overlap another disc, the goal or the border is drawn again, eight directions in all, then the disc
// stays. Then the goal moves by V_goal with probability P_goal and keeps as far from discs and border as the
// robot must; a blocked random move is drawn again in the same way, a blocked way-point is given up for the
// next, a fleeing goal tries 45 and 90 degrees to either side. In step k, disc i draws from
// stream.fork(k).fork(i), the goal from stream.fork(k).fork("goal").
//
// Where the goal flees, discs do not heed it: they would else look at the robot through it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/hash.hpp"
#include "core/stream.hpp"
#include "core/world.hpp"

namespace pathrace {

class WorldMotion {
 public:
  /// The world outlives the motion.
  explicit WorldMotion(const World& world);

  std::span<const Disc> discs() const { return discs_; }
  Point goal() const { return goal_; }
  /// How often the world has moved.
  std::uint64_t step() const { return step_; }

  /// Discs, then the goal. A fleeing goal looks at the robot; nothing else does.
  void advance(Point robot);

  /// Moves on until the last step, and says what the world has done from the first to the last: world_hash,
  /// unless somebody has meddled with it.
  std::uint64_t hash_to_the_end();

 private:
  void move_disc(std::size_t index, Stream stream);
  void move_goal(Point robot, Stream stream);
  void wander(Stream& stream);
  void follow_way_points();
  void flee(Point robot);
  bool fits(std::size_t index, Point centre) const;
  bool goal_fits(Point goal) const;
  bool try_goal(Point goal);

  const World& world_;
  Stream stream_;
  std::vector<Disc> discs_;
  Point goal_;
  std::size_t way_point_ = 0;
  std::uint64_t step_ = 0;
  Hasher hasher_;
};

/// A direction of length one, uniform: a point of the unit disc drawn by rejection, then scaled. No libm.
Point draw_direction(Stream& stream);

}  // namespace pathrace
