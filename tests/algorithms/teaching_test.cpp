// Teaching: paths that learn by splicing, and vectors that learn by group teaching optimisation.
#include "algorithms/aco/pu/teaching.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "algorithms/aco/pu/group_teaching.hpp"
#include "core/grid.hpp"
#include "tests/support/crooked_path.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/walks.hpp"

namespace pathrace::algorithms {
namespace {

const OccupancyGrid empty(8, 5);

using testing::cells_over;
using testing::walk_over;
using Cells = std::vector<Cell>;

Nest nest_of(const Cells& cells) {
  return Nest({empty, MoveRule::free, cells.front(), cells.back()});
}

// What the learner's path becomes.
Cells spliced(const Cells& learner, const Cells& teacher) {
  const Nest nest = nest_of(learner);
  Splicer splicer(nest);
  Walk walk = walk_over(learner);
  const bool improved = splicer.improve(walk, walk_over(teacher));
  EXPECT_EQ(improved, walk != walk_over(learner));
  EXPECT_EQ(walk.length, length_of(walk.directions));
  EXPECT_FALSE(splicer.improve(walk, walk_over(teacher)));  // no trace of the first lesson is left
  return cells_over(nest, walk);
}

// Straight along row 2; through row 0 and back on row 2 at (4,2); down to row 4 at the end.
const Cells straight = {{0, 2}, {1, 2}, {2, 2}, {3, 2}, {4, 2}, {5, 2}, {6, 2}};
const Cells early_detour = {{0, 2}, {0, 1}, {0, 0}, {1, 0}, {2, 0}, {3, 0},
                            {4, 0}, {4, 1}, {4, 2}, {5, 2}, {6, 2}};
const Cells late_detour = {{0, 2}, {1, 2}, {2, 2}, {3, 2}, {4, 2}, {4, 3},
                           {4, 4}, {5, 4}, {6, 4}, {6, 3}, {6, 2}};

TEST(Splice, TakesTheTeachersRestFromTheBestSharedCell) {
  // Learner until (4,2), 4 steps, then the teacher's 2.
  EXPECT_EQ(spliced(late_detour, early_detour), straight);
}

TEST(Splice, LeavesTheLearnerAloneWhenNoJointIsShorter) {
  EXPECT_EQ(spliced(straight, early_detour), straight);
  EXPECT_EQ(spliced(early_detour, early_detour), early_detour);
}

TEST(Splice, AmongEquallyShortJointsTakesTheOneNearestToTheStart) {
  const Cells teacher = {{0, 2}, {1, 3}, {2, 2}, {3, 2}, {4, 2}, {5, 2}};
  EXPECT_EQ(spliced({{0, 2}, {1, 1}, {2, 2}, {3, 2}, {3, 3}, {4, 3}, {5, 3}, {5, 2}}, teacher), teacher);
}

TEST(Splice, VisitsNoCellTwiceThoughThePathsCrossInOppositeOrder) {
  const Cells learner = {{0, 0}, {1, 0}, {2, 1}, {2, 2}, {2, 3}, {3, 4},
                         {4, 4}, {5, 3}, {5, 2}, {5, 1}, {4, 0}, {3, 0}};
  const Cells teacher = {{0, 0}, {0, 1}, {1, 2}, {2, 2}, {1, 1}, {1, 0}, {2, 0}, {3, 0}};
  EXPECT_EQ(spliced(learner, teacher), (Cells{{0, 0}, {1, 0}, {2, 0}, {3, 0}}));
}

// Against a search through all joints.
TEST(Splice, FindsTheFirstOfTheShortestJointsOfRandomWalks) {
  int improved = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Stream stream = Stream(401).fork(i);
    const testing::Question question = testing::random_question(stream, 12, 0.2);
    const Nest nest({question.grid, MoveRule::strict, question.start, question.goal});
    const auto crooked = [&](std::uint64_t k) {
      return testing::crooked_path(question.grid, MoveRule::strict, question.start, question.goal,
                                   stream.fork(k));
    };
    const Cells old = crooked(1);
    const Cells other = crooked(2);
    if (old.empty()) continue;
    Walk learner = walk_over(old);
    Cells best = old;
    LatticeLength shortest = learner.length;
    for (std::size_t at = 0; at < old.size(); ++at) {
      const auto there = std::ranges::find(other, old[at]);
      if (there == other.end()) continue;
      Cells tried(old.begin(), old.begin() + static_cast<std::ptrdiff_t>(at));
      tried.insert(tried.end(), there, other.end());
      LatticeLength length;
      for (std::size_t k = 1; k < tried.size(); ++k) {
        const bool slanted = tried[k].x != tried[k - 1].x && tried[k].y != tried[k - 1].y;
        length = length + (slanted ? LatticeLength{0, 1} : LatticeLength{1, 0});
      }
      if (length >= shortest) continue;
      shortest = length;
      best = tried;
    }
    Splicer splicer(nest);
    improved += splicer.improve(learner, walk_over(other)) ? 1 : 0;
    EXPECT_EQ(cells_over(nest, learner), best) << i;
    EXPECT_EQ(learner.length, shortest) << i;
  }
  EXPECT_GT(improved, 50);
}

struct Class {
  explicit Class(const std::vector<Cells>& paths) {
    for (const Cells& path : paths) walks.push_back(walk_over(path));
    for (Walk& walk : walks) pupils.push_back(&walk);
  }

