#include "algorithms/aco/tan/connectivity.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "core/checkpoint.hpp"

namespace pathrace::algorithms {
namespace {

constexpr double touching = 1e-9;

// Disjoint sets of indices; the representative of a set is its smallest index.
class Union {
 public:
  explicit Union(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

bool connected(const Circle& a, const Circle& b) {
  const double dx = a.centre.x - b.centre.x;
  const double dy = a.centre.y - b.centre.y;
  const double reach = a.radius + b.radius + touching;
  return dx * dx + dy * dy <= reach * reach;
}

std::vector<CircleSet> connected_sets(const std::vector<Circle>& circles) {
  std::vector<std::size_t> order(circles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto left = [&](std::size_t i) { return circles[i].centre.x - circles[i].radius; };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return left(i) < left(j); });

  Union sets(circles.size());
  for (std::size_t a = 0; a < order.size(); ++a) {
    checkpoint();
    const Circle& circle = circles[order[a]];
    const double right = circle.centre.x + circle.radius + touching;
    for (std::size_t b = a + 1; b < order.size() && left(order[b]) <= right; ++b) {
      if (connected(circle, circles[order[b]])) sets.join(order[a], order[b]);
    }
  }

  std::vector<CircleSet> result;
  std::vector<std::size_t> place(circles.size());
  for (std::size_t i = 0; i < circles.size(); ++i) {
    const std::size_t first = sets.find(i);
    if (first == i) {
      place[i] = result.size();
      result.emplace_back();
    }
    result[place[first]].push_back(circles[i]);
  }
  return result;
}

}  // namespace pathrace::algorithms
