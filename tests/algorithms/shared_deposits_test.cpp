// Deposits shared out among threads: whoever makes them, they are those of one thread.
#include "algorithms/aco/shared_deposits.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "bench/executors.hpp"
#include "core/stream.hpp"
#include "tests/algorithms/trail_field.hpp"
#include "tests/support/backwards_executor.hpp"
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

// One loop for paths, one for deposits; the first is left out when everybody has been back in time.
TEST(SharedDeposits, WhatIsPreparedIsNotSplitAgain) {
  Stream stream(9);
  Land land(9, 9, 1);
  SharedDeposits deposits(land.nest, land.trail, 3, 2);
  RollCall roll_call(3, 2);
  std::vector<Walk> walks(3);
  for (Walk& walk : walks) walk = bring_home(land.nest, stream);
  const std::vector<double> amounts(3, 1);
  const auto loops_after = [&](std::size_t back, std::uint32_t round) {
    for (std::size_t ant = 0; ant < back; ++ant) roll_call.sign(ant, round);
    deposits.prepare(walks, roll_call, round, 0);
    testing::BackwardsExecutor executor;
    deposits.deposit(walks, amounts, true, round, executor);
    return executor.loops;
  };
  EXPECT_EQ(loops_after(2, 1), 2);
  EXPECT_EQ(loops_after(3, 2), 1);
  EXPECT_EQ(loops_after(0, 3), 2);
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
              deposits.deposit(walks, amounts, both_ways, 1, *executor);
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

// In each round some ants are back when paths are prepared, and the others come later, with other paths than
// their slots hold by then.
TEST_P(SharedDepositsBy, PathsMayBePreparedWhileAntsAreMissing) {
  constexpr std::size_t ants = 40;
  for (const int threads : {1, 2, 3, 4}) {
    const std::unique_ptr<Executor> executor =
        bench::make_executor(GetParam(), GetParam() == "serial" ? 1 : threads);
    const auto count = static_cast<std::size_t>(threads);
    Stream stream(8);
    Land land(5, 40, 1);
    Land expected(5, 40, 1);
    SharedDeposits deposits(land.nest, land.trail, ants, count);
    RollCall roll_call(ants, count);
    std::vector<Walk> walks(ants);
    std::vector<double> amounts(ants);
    executor->with_team([&] {
      for (std::uint32_t round = 1; round < 30; ++round) {
        std::vector<std::size_t> missing;
        for (std::size_t ant = 0; ant < ants; ++ant) {
          amounts[ant] = stream.uniform();
          walks[ant] = bring_home(land.nest, stream);
          stream.chance(0.2) ? missing.push_back(ant) : roll_call.sign(ant, round);
        }
        for_each_index(*executor, count, 1,
                       [&](std::size_t thread) { deposits.prepare(walks, roll_call, round, thread); });
        for (const std::size_t ant : missing) walks[ant] = bring_home(land.nest, stream);
        deposits.deposit(walks, amounts, true, round, *executor);
        deposit_in_turn(expected, walks, amounts, true);
        for (Land* each : {&land, &expected}) each->trail.evaporate(0.9);
      }
    });
    ASSERT_NO_FATAL_FAILURE(expect_same_pheromone(land, expected)) << threads << " threads";
  }
}

INSTANTIATE_TEST_SUITE_P(Executors, SharedDepositsBy, ::testing::ValuesIn(testing::executors_under_test()),
                         [](const auto& backend) { return backend.param; });

}  // namespace
}  // namespace pathrace::algorithms