  void learn(bool grouping, std::uint64_t seed, const ChargeLesson& charge) {
    const Nest nest = nest_of(straight);
    Splicer splicer(nest);
    teach_paths(pupils, grouping, splicer, Stream(seed), charge);
  }

  std::vector<Walk> walks;
  std::vector<Walk*> pupils;
};

bool free_of_charge(std::size_t /*cells*/) {
  return true;
}

TEST(TeachPaths, InAClassOfTwoEachLearnsFromTheOther) {
  Class two({early_detour, late_detour});
  two.learn(true, 1, free_of_charge);
  EXPECT_EQ(two.walks[0], walk_over(straight));
  EXPECT_EQ(two.walks[1], walk_over(straight));
}

TEST(TeachPaths, ThePupilsNeverGetWorseAndTheClassLearns) {
  Class three({early_detour, late_detour, straight});
  three.learn(true, 1, free_of_charge);
  EXPECT_EQ(three.walks[2], walk_over(straight));
  // The worst of the ranking learns from the straight path: its detour shares start and goal at least.
  EXPECT_EQ(three.walks[1], walk_over(straight));
}

TEST(TeachPaths, GivesAsManyLessonsAsThereAreLearnersAndStopsWhenNobodyPays) {
  const auto lessons = [](std::size_t pupils, bool grouping, std::size_t budget) {
    Class alike(std::vector<Cells>(pupils, early_detour));
    std::size_t paid = 0;
    alike.learn(grouping, 2, [&](std::size_t cells) {
      EXPECT_EQ(cells, 2 * early_detour.size());
      if (paid == budget) return false;
      ++paid;
      return true;
    });
    return paid;
  };
  EXPECT_EQ(lessons(6, true, 1000), 3U + 6U);  // the average half, then everybody
  EXPECT_EQ(lessons(7, true, 1000), 3U + 7U);
  EXPECT_EQ(lessons(6, false, 1000), 5U + 6U);  // all but the teacher, then everybody
  EXPECT_EQ(lessons(6, true, 4), 4U);
  EXPECT_EQ(lessons(1, true, 1000), 0U);
}

TEST(TeachPaths, RanksByLengthAndThenByIndex) {
  const Class four({early_detour, straight, late_detour, straight});
  const std::vector<Walk*>& p = four.pupils;
  EXPECT_EQ(ranked(p), (std::vector<Walk*>{p[1], p[3], p[0], p[2]}));
}

constexpr Bounds bounds{{0.5, 1, 0.05, 0.1}, {3, 9, 0.6, 100}};
constexpr Student origin{1, 7, 0.3, 1};

// How far a student is from alpha 2, beta 3, evaporation 0.2, deposit 40, each as a share of its range.
double strangeness(const Student& student) {
  const Student target{2, 3, 0.2, 40};
  double sum = 0;
  for (std::size_t k = 0; k < student.size(); ++k) {
    const double share = (student[k] - target[k]) / (bounds.high[k] - bounds.low[k]);
    sum += share * share;
  }
  return sum;
}

std::vector<double> fitness_of(const std::vector<Student>& students) {
  std::vector<double> fitness;
  for (const Student& student : students) fitness.push_back(strangeness(student));
  return fitness;
}

TEST(Classroom, BeginsWithTheOriginAndStudentsBetweenTheBounds) {
  const Classroom room(5, origin, bounds, true, Stream(3));
  const std::vector<Student> first = room.candidates(Stream(4));
  ASSERT_EQ(first.size(), 6U);
  EXPECT_EQ(first[0], origin);
  EXPECT_EQ(std::vector<Student>(first.begin(), first.end() - 1), room.students());
  EXPECT_EQ(std::set<Student>(first.begin(), first.end()).size(), 6U);
}

TEST(Classroom, EveryCandidateStaysWithinItsBoundsAndNoStudentGetsWorse) {
  for (const bool grouping : {false, true}) {
    Classroom room(5, origin, bounds, grouping, Stream(5));
    std::vector<double> before(5, std::numeric_limits<double>::infinity());
    for (std::uint64_t t = 0; t < 60; ++t) {
      const std::vector<Student> tried = room.candidates(Stream(6).fork(t));
      for (const Student& student : tried) {
        for (std::size_t k = 0; k < student.size(); ++k) {
          EXPECT_GE(student[k], bounds.low[k]);
          EXPECT_LE(student[k], bounds.high[k]);
        }
      }
      room.judge(tried, fitness_of(tried));
      for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_LE(room.fitness()[i], before[i]);
        EXPECT_DOUBLE_EQ(room.fitness()[i], strangeness(room.students()[i]));
      }
      before = room.fitness();
    }
  }
}

