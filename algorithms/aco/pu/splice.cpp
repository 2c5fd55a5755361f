#include "algorithms/aco/pu/splice.hpp"

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
  const std::optional<Joint> joint = shortest_joint(learner, teacher);
  for_each_cell(nest_, teacher,
                [&](std::size_t index, std::uint32_t, std::uint32_t) { visits_[index] = {}; });
  if (!joint) return false;
  learner.directions.resize(joint->on_learner);
  learner.directions.insert(learner.directions.end(),
                            teacher.directions.begin() + static_cast<std::ptrdiff_t>(joint->on_teacher),
                            teacher.directions.end());
  learner.length = joint->length;
  return true;
}

// The first of the best; nothing when none makes the learner shorter.
std::optional<Splicer::Joint> Splicer::shortest_joint(const Walk& learner, const Walk& teacher) const {
  std::optional<Joint> best;
  for_each_cell(nest_, learner, [&](std::size_t index, std::uint32_t steps, std::uint32_t diagonals) {
    const Visit& there = visits_[index];
    if (there.place == 0) return;
    const std::int64_t diagonal = teacher.length.diagonal - there.diagonals + diagonals;
    const std::uint32_t behind = there.place - 1;
    const auto all = static_cast<std::int64_t>(steps + teacher.directions.size() - behind);
    const LatticeLength length{all - diagonal, diagonal};
    if (length < (best ? best->length : learner.length)) best = {steps, behind, length};
  });
  return best;
}

}  // namespace pathrace::algorithms
