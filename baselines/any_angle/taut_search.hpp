// A proven shortest path for a point robot: A* over taut paths.
//
// A shortest path turns only at corners that belong to a single blocked cell, and there it bends around that
// cell, like a rope pulled tight. So the vertices are start, goal and those corners; from a vertex the search
// looks only where a rope that came from its parent may go on, between straight ahead and along the blocked
// cell, at most a quarter turn, and takes only corners where the rope could bend again. Nothing is prepared
// but the runs of free cells; what is in sight is found when a vertex is expanded, in integers.
// One parent per vertex is enough: of two equally short ways to a vertex, a rope that is taut over the one
// and not over the other could be shortened, and would not be shortest.
//
// Lengths are sums of rounded square roots; a path is shortest up to some units in the last place per turn.
//
// S. Oh, H. W. Leong, "Edge N-Level Sparse Visibility Graphs: Fast Optimal Any-Angle Pathfinding Using
// Hierarchical Taut Paths", SoCS 2017 (taut paths); D. Harabor et al., "Optimal Any-Angle Pathfinding In
// Practice", JAIR 56, 2016 (Anya: search without a visibility graph).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "baselines/any_angle/beams.hpp"
#include "baselines/any_angle/free_runs.hpp"
#include "core/planner.hpp"

namespace pathrace::baselines {

class TautSearch final : public MapPlanner {
 public:
  explicit TautSearch(const Terrain& terrain);

  /// One evaluation (the path found), one iteration; a check is a vertex expanded.
  Answer plan(Cell start, Cell goal, Context& context) override;

 private:
  struct Vertex {
    Corner corner;  // no block: start or goal
    double cost;
    std::uint32_t parent;
    bool expanded;
  };
  struct Open {
    double f;
    double cost;
    std::uint32_t vertex;
  };

  static bool later(const Open& a, const Open& b);

  void restart(Cell start, Cell goal);
  bool search(Meter& meter);
  void look_around();
  void expand(std::uint32_t vertex);
  void look(const Wedge& wedge, Ray straight_on);
  void slide(const Corner& corner);
  void reach_corner(const Corner& corner);
  std::uint32_t vertex_at(const Corner& corner);
  void reach(std::uint32_t vertex);
  Path extract() const;

  static constexpr std::uint32_t start_vertex = 0;
  static constexpr std::uint32_t goal_vertex = 1;

  const OccupancyGrid& grid_;
  FreeRuns runs_;
  Beams beams_;
  // The vertices seen in this query, and for each corner of the grid its place among them: right only when
  // the vertex there stands at that corner, so that a new query has nothing to reset (P. Briggs, L. Torczon,
  // "An efficient representation for sparse sets", 1993).
  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> place_;
  std::vector<Open> open_;  // a heap
  std::size_t start_run_ = 0;
  std::size_t goal_run_ = 0;
  std::uint32_t here_ = 0;  // the vertex being expanded
  bool cut_ = false;
};

}  // namespace pathrace::baselines