TEST(Classroom, LearnsWhatItsFitnessAsksFor) {
  int far_better = 0;
  for (std::uint64_t run = 0; run < 10; ++run) {
    Classroom room(8, origin, bounds, true, Stream(7).fork(run));
    const auto best = [&room] { return *std::min_element(room.fitness().begin(), room.fitness().end()); };
    double first = 0;
    for (std::uint64_t t = 0; t < 200; ++t) {
      const std::vector<Student> tried = room.candidates(Stream(8).fork(run).fork(t));
      room.judge(tried, fitness_of(tried));
      if (t == 0) first = best();
    }
    EXPECT_LT(best(), first / 2) << run;
    far_better += best() < first / 10 ? 1 : 0;
  }
  EXPECT_GE(far_better, 5);
}

TEST(Classroom, WithoutGroupingEveryStudentMovesStraightTowardsTheTeacher) {
  constexpr double far = 1e6;
  const Bounds wide{{-far, -far, -far, -far}, {far, far, far, far}};
  Classroom room(4, {1, 2, 3, 4}, wide, false, Stream(9));
  const std::vector<Student> first = room.candidates(Stream(10));
  // The mean of three is the worst of all, so the teacher is the best student, number 2.
  room.judge(first, {3, 2, 1, 4, 9});
  const std::vector<Student> second = room.candidates(Stream(11));
  const Student& teacher = first[2];
  EXPECT_EQ(second[2], teacher);
  for (const std::size_t i : {0U, 1U, 3U}) {
    std::vector<double> shares;
    for (std::size_t k = 0; k < 4; ++k) {
      if (std::abs(second[i][k]) == far) continue;  // met a bound
      shares.push_back((second[i][k] - first[i][k]) / (teacher[k] - first[i][k]));
    }
    ASSERT_FALSE(shares.empty());
    for (const double share : shares) {
      EXPECT_GE(share, 0);
      EXPECT_LT(share, 2);
      EXPECT_NEAR(share, shares[0], 1e-9);
    }
  }
}

TEST(Classroom, AMeanOfTheBestThreeThatIsBetterTeaches) {
  const Bounds wide{{-1e6, -1e6, -1e6, -1e6}, {1e6, 1e6, 1e6, 1e6}};
  Classroom room(3, {1, 2, 3, 4}, wide, false, Stream(12));
  const std::vector<Student> first = room.candidates(Stream(13));
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(first[3][k], (first[0][k] + first[1][k] + first[2][k]) / 3, 1e-6);
  }
  room.judge(first, {3, 2, 1, 0.5});
  const std::vector<Student> second = room.candidates(Stream(14));
  EXPECT_NE(second[2], first[2]);  // the best student learns, too
}

}  // namespace
}  // namespace pathrace::algorithms
