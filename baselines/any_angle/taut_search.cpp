#include "baselines/any_angle/taut_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/checkpoint.hpp"

namespace pathrace::baselines {
namespace {

constexpr std::uint64_t clock_interval = 16;  // a vertex in a wide hall may take milliseconds
constexpr double unreached = std::numeric_limits<double>::infinity();

Spot spot_of(Cell cell) {
  return {2 * cell.x, 2 * cell.y};
}

// In cell edges.
double distance(Spot a, Spot b) {
  const std::int64_t dx = a.x - b.x;
  const std::int64_t dy = a.y - b.y;
  return std::sqrt(static_cast<double>(dx * dx + dy * dy)) / 2;
}

}  // namespace

TautSearch::TautSearch(const Terrain& terrain)
    : grid_(*terrain.grid),
      runs_(grid_),
      beams_(runs_),
      place_(filled_gradually<std::vector<std::uint32_t>>(
          (static_cast<std::size_t>(grid_.width()) + 1) * (static_cast<std::size_t>(grid_.height()) + 1),
          0)) {}

Answer TautSearch::plan(Cell start, Cell goal, Context& context) {
  if (context.meter.exhausted()) return std::nullopt;
  restart(start, goal);
  const bool found = start == goal || search(context.meter);
  if (cut_) return std::nullopt;
  context.meter.end_iteration();
  if (!found) {
    context.meter.conclude();
    return std::nullopt;
  }
  context.meter.spend_evaluations(1);
  Path path = start == goal ? Path{Track::any_angle, {centre(start)}} : extract();
  context.meter.improved(start == goal ? 0 : vertices_[goal_vertex].cost);
  return path;
}

void TautSearch::restart(Cell start, Cell goal) {
  vertices_.assign(
      {{{spot_of(start)}, 0, start_vertex, false}, {{spot_of(goal)}, unreached, start_vertex, false}});
  open_.assign(1, {0, 0, start_vertex});
  start_run_ = runs_.at_or_after(start.x, start.y);
  goal_run_ = runs_.at_or_after(goal.x, goal.y);
  cut_ = false;
}

// The order of the heap: least f first, of equals the one farther from the start, then the one seen first.
bool TautSearch::later(const Open& a, const Open& b) {
  return std::make_tuple(a.f, -a.cost, a.vertex) > std::make_tuple(b.f, -b.cost, b.vertex);
}

bool TautSearch::search(Meter& meter) {
  while (!open_.empty()) {
    std::pop_heap(open_.begin(), open_.end(), later);
    const Open best = open_.back();
    open_.pop_back();
    Vertex& vertex = vertices_[best.vertex];
    if (vertex.expanded || best.cost > vertex.cost) continue;
    if (best.vertex == goal_vertex) return true;
    cut_ = meter.checks_left() == 0 || (meter.work().checks % clock_interval == 0 && meter.out_of_time());
    if (cut_) return false;
    meter.spend_checks(1);
    vertex.expanded = true;
    here_ = best.vertex;
    if (here_ == start_vertex) {
      look_around();
    } else {
      expand(here_);
    }
  }
  return false;
}

void TautSearch::look_around() {
  if (start_run_ == goal_run_) reach(goal_vertex);
  const Spot from = vertices_[start_vertex].corner.at;
  for (const int down : {1, -1}) {
    look({from, down, {-1, 0}, {1, 0}, from.y / 2, start_run_}, {0, 0});
  }
}

// A rope that comes by the side of the block goes on around it: over its far edge, which may be the
// horizontal or the vertical one.
void TautSearch::expand(std::uint32_t vertex) {
  const Corner corner = vertices_[vertex].corner;
  const Spot parent = vertices_[vertices_[vertex].parent].corner.at;
  const int dx = corner.at.x - parent.x;
  const int dy = corner.at.y - parent.y;
  const Ray straight_on{dx, std::abs(dy)};
  const bool over_horizontal = dy * corner.block_y < 0;
  const int down = over_horizontal ? -corner.block_y : corner.block_y;
  const int side = over_horizontal ? corner.block_x : -corner.block_x;  // where the free cells ahead lie
  const Ray edge = over_horizontal ? Ray{corner.block_x, 0} : Ray{0, 1};
  const bool turns_right = corner.block_x > 0;
  const int row = (corner.at.y + down) / 2;
  const std::size_t run = runs_.at_or_after((corner.at.x + side) / 2, row);
  look({corner.at, down, turns_right ? straight_on : edge, turns_right ? edge : straight_on, row, run},
       straight_on);
  if (over_horizontal) slide(corner);
}

// What lies straight on was in sight of the parent already; the start has no straight on, {0, 0}.
void TautSearch::look(const Wedge& wedge, Ray straight_on) {
  const bool all = straight_on.dx == 0 && straight_on.height == 0;
  const auto is_news = [&](Spot spot) { return all || compare(wedge.ray_to(spot), straight_on) != 0; };
  const Spot goal = vertices_[goal_vertex].corner.at;
  beams_.look(
      wedge, goal, goal_run_,
      [&](const Corner& corner) {
        if (is_news(corner.at)) reach_corner(corner);
      },
      [&] {
        if (is_news(goal)) reach(goal_vertex);
      });
}

// Along the block's horizontal edge and on, as long as one side is free and no two blocks meet at a corner.
void TautSearch::slide(const Corner& corner) {
  const int ahead = corner.block_x;
  const int above = (corner.at.y - 1) / 2;
  const auto is_free = [&](int column, int row) { return grid_.is_free({column, row}); };
  for (Spot at = corner.at;; at.x += 2 * ahead) {
    const int column = (at.x + ahead) / 2;
    const bool over = is_free(column, above);
    const bool under = is_free(column, above + 1);
    if (!over && !under) return;
    const bool next_over = is_free(column + ahead, above);
    const bool next_under = is_free(column + ahead, above + 1);
    if (over != under && next_over != next_under && over != next_over) return;
    if (over != under && next_over && next_under) {
      reach_corner({{at.x + 2 * ahead, at.y}, -ahead, over ? 1 : -1});
    }
  }
}

// Only where the rope could bend around the block: it must not run into the block's open quadrant.
void TautSearch::reach_corner(const Corner& corner) {
  const Spot from = vertices_[here_].corner.at;
  const int dx = corner.at.x - from.x;
  const int dy = corner.at.y - from.y;
  if (dx * corner.block_x < 0 || dy * corner.block_y < 0) reach(vertex_at(corner));
}

std::uint32_t TautSearch::vertex_at(const Corner& corner) {
  const std::size_t columns = static_cast<std::size_t>(grid_.width()) + 1;
  std::uint32_t& place = place_[static_cast<std::size_t>((corner.at.y + 1) / 2) * columns +
                                static_cast<std::size_t>((corner.at.x + 1) / 2)];
  if (place < vertices_.size() && vertices_[place].corner.at == corner.at) return place;
  place = static_cast<std::uint32_t>(vertices_.size());
  vertices_.push_back({corner, unreached, start_vertex, false});
  return place;
}

void TautSearch::reach(std::uint32_t vertex) {
  Vertex& there = vertices_[vertex];
  const Spot goal = vertices_[goal_vertex].corner.at;
  const double cost = vertices_[here_].cost + distance(vertices_[here_].corner.at, there.corner.at);
  if (cost >= there.cost) return;
  there.cost = cost;
  there.parent = here_;
  there.expanded = false;
  const double f = cost + distance(there.corner.at, goal);
  if (vertex != goal_vertex && f > vertices_[goal_vertex].cost) return;
  open_.push_back({f, cost, vertex});
  std::push_heap(open_.begin(), open_.end(), later);
}

Path TautSearch::extract() const {
  Path path;
  path.track = Track::any_angle;
  for (std::uint32_t vertex = goal_vertex;; vertex = vertices_[vertex].parent) {
    const Spot at = vertices_[vertex].corner.at;
    path.points.push_back({at.x / 2.0, at.y / 2.0});
    if (vertex == start_vertex) break;
  }
  std::reverse(path.points.begin(), path.points.end());
  return path;
}

}  // namespace pathrace::baselines
