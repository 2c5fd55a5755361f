// Arrival rate: the share of a plain Ant System's ants that reach the goal in the first iteration, when
// nothing has been learnt (algorithms.md 1.2). An ant that has no unvisited neighbour dies.
//
// Every walk is a trial of `as` with one ant and one evaluation, so that each draws from a stream of its own
// and is judged. Standard error of the share p of n walks: sqrt(p (1 - p) / n), at most 0.035 for n = 200. A
// walk prepares the whole map, so large maps get fewer: n * cells stays below 2^22, which is 16 walks on
// 512 x 512, with a standard error of up to 0.125; larger maps get none, and no value.
#include <algorithm>

#include "bench/features/feature.hpp"
#include "bench/roster.hpp"

namespace pathrace::bench {
namespace {

constexpr std::uint64_t most_walks = 200;
constexpr std::uint64_t least_walks = 16;
constexpr std::uint64_t most_prepared_cells = std::uint64_t{1} << 22;

const Entrant& one_ant() {
  static const Entrant entrant = roster().enter({"as", {{"ants", "1"}, {"dead_end", "die"}}});
  return entrant;
}

std::uint64_t affordable_walks(const OccupancyGrid& grid) {
  const auto cells = static_cast<std::uint64_t>(grid.width()) * static_cast<std::uint64_t>(grid.height());
  return std::min(most_walks, most_prepared_cells / cells);
}

std::optional<double> arrival_rate(FeatureContext& context) {
  if (!context.optimum()) return 0;  // nobody arrives where there is no way
  const std::uint64_t walks = affordable_walks(context.scenario().grid());
  if (walks < least_walks) return std::nullopt;
  Budget one_walk;
  one_walk.evaluations = 1;
  const Stream stream = context.stream("arrival_rate");
  std::uint64_t arrived = 0;
  for (std::uint64_t walk = 0; walk < walks; ++walk) {
    const TrialRecord record = context.run(one_ant(), one_walk, stream.fork(walk));
    arrived += record.verdict == Verdict::solved ? 1 : 0;
  }
  return static_cast<double>(arrived) / static_cast<double>(walks);
}

}  // namespace

Feature arrival_rate_feature() {
  return {"arrival_rate", "share", "ants of a plain Ant System that arrive in the first iteration",
          FeatureType::real, arrival_rate};
}

}  // namespace pathrace::bench
