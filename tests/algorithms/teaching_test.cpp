// Teaching: paths that learn by splicing, and vectors that learn by group teaching optimisation.
#include "algorithms/aco/pu/teaching.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "algorithms/aco/pu/group_teaching.hpp"
#include "core/grid.hpp"

namespace pathrace::algorithms {
namespace {

const OccupancyGrid grid(8, 5);

CellPath path_of(const std::vector<Cell>& cells) {
  CellPath path;
  for (const Cell cell : cells) path.push_back(static_cast<std::uint32_t>(grid.index(cell)));
  return path;
}

Pupil pupil_of(const std::vector<Cell>& cells) {
  const CellPath path = path_of(cells);
  return {path, length_of(path, grid.stride())};
}

Splicer splicer() {
  return {grid.padded_size(), grid.stride()};
}

// Straight along row 2; through row 0 and back on row 2 at (4,2); down to row 4 at the end.
const std::vector<Cell> straight = {{0, 2}, {1, 2}, {2, 2}, {3, 2}, {4, 2}, {5, 2}, {6, 2}};
const std::vector<Cell> early_detour = {{0, 2}, {0, 1}, {0, 0}, {1, 0}, {2, 0}, {3, 0},
                                        {4, 0}, {4, 1}, {4, 2}, {5, 2}, {6, 2}};
const std::vector<Cell> late_detour = {{0, 2}, {1, 2}, {2, 2}, {3, 2}, {4, 2}, {4, 3},
                                       {4, 4}, {5, 4}, {6, 4}, {6, 3}, {6, 2}};

TEST(Splice, LengthCountsStraightAndDiagonalSteps) {
  EXPECT_EQ(length_of(path_of({{0, 0}, {1, 0}, {2, 1}, {2, 2}, {1, 3}}), grid.stride()),
            (LatticeLength{2, 2}));
  EXPECT_EQ(length_of(path_of({{3, 3}}), grid.stride()), (LatticeLength{0, 0}));
}

TEST(Splice, TakesTheTeachersRestFromTheBestSharedCell) {
  // Learner until (4,2), 4 steps, then the teacher's 2.
  EXPECT_EQ(splicer().splice(path_of(late_detour), path_of(early_detour)), path_of(straight));
}

TEST(Splice, LeavesTheLearnerAloneWhenNoJointIsShorter) {
  EXPECT_EQ(splicer().splice(path_of(straight), path_of(early_detour)), path_of(straight));
  EXPECT_EQ(splicer().splice(path_of(early_detour), path_of(early_detour)), path_of(early_detour));
}

TEST(Splice, AmongEquallyShortJointsTakesTheOneNearestToTheStart) {
  const CellPath learner = path_of({{0, 2}, {1, 1}, {2, 2}, {3, 2}, {3, 3}, {4, 3}, {5, 3}, {5, 2}});
  const CellPath teacher = path_of({{0, 2}, {1, 3}, {2, 2}, {3, 2}, {4, 2}, {5, 2}});
  EXPECT_EQ(splicer().splice(learner, teacher), teacher);
}

TEST(Splice, VisitsNoCellTwiceThoughThePathsCrossInOppositeOrder) {
  const CellPath learner = path_of(
      {{0, 0}, {1, 0}, {2, 1}, {2, 2}, {2, 3}, {3, 4}, {4, 4}, {5, 3}, {5, 2}, {5, 1}, {4, 0}, {3, 0}});
  const CellPath teacher = path_of({{0, 0}, {0, 1}, {1, 2}, {2, 2}, {1, 1}, {1, 0}, {2, 0}, {3, 0}});
  EXPECT_EQ(splicer().splice(learner, teacher), path_of({{0, 0}, {1, 0}, {2, 0}, {3, 0}}));
}

TEST(TeachPaths, InAClassOfTwoEachLearnsFromTheOther) {
  std::vector<Pupil> pupils = {pupil_of(early_detour), pupil_of(late_detour)};
  Splicer shared = splicer();
  teach_paths(pupils, true, shared, grid.stride(), Stream(1), [](std::size_t) { return true; });
  EXPECT_EQ(pupils[0].path, path_of(straight));
  EXPECT_EQ(pupils[1].path, path_of(straight));
}

TEST(TeachPaths, ThePupilsNeverGetWorseAndTheClassLearns) {
  std::vector<Pupil> pupils = {pupil_of(early_detour), pupil_of(late_detour), pupil_of(straight)};
  const Pupil best = pupils[2];
  Splicer shared = splicer();
  teach_paths(pupils, true, shared, grid.stride(), Stream(1), [](std::size_t) { return true; });
  EXPECT_EQ(pupils[2].path, best.path);
  // The worst of the ranking learns from the straight path: its detour shares start and goal at least.
  EXPECT_EQ(pupils[1].path, best.path);
}

TEST(TeachPaths, GivesAsManyLessonsAsThereAreLearnersAndStopsWhenNobodyPays) {
  const auto lessons = [](std::size_t pupils, bool grouping, std::size_t budget) {
    std::vector<Pupil> group(pupils, pupil_of(early_detour));
    std::size_t paid = 0;
    Splicer shared = splicer();
    teach_paths(group, grouping, shared, grid.stride(), Stream(2), [&](std::size_t cells) {
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
  EXPECT_EQ(ranked({pupil_of(early_detour), pupil_of(straight), pupil_of(late_detour), pupil_of(straight)}),
            (std::vector<std::size_t>{1, 3, 0, 2}));
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
