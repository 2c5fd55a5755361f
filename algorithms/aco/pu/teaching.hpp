// Teaching among paths: the ants of an iteration as a class of students.
//
//   teacher phase   the teacher is the shortest path of the class. With grouping, the better half is the
//                   outstanding group and each of the average group learns from the teacher; the outstanding
//                   ones do not. Without grouping all but the teacher learn from it.
//   student phase   every student learns from a random other one.
//
// To learn is to splice the other's path into one's own; the result is kept only if it is shorter. Each
// splice that is tried is a candidate path judged by its cost, so one evaluation.
//
// A reconstruction (algorithms.md 3.5, mapping B): of the paper only page 767 is known, which names "grouped
// teaching" in its title; the phases are those of Y. Zhang, Z. Jin, "Group teaching optimization algorithm",
// Expert Systems with Applications 148, 2020.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "algorithms/aco/pu/splice.hpp"
#include "core/names.hpp"
#include "core/stream.hpp"

namespace pathrace::algorithms {

enum class Teaching { none, parameters, paths };

/// One student: a path and its length.
struct Pupil {
  CellPath path;
  LatticeLength length;
};

/// Pays for one candidate path over so many cells before it is built; false when the budget is spent, which
/// ends the teaching.
using ChargeLesson = std::function<bool(std::size_t cells)>;

/// Indices of the pupils from the shortest path to the longest, ties by index.
std::vector<std::size_t> ranked(const std::vector<Pupil>& pupils);

/// Replaces the learner's path when the splice is shorter.
void learn(Pupil& learner, const Pupil& teacher, Splicer& splicer, std::size_t stride);

/// Both phases. Lessons are given in rank order, each seeing the results of those before. The k-th of the
/// ranking draws its peer from stream.fork(k). `charge(cells)` is asked before each lesson.
void teach_paths(std::vector<Pupil>& pupils, bool grouping, Splicer& splicer, std::size_t stride,
                 const Stream& stream, const ChargeLesson& charge);

}  // namespace pathrace::algorithms

namespace pathrace {
template <>
inline constexpr auto names_of<algorithms::Teaching> =
    std::to_array<std::pair<algorithms::Teaching, std::string_view>>({
        {algorithms::Teaching::none, "none"},
        {algorithms::Teaching::parameters, "parameters"},
        {algorithms::Teaching::paths, "paths"},
    });
}  // namespace pathrace
