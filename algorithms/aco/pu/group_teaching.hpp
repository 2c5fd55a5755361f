// Group teaching optimisation: a class of vectors that learns from its teacher and from each other.
//
//   grouping   sorted by fitness, the better half is the outstanding group, the rest the average group
//   teacher    the best student, or the mean of the best three when that is better
//   outstanding  x' = x + a (T - F (b M + c x)),  M the mean of the group, F in {1, 2}, b + c = 1
//   average      x' = x + 2 d (T - x)
//   student    x'' = x' + e (x' - x'_j) + g (x' - x) when x' is better than the peer's, x' - e (x' - x'_j) +
//   ...
//              otherwise
//   A candidate takes the place of its student only if it is better. a, b, d, e, g are uniform in [0, 1),
//   drawn once per student and phase.
//
// Y. Zhang, Z. Jin, Expert Systems with Applications 148, 2020, as read from an open implementation
// (algorithms.md 3.5, tags [S] and [M]). Here a student is a colony's (alpha, beta, evaporation, deposit) and
// its fitness the length of the best path that its ants found: mapping A of the reconstruction.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/stream.hpp"

namespace pathrace::algorithms {

/// alpha, beta, evaporation, deposit.
using Student = std::array<double, 4>;

struct Bounds {
  Student low;
  Student high;
};

class Classroom {
 public:
  /// `count` >= 3 students: the first is `origin`, the others are uniform between the bounds. Whether the
  /// better half is treated differently is `grouping`.
  Classroom(std::size_t count, const Student& origin, const Bounds& bounds, bool grouping, Stream stream);

  /// Whom to try next: one candidate per student, and last the mean of the best three (before anything is
  /// known: of the first three). The first call returns the students themselves; then teacher and student
  /// phases alternate.
  std::vector<Student> candidates(const Stream& stream) const;

  /// The fitness of each of those candidates, in the same order; less is better, infinity for "no path".
  void judge(const std::vector<Student>& tried, const std::vector<double>& fitness);

  const std::vector<Student>& students() const { return students_; }
  const std::vector<double>& fitness() const { return fitness_; }

 private:
  enum class Phase { first, teacher, student };

  std::vector<std::size_t> ranking() const;
  Student mean_of_best(std::size_t count) const;
  Student outstanding(std::size_t i, const Student& group_mean, Stream stream) const;
  Student average(std::size_t i, Stream stream) const;
  Student peer_taught(std::size_t i, Stream stream) const;
  Student bounded(Student student) const;

  Bounds bounds_;
  bool grouping_;
  Phase phase_ = Phase::first;
  std::vector<Student> students_;
  std::vector<Student> before_;  // the students before the teacher phase
  std::vector<double> fitness_;
  Student teacher_{};
};

}  // namespace pathrace::algorithms
