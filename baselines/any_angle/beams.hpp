// What is seen from a spot: corners of blocked cells, and the goal, inside a wedge of directions.
//
// A wedge looks up or down. A ray is a pair (dx, height): so far to the right on the way to a line `height`
// further in the direction of looking; a horizontal ray has height 0. Rays compare by cross products of
// integers, so that what is seen is exact. A beam is the part of the wedge that comes through into one run;
// it is cut at the run's walls and split among the runs of the next row. Runs of neighbouring rows that share
// a corner only are no neighbours: no segment may pass there.
//
// D. Harabor, A. Grastien, D. Oez, V. Aksakalli, "Optimal Any-Angle Pathfinding In Practice", JAIR 56, 2016
// (visible sets as intervals of rows); here they are followed from one root at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "baselines/any_angle/free_runs.hpp"

namespace pathrace::baselines {

struct Ray {
  std::int64_t dx = 0;
  std::int64_t height = 0;
};

/// < 0: a lies to the left of b; 0: the same direction; > 0: to the right. Not both horizontal.
constexpr std::int64_t compare(Ray a, Ray b) {
  return a.dx * b.height - b.dx * a.height;
}

/// A corner that belongs to one blocked cell only, on this side of it.
struct Corner {
  Spot at;
  int block_x = 0;  ///< -1 or 1: the blocked cell lies to the left or to the right,
  int block_y = 0;  ///< above or below
};

/// From where, which way (1 down, -1 up), from the left ray to the right one, both included. `row` and `run`:
/// where the wedge begins.
struct Wedge {
  Spot from;
  int down = 1;
  Ray left;
  Ray right;
  int row = 0;
  std::size_t run = 0;

  Ray ray_to(Spot spot) const { return {spot.x - from.x, down * (spot.y - from.y)}; }
};

class Beams {
 public:
  explicit Beams(const FreeRuns& runs) : runs_(runs) {}

  /// Calls `corner(Corner)` for each corner that the wedge sees, and `target()` when it sees the spot
  /// `goal`, the centre of a cell in row `goal.y / 2` and run `goal_run`.
  template <typename OnCorner, typename OnTarget>
  void look(const Wedge& wedge, Spot goal, std::size_t goal_run, const OnCorner& corner,
            const OnTarget& target) {
    beams_.assign(1, {wedge.row, wedge.run, wedge.left, wedge.right});
    while (!beams_.empty()) {
      Beam beam = beams_.back();
      beams_.pop_back();
      if (beam.run == goal_run && sees(wedge, beam, goal)) target();
      follow(wedge, beam, corner);
    }
  }

 private:
  struct Beam {
    int row;
    std::size_t run;
    Ray left;
    Ray right;
  };

  static bool sees(const Wedge& wedge, const Beam& beam, Spot goal) {
    const Ray ray = wedge.ray_to(goal);
    return ray.height > 0 && compare(beam.left, ray) <= 0 && compare(ray, beam.right) <= 0;
  }

  // A column at or before the one where the beam's left edge meets the far line.
  static int column_before(const Wedge& wedge, const Beam& beam, std::int64_t height) {
    const std::int64_t offset = beam.left.dx * height;
    const std::int64_t rounded = offset / beam.left.height - (offset % beam.left.height < 0 ? 1 : 0);
    const std::int64_t column = (wedge.from.x + rounded - 1) / 2;
    return column > 0 ? static_cast<int>(column) : 0;
  }

  template <typename OnCorner>
  void follow(const Wedge& wedge, Beam& beam, const OnCorner& corner) {
    const int far = 2 * beam.row + wedge.down;
    const FreeRun here = runs_[beam.run];
    const Ray left_wall = wedge.ray_to({here.left, far});
    const Ray right_wall = wedge.ray_to({here.right, far});
    if (compare(beam.left, left_wall) < 0) beam.left = left_wall;
    if (compare(beam.right, right_wall) > 0) beam.right = right_wall;
    const int row = beam.row + wedge.down;
    if (compare(beam.left, beam.right) > 0 || row < 0 || row >= runs_.rows()) return;
    const int column = column_before(wedge, beam, left_wall.height);
    for (std::size_t run = runs_.at_or_after(column, row); run < runs_.end_of(row); ++run) {
      const FreeRun next = runs_[run];
      const int from = next.left > here.left ? next.left : here.left;
      const int to = next.right < here.right ? next.right : here.right;
      const Ray first = wedge.ray_to({from, far});
      const Ray last = wedge.ray_to({to, far});
      if (next.left >= here.right || compare(first, beam.right) > 0) break;
      if (from >= to || compare(last, beam.left) < 0) continue;
      const bool sees_first = compare(first, beam.left) >= 0;
      const bool sees_last = compare(last, beam.right) <= 0;
      if (sees_first && next.left != here.left) {
        corner(Corner{{from, far}, -1, next.left > here.left ? wedge.down : -wedge.down});
      }
      if (sees_last && next.right != here.right) {
        corner(Corner{{to, far}, 1, next.right < here.right ? wedge.down : -wedge.down});
      }
      beams_.push_back({row, run, sees_first ? first : beam.left, sees_last ? last : beam.right});
    }
  }

  const FreeRuns& runs_;
  std::vector<Beam> beams_;
};

}  // namespace pathrace::baselines
