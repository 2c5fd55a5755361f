#include "algorithms/aco/pu/teaching.hpp"

#include <algorithm>

namespace pathrace::algorithms {
namespace {

std::size_t cells(const Walk& walk) {
  return walk.directions.size() + 1;
}

}  // namespace

std::vector<Walk*> ranked(std::span<Walk* const> pupils) {
  std::vector<Walk*> order(pupils.begin(), pupils.end());
  std::ranges::stable_sort(order, std::less{}, [](const Walk* walk) { return walk->length; });
  return order;
}

void teach_paths(std::span<Walk* const> pupils, bool grouping, Splicer& splicer, const Stream& stream,
                 const ChargeLesson& charge) {
  if (pupils.size() < 2) return;
  const std::vector<Walk*> order = ranked(pupils);
  const auto lesson = [&](Walk& learner, const Walk& teacher) {
    if (!charge(cells(learner) + cells(teacher))) return false;
    splicer.improve(learner, teacher);
    return true;
  };
  const std::size_t first_learner = grouping ? (order.size() + 1) / 2 : 1;
  for (std::size_t k = first_learner; k < order.size(); ++k) {
    if (!lesson(*order[k], *order[0])) return;
  }
  for (std::size_t k = 0; k < order.size(); ++k) {
    std::size_t peer = stream.fork(k).below(order.size() - 1);
    peer += peer >= k ? 1 : 0;
    if (!lesson(*order[k], *order[peer])) return;
  }
}

}  // namespace pathrace::algorithms
