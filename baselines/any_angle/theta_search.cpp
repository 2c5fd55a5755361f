#include "baselines/any_angle/theta_search.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>

#include "baselines/any_angle/sight.hpp"
#include "core/checkpoint.hpp"

namespace pathrace::baselines {
namespace {

constexpr std::uint64_t clock_interval = 64;  // sight lines may be long

double distance(Cell a, Cell b) {
  const std::int64_t dx = a.x - b.x;
  const std::int64_t dy = a.y - b.y;
  return std::sqrt(static_cast<double>(dx * dx + dy * dy));
}

Cell moved(Cell cell, int direction) {
  const Cell step = directions[static_cast<std::size_t>(direction)];
  return {cell.x + step.x, cell.y + step.y};
}

}  // namespace

ThetaSearch::ThetaSearch(const Terrain& terrain, Looking looking)
    : grid_(*terrain.grid),
      looking_(looking),
      moves_(grid_, terrain.rule == MoveRule::free ? MoveRule::squeeze : terrain.rule),
      nodes_(filled_gradually<std::vector<Node>>(grid_.padded_size(), Node{0, {}, 0})) {}

Answer ThetaSearch::plan(Cell start, Cell goal, Context& context) {
  if (context.meter.exhausted()) return std::nullopt;
  restart();
  goal_ = goal;
  const bool found = search(start, context.meter);
  context.meter.count("sight_lines", sight_lines_);
  if (cut_) return std::nullopt;
  context.meter.end_iteration();
  if (!found) {
    context.meter.conclude();
    return std::nullopt;
  }
  context.meter.spend_evaluations(1);
  context.meter.improved(node(goal).cost);
  return extract(start);
}

void ThetaSearch::restart() {
  if (query_ == std::numeric_limits<std::uint32_t>::max() / 2) {
    std::fill(nodes_.begin(), nodes_.end(), Node{0, {}, 0});
    query_ = 0;
  }
  ++query_;
  open_.clear();
  sight_lines_ = 0;
  cut_ = false;
}

// The order of the heap: least f first, of equals the one farther from the start, then the lower cell.
bool ThetaSearch::later(const Open& a, const Open& b) {
  return std::make_tuple(a.f, -a.cost, a.cell.y, a.cell.x) >
         std::make_tuple(b.f, -b.cost, b.cell.y, b.cell.x);
}

bool ThetaSearch::sees(Cell from, Cell to) {
  ++sight_lines_;
  return in_sight(grid_, from, to);
}

bool ThetaSearch::search(Cell start, Meter& meter) {
  node(start) = {0, start, 2 * query_};
  open_.push_back({distance(start, goal_), 0, start});
  while (!open_.empty()) {
    std::pop_heap(open_.begin(), open_.end(), later);
    const Open best = open_.back();
    open_.pop_back();
    Node& here = node(best.cell);
    if (expanded(here) || best.cost > here.cost) continue;
    if (looking_ == Looking::at_expanding) find_parent(best.cell);
    here.query = 2 * query_ + 1;
    if (best.cell == goal_) return true;
    cut_ = meter.checks_left() == 0 || (meter.work().checks % clock_interval == 0 && meter.out_of_time());
    if (cut_) return false;
    meter.spend_checks(1);
    expand(best.cell);
  }
  return false;
}

// A neighbour that is known at no more than the straight way from the parent needs no look: the way over this
// cell is no shorter.
void ThetaSearch::expand(Cell cell) {
  const Cell parent = node(cell).parent;
  const double cost = node(parent).cost;
  for (unsigned mask = moves_[grid_.index(cell)]; mask != 0; mask &= mask - 1) {
    const Cell next = moved(cell, std::countr_zero(mask));
    const Node& there = node(next);
    if (expanded(there) || (seen(there) && there.cost <= cost + distance(parent, next))) continue;
    const bool straight = looking_ == Looking::at_expanding || sees(parent, next);
    reach(next, straight ? parent : cell);
  }
}

// Lazy Theta*: was the parent rightly taken for granted? If not, the cheapest expanded neighbour is.
void ThetaSearch::find_parent(Cell cell) {
  Node& here = node(cell);
  if (here.parent == cell || sees(here.parent, cell)) return;
  here.cost = std::numeric_limits<double>::infinity();
  for (unsigned mask = moves_[grid_.index(cell)]; mask != 0; mask &= mask - 1) {  // legal both ways
    const Cell next = moved(cell, std::countr_zero(mask));
    if (!expanded(node(next))) continue;
    const double cost = node(next).cost + distance(next, cell);
    if (cost >= here.cost) continue;
    here.cost = cost;
    here.parent = next;
  }
}

void ThetaSearch::reach(Cell cell, Cell parent) {
  const double cost = node(parent).cost + distance(parent, cell);
  Node& there = node(cell);
  if (seen(there) && there.cost <= cost) return;
  there = {cost, parent, 2 * query_};
  open_.push_back({cost + distance(cell, goal_), cost, cell});
  std::push_heap(open_.begin(), open_.end(), later);
}

Path ThetaSearch::extract(Cell start) const {
  Path path;
  path.track = Track::any_angle;
  for (Cell cell = goal_;; cell = node(cell).parent) {
    path.points.push_back(centre(cell));
    if (cell == start) break;
  }
  std::reverse(path.points.begin(), path.points.end());
  return path;
}

}  // namespace pathrace::baselines
