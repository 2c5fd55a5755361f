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

namespace pathrace::algorithms {
namespace {

class HandOverTest : public ::testing::Test {
 protected:
  HandOverTest() {
    second.join(first);
    third.join(first);
  }

  void wait_until_asked() const {
    while (!first.is_asked()) std::this_thread::yield();
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
    std::thread asks([&] { given = second.ask(); });
    wait_until_asked();
    first.answer([&](const Walker& asking) {
      EXPECT_EQ(&asking, &two);
      return count;
    });
    asks.join();
    EXPECT_EQ(given, count);
    EXPECT_FALSE(first.is_asked());
  }
}

TEST_F(HandOverTest, WhoClosesAnswersAll) {
  std::size_t given = 1;
  std::thread asks;
  {
    const HandOver::Open open(first);
    asks = std::thread([&] { given = second.ask(); });
    wait_until_asked();
  }
  asks.join();
  EXPECT_EQ(given, 0U);
}

// The second one waits for its turn; the one that asks when nothing is left goes on to the next that is open.
TEST_F(HandOverTest, ThoseWhoAskTheSameAreAnsweredInTurn) {
  std::size_t given_to_two = 0;
  std::size_t given_to_three = 0;
  std::thread two_asks;
  std::thread three_asks;
  {
    const HandOver::Open open(first);
    two_asks = std::thread([&] { given_to_two = second.ask(); });
    three_asks = std::thread([&] { given_to_three = third.ask(); });
    for (int answers = 0; answers < 2; ++answers) {
      wait_until_asked();
      first.answer([&](const Walker& asking) { return &asking == &two ? 2U : 3U; });
    }
  }
  two_asks.join();
  three_asks.join();
  EXPECT_EQ(given_to_two, 2U);
  EXPECT_EQ(given_to_three, 3U);
}

// One walker has all ants, the other asks again and again. On the way an ant is in any state: beside others
// or the last, stuck, with steps to take back.
TEST(Walker, AnAntGoesOnWithTheSameWalkWhoeverTakesItOver) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "two walkers at a time need two processors";
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
              walkers[1].run(none, outing);
              taken_over += walkers[1].taken_over();
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
