// The random floor: uniform random walks with their loops erased, the shortest one wins.
//
// What blind luck reaches with the same number of walks. A walk steps to a uniformly drawn legal neighbour
// until it meets the goal; whenever it meets its own path, the loop is cut off (G. Lawler, "A self-avoiding
// random walk", Duke Math. J. 47, 1980). Walk t draws from stream.fork(t). One walk is one evaluation and one
// iteration, one step is one check.
#include <bit>
#include <cstdint>
#include <vector>

#include "core/catalogue.hpp"
#include "core/lattice_length.hpp"
#include "core/moves.hpp"

namespace pathrace::baselines {
namespace {

struct RandomWalkSettings {
  std::int64_t max_steps = 0;
};

int nth_direction(unsigned mask, std::uint64_t n) {
  for (; n > 0; --n) mask &= mask - 1;
  return std::countr_zero(mask);
}

LatticeLength length_of(const std::vector<Cell>& cells) {
  LatticeLength length;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const bool diagonal = cells[i].x != cells[i - 1].x && cells[i].y != cells[i - 1].y;
    (diagonal ? length.diagonal : length.straight) += 1;
  }
  return length;
}

class Walker {
 public:
  Walker(const Problem& problem, std::uint64_t max_steps)
      : problem_(problem),
        moves_(problem.grid, problem.rule),
        place_(problem.grid.padded_size(), 0),
        max_steps_(max_steps) {}

  /// True when the walk met the goal; `cells` is then its loop-erased path.
  bool walk(Stream stream, Meter& meter) {
    for (const Cell cell : cells_) place_[problem_.grid.index(cell)] = 0;
    cells_.clear();
    append(problem_.start);
    for (std::uint64_t step = 0; cells_.back() != problem_.goal; ++step) {
      if (step == max_steps_ || meter.checks_left() == 0) return false;
      if (step % clock_interval == 0 && meter.out_of_time()) return false;
      const Cell cell = cells_.back();
      const unsigned mask = moves_[problem_.grid.index(cell)];
      meter.spend_checks(1);
      if (mask == 0) return false;
      const int direction =
          nth_direction(mask, stream.below(static_cast<std::uint64_t>(std::popcount(mask))));
      const Cell offset = directions[static_cast<std::size_t>(direction)];
      append({cell.x + offset.x, cell.y + offset.y});
    }
    return true;
  }

  const std::vector<Cell>& cells() const { return cells_; }

 private:
  static constexpr std::uint64_t clock_interval = 4096;

  void append(Cell cell) {
    std::uint32_t& place = place_[problem_.grid.index(cell)];
    if (place != 0) {  // a loop: cut back to the first visit
      while (cells_.size() > place) {
        place_[problem_.grid.index(cells_.back())] = 0;
        cells_.pop_back();
      }
      return;
    }
    cells_.push_back(cell);
    place = static_cast<std::uint32_t>(cells_.size());
  }

  const Problem& problem_;
  MoveTable moves_;
  std::vector<std::uint32_t> place_;  // where on the path a cell is, from 1; 0 when it is not
  std::vector<Cell> cells_;
  std::uint64_t max_steps_;
};

Answer best_walk(const RandomWalkSettings& settings, const Problem& problem, Context& context) {
  const auto automatic = 20 * static_cast<std::uint64_t>(problem.grid.free_cells());
  Walker walker(problem, settings.max_steps > 0 ? static_cast<std::uint64_t>(settings.max_steps) : automatic);
  std::vector<Cell> best;
  LatticeLength shortest;
  for (std::uint64_t t = 0; !context.meter.exhausted(); ++t) {
    const bool arrived = walker.walk(context.stream.fork(t), context.meter);
    if (!arrived && context.meter.spent() && context.meter.evaluations_left() > 0) break;  // the walk was cut
    context.meter.spend_evaluations(1);
    context.meter.end_iteration();
    if (!arrived) continue;
    const LatticeLength length = length_of(walker.cells());
    if (!best.empty() && length >= shortest) continue;
    best = walker.cells();
    shortest = length;
    context.meter.improved(length.value());
  }
  if (best.empty()) return std::nullopt;
  return lattice_path(best);
}

}  // namespace

PlannerCard random_walk_card() {
  PlannerCard card;
  card.name = "random-walk";
  card.kind = Kind::floor;
  card.summary = "the shortest of many loop-erased random walks";
  card.source = "floor baseline of this project; loop erasure: G. Lawler, Duke Math. J. 47, 1980";
  card.default_budget.evaluations = 5000;
  card.default_budget.checks = 5'000'000;
  const Schema<RandomWalkSettings> schema{{
      integer("max_steps", &RandomWalkSettings::max_steps, 0, 1'000'000'000'000, "steps", Source::ours,
              "a walk gives up after so many steps; 0: twenty times the free cells"),
  }};
  return with_parameters(std::move(card), schema, [](const RandomWalkSettings& settings) {
    return unprepared([settings](const Problem& problem, Context& context) {
      return best_walk(settings, problem, context);
    });
  });
}

}  // namespace pathrace::baselines
