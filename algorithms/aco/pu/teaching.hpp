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
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "algorithms/aco/pu/splice.hpp"
#include "core/names.hpp"
#include "core/stream.hpp"

namespace pathrace::algorithms {

enum class Teaching { none, parameters, paths };

/// Pays for one candidate path over so many cells before it is built; false when the budget is spent, which
/// ends the teaching.
using ChargeLesson = std::function<bool(std::size_t cells)>;

/// The pupils, walks that have arrived, from the shortest path to the longest; those of equal length stay in
/// their order.
std::vector<Walk*> ranked(std::span<Walk* const> pupils);

/// Both phases. Lessons are given in rank order, each seeing the results of those before; walks that learn
/// have another path afterwards. The k-th of the ranking draws its peer from stream.fork(k).
/// `charge(cells)` is asked before each lesson.
void teach_paths(std::span<Walk* const> pupils, bool grouping, Splicer& splicer, const Stream& stream,
                 const ChargeLesson& charge);

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
