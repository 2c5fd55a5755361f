#include "algorithms/aco/pu/splice.hpp"

#include <algorithm>

namespace pathrace::algorithms {
namespace {

// Calls `visit(index, steps, diagonals)` for each cell of the path: the steps before it, and how many of them
// were diagonal.
template <typename Visit>
void for_each_cell(const Nest& nest, const Walk& walk, const Visit& visit) {
  std::size_t index = nest.start();
  std::uint32_t steps = 0;
  std::uint32_t diagonals = 0;
  visit(index, steps, diagonals);
  for (const std::uint8_t direction : walk.directions) {
    index = nest.moves().step(index, direction);
    diagonals += direction & 1U;
    visit(index, ++steps, diagonals);
  }
}

}  // namespace

bool Splicer::improve(Walk& learner, const Walk& teacher) {
  if (learner.directions == teacher.directions) return false;  // the rule in a colony that has converged
  for_each_cell(nest_, teacher, [&](std::size_t index, std::uint32_t steps, std::uint32_t diagonals) {
    visits_[index] = {steps + 1, diagonals};
  });
  const bool shorter = find_joint(learner, teacher);
  for_each_cell(nest_, teacher,
                [&](std::size_t index, std::uint32_t, std::uint32_t) { visits_[index] = {}; });
  if (!shorter) return false;
  learner.directions.resize(joint_.on_learner);
  learner.directions.insert(learner.directions.end(),
                            teacher.directions.begin() + static_cast<std::ptrdiff_t>(joint_.on_teacher),
                            teacher.directions.end());
  learner.length = shortest_;
  return true;
}

// True when there is a joint that makes the learner shorter; `joint_` is the first of the best.
bool Splicer::find_joint(const Walk& learner, const Walk& teacher) {
  shortest_ = learner.length;
  bool found = false;
  for_each_cell(nest_, learner, [&](std::size_t index, std::uint32_t steps, std::uint32_t diagonals) {
    const Visit& there = visits_[index];
    if (there.place == 0) return;
    const std::int64_t diagonal = teacher.length.diagonal - there.diagonals + diagonals;
    const std::uint32_t behind = there.place - 1;
    const auto all = static_cast<std::int64_t>(steps + teacher.directions.size() - behind);
    const LatticeLength length{all - diagonal, diagonal};
    if (length >= shortest_) return;
    shortest_ = length;
    joint_ = {steps, behind};
    found = true;
  });
  return found;
}

}  // namespace pathrace::algorithms
