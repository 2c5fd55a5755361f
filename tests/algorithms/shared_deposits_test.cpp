// Deposits shared out among threads: whoever makes them, they are those of one thread.
#include "algorithms/aco/shared_deposits.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "bench/executors.hpp"
#include "core/stream.hpp"
#include "tests/algorithms/trail_field.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::algorithms {
namespace {

// A map and a trail on it.
struct Land {
  Land(int width, int height, double alpha)
      : grid(width, height),
        nest({grid, MoveRule::free, {width / 2, height / 2}, {0, 0}}),
        trail(nest.moves(), 1, alpha, 1, equal) {
    trail.limit(0.25, 9);
  }

  OccupancyGrid grid;
  Nest nest;
  Trail trail;
};

// A walk to and fro; some do not arrive, which leaves a path that is not to be deposited on.
Walk bring_home(const Nest& nest, Stream& stream) {
  Walk walk;
  walk.arrived = stream.between(0, 5) > 0;
  const auto steps = static_cast<std::size_t>(stream.between(1, 200));
  walk.directions = random_walk(nest.moves(), nest.start(), stream, steps);
  return walk;
}

void deposit_in_turn(Land& land, const std::vector<Walk>& walks, const std::vector<double>& amounts,
                     bool both_ways) {
  for (std::size_t ant = 0; ant < walks.size(); ++ant) {
    if (!walks[ant].arrived) continue;
    for_each_step(land.nest, walks[ant], [&](std::size_t index, int direction) {
      land.trail.deposit(index, direction, amounts[ant], both_ways);
    });
  }
}

void expect_same_pheromone(const Land& land, const Land& expected) {
  for (std::size_t index = 0; index < expected.nest.size(); ++index) {
    for (int d = 0; d < direction_count; ++d) {
      if ((expected.nest.open(index) >> d & 1) == 0) continue;
      ASSERT_EQ(land.trail.pheromone(index, d), expected.trail.pheromone(index, d)) << index << ' ' << d;
    }
  }
}

class SharedDepositsBy : public ::testing::TestWithParam<std::string> {};

// So many deposits on so few steps that their order shows: floats that are added up otherwise differ.
TEST_P(SharedDepositsBy, EveryStepHasThoseOfAllAntsInTheirOrder) {
  for (const int threads : {1, 2, 3, 4}) {
    const std::unique_ptr<Executor> executor =
        bench::make_executor(GetParam(), GetParam() == "serial" ? 1 : threads);
    for (const auto& [width, height] : {std::pair{5, 40}, {9, 3}, {30, 1}}) {
      for (const double alpha : {1.0, 2.0}) {
        for (const bool both_ways : {false, true}) {
          Stream stream(7);
          Land land(width, height, alpha);
          Land expected(width, height, alpha);
          if (threads == 3) land.trail.keep_draft();  // then rows that change are marked
          SharedDeposits deposits(land.nest, land.trail, 40, static_cast<std::size_t>(threads));
          executor->with_team([&] {
            for (int round = 0; round < 6; ++round) {
              std::vector<Walk> walks(round % 2 == 0 ? 40 : 7);
              std::vector<double> amounts;
              for (Walk& walk : walks) {
                walk = bring_home(land.nest, stream);
                amounts.push_back(stream.uniform());
              }
              deposits.deposit(walks, amounts, both_ways, *executor);
              deposit_in_turn(expected, walks, amounts, both_ways);
              for (Land* each : {&land, &expected}) each->trail.evaporate(0.9);
            }
          });
          ASSERT_NO_FATAL_FAILURE(expect_same_pheromone(land, expected))
              << threads << " threads, " << width << 'x' << height << ", alpha " << alpha << ' ' << both_ways;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Executors, SharedDepositsBy, ::testing::ValuesIn(testing::executors_under_test()),
                         [](const auto& backend) { return backend.param; });

}  // namespace
}  // namespace pathrace::algorithms
