#include "algorithms/aco/pu/splice.hpp"

#include <cstddef>

namespace pathrace::algorithms {
namespace {

LatticeLength step_length(std::uint32_t from, std::uint32_t to, std::size_t stride) {
  const std::size_t difference = from < to ? to - from : from - to;
  return difference == 1 || difference == stride ? LatticeLength{1, 0} : LatticeLength{0, 1};
}

// Length of the way from each cell of the path to its end.
std::vector<LatticeLength> lengths_to_go(const CellPath& path, std::size_t stride) {
  std::vector<LatticeLength> lengths(path.size());
  for (std::size_t i = path.size() - 1; i > 0; --i) {
    lengths[i - 1] = lengths[i] + step_length(path[i - 1], path[i], stride);
  }
  return lengths;
}

}  // namespace

LatticeLength length_of(const CellPath& path, std::size_t stride) {
  LatticeLength length;
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    length = length + step_length(path[i], path[i + 1], stride);
  return length;
}

CellPath Splicer::splice(const CellPath& learner, const CellPath& teacher) {
  const std::vector<LatticeLength> to_go = lengths_to_go(teacher, stride_);
  for (std::size_t i = 0; i < teacher.size(); ++i) place_[teacher[i]] = static_cast<std::uint32_t>(i + 1);
  LatticeLength gone;
  LatticeLength shortest = length_of(learner, stride_);
  std::size_t joint = learner.size() - 1;
  for (std::size_t i = 0; i < learner.size(); ++i) {
    if (i > 0) gone = gone + step_length(learner[i - 1], learner[i], stride_);
    const std::uint32_t there = place_[learner[i]];
    if (there == 0 || gone + to_go[there - 1] >= shortest) continue;
    shortest = gone + to_go[there - 1];
    joint = i;
  }
  const std::uint32_t there = place_[learner[joint]];
  for (const std::uint32_t cell : teacher) place_[cell] = 0;
  CellPath result(learner.begin(), learner.begin() + static_cast<std::ptrdiff_t>(joint) + 1);
  result.insert(result.end(), teacher.begin() + there, teacher.end());
  return result;
}

}  // namespace pathrace::algorithms
