// Ants under way that change walkers: who asks, who answers, and what becomes of the walks.
#include "algorithms/aco/hand_over.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <deque>
#include <thread>
#include <vector>

#include "algorithms/aco/walker.hpp"
#include "tests/algorithms/walk_field.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/processors.hpp"

namespace pathrace::algorithms {
namespace {

constexpr int patient = 1'000'000'000;  // looks: longer than any test takes

class HandOverTest : public ::testing::Test {
 protected:
  HandOverTest() {
    second.join(first);
    third.join(first);
  }

  static void wait_until_asked(const HandOver& one) {
    while (!one.is_asked()) std::this_thread::yield();
  }

  WalkField field{testing::grid_of({"..."}), MoveRule::four, {0, 0}, {2, 0}};
  Ground ground = field.ground(DeadEnd::die);
  std::deque<Walker> walkers;
  Walker& one = walkers.emplace_back(ground, 1);
  Walker& two = walkers.emplace_back(ground, 1);
  Walker& three = walkers.emplace_back(ground, 1);
  HandOver first{one};
  HandOver second{two};
  HandOver third{three};
};

TEST_F(HandOverTest, WhoIsNotOpenIsNotAsked) {
  EXPECT_EQ(second.ask(), 0U);
  { const HandOver::Open open(first); }
  EXPECT_EQ(second.ask(), 0U);
  const HandOver::Open open(second);  // nobody asks itself
  EXPECT_EQ(second.ask(), 0U);
}

TEST_F(HandOverTest, WhoAsksGetsWhatIsGiven) {
  for (std::size_t count = 1; count < 5; ++count) {
    const HandOver::Open open(first);
    EXPECT_FALSE(first.is_asked());
    std::size_t given = 0;
    std::thread asks([&] { given = second.ask(patient); });
    wait_until_asked(first);
    const std::size_t answered = first.answer([&](const Walker& asking) {
      EXPECT_EQ(&asking, &two);
      return count;
    });
    asks.join();
    EXPECT_EQ(answered, count);
    EXPECT_EQ(given, count);
    EXPECT_FALSE(first.is_asked());
  }
}

TEST_F(HandOverTest, WhoClosesAnswers) {
  for (int round = 0; round < 100; ++round) {
    std::size_t given = 1;
    std::thread asks;
    {
      const HandOver::Open open(first);
      asks = std::thread([&] { given = second.ask(patient); });
      wait_until_asked(first);
    }
    asks.join();
    EXPECT_EQ(given, 0U);
  }
}

TEST_F(HandOverTest, WhoIsNotAnsweredSoonAsksNoLonger) {
  const HandOver::Open open(first);
  EXPECT_EQ(second.ask(), 0U);
  EXPECT_FALSE(first.is_asked());
  EXPECT_EQ(first.answer([](const Walker& /*asking*/) { return std::size_t{1}; }), 0U);
}

TEST_F(HandOverTest, WhoIsGivenNothingAsksTheNext) {
  const HandOver::Open open(first);
  const HandOver::Open next_open(third);
  std::size_t given = 0;
  std::thread asks([&] { given = second.ask(patient); });
  wait_until_asked(third);
  third.answer([](const Walker& /*asking*/) { return std::size_t{0}; });
  wait_until_asked(first);
  first.answer([](const Walker& /*asking*/) { return std::size_t{5}; });
  asks.join();
  EXPECT_EQ(given, 5U);
}

// The one that comes later neither leaves, nor is forgotten.
TEST_F(HandOverTest, ThoseWhoAskTheSameAreAnsweredInTurn) {
  const HandOver::Open open(first);
  std::size_t given_to_two = 0;
  std::size_t given_to_three = 0;
  std::thread two_asks([&] { given_to_two = second.ask(patient); });
  wait_until_asked(first);
  std::thread three_asks([&] { given_to_three = third.ask(patient); });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));  // it is likely to have found the other by then
  for (const std::size_t count : {2U, 3U}) {
    wait_until_asked(first);
    first.answer([&](const Walker& asking) {
      EXPECT_EQ(&asking, count == 2 ? &two : &three);
      return count;
    });
  }
  two_asks.join();
  three_asks.join();
  EXPECT_EQ(given_to_two, 2U);
  EXPECT_EQ(given_to_three, 3U);
}

// One walker has all ants, the other asks again and again. On the way an ant is in any state: beside others
// or the last, stuck, with steps to take back.
TEST(Walker, AnAntGoesOnWithTheSameWalkWhoeverTakesItOver) {
  if (testing::allowed_processors().size() < 2) GTEST_SKIP() << "two walkers at a time need two processors";
  WalkField field(testing::random_grid(Stream(67), 70, 70, 0.25), MoveRule::strict, {0, 0}, {69, 69});
  field.let_every_step_weigh();
  for (const DeadEnd dead_end : {DeadEnd::die, DeadEnd::backtrack, DeadEnd::revisit_with_loop_erasure}) {
    const std::size_t ants = dead_end == DeadEnd::die ? 400 : 40;
    for (const double q0 : {0.0, 0.5}) {
      for (const bool keep_popped : {false, true}) {
        Ground ground = field.ground(dead_end);
        ground.q0 = q0;
        ground.keep_popped = keep_popped;
        const Stream stream(61);
        const Meter meter({});
        std::deque<Walker> walkers;
        for (int k = 0; k < 2; ++k) walkers.emplace_back(ground, 8).join(walkers.front());
        const std::vector<Walk> expected = WalkField::walk_on(ground, ants, 61, 3000, 1);
        std::size_t taken_over = 0;
        const auto begin = std::chrono::steady_clock::now();
        while (taken_over == 0 && std::chrono::steady_clock::now() - begin < std::chrono::seconds(10)) {
          std::vector<Walk> walks(ants);
          const Outing outing{stream, 3000, meter, walks};
          AntQueue all(0, ants);
          std::atomic<bool> here{false};
          std::atomic<bool> done{false};
          std::thread idle([&] {
            here.store(true);
            AntQueue none(0, 0);
            while (!done.load()) {
              taken_over += walkers[1].run(none, outing);
            }
          });
          while (!here.load()) std::this_thread::yield();
          walkers[0].run(all, outing);
          done.store(true);
          idle.join();
          ASSERT_EQ(walks, expected) << name(dead_end) << ' ' << q0 << ' ' << keep_popped;
        }
        EXPECT_GT(taken_over, 0U) << name(dead_end) << ' ' << q0 << ' ' << keep_popped;
      }
    }
  }
}

}  // namespace
}  // namespace pathrace::algorithms
