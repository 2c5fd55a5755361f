#include "algorithms/aco/pu/teaching.hpp"

#include <algorithm>
#include <numeric>

namespace pathrace::algorithms {

std::vector<std::size_t> ranked(const std::vector<Pupil>& pupils) {
  std::vector<std::size_t> order(pupils.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return pupils[i].length < pupils[j].length; });
  return order;
}

void learn(Pupil& learner, const Pupil& teacher, Splicer& splicer, std::size_t stride) {
  CellPath path = splicer.splice(learner.path, teacher.path);
  const LatticeLength length = length_of(path, stride);
  if (length < learner.length) learner = {std::move(path), length};
}

void teach_paths(std::vector<Pupil>& pupils, bool grouping, Splicer& splicer, std::size_t stride,
                 const Stream& stream, const ChargeLesson& charge) {
  if (pupils.size() < 2) return;
  const std::vector<std::size_t> order = ranked(pupils);
  const auto lesson = [&](std::size_t learner, std::size_t teacher) {
    if (!charge(pupils[order[learner]].path.size() + pupils[order[teacher]].path.size())) return false;
    learn(pupils[order[learner]], pupils[order[teacher]], splicer, stride);
    return true;
  };
  const std::size_t first_learner = grouping ? (pupils.size() + 1) / 2 : 1;
  for (std::size_t k = first_learner; k < order.size(); ++k) {
    if (!lesson(k, 0)) return;
  }
  for (std::size_t k = 0; k < order.size(); ++k) {
    std::size_t peer = stream.fork(k).below(order.size() - 1);
    peer += peer >= k ? 1 : 0;
    if (!lesson(k, peer)) return;
  }
}

}  // namespace pathrace::algorithms
