#include "scenarios/components.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace pathrace::scenarios {
namespace {

class Regions {
 public:
  explicit Regions(const OccupancyGrid& grid) : grid_(grid), label_(grid.padded_size(), 0) {}

  // Labels the region of a free, unlabelled cell and returns its size.
  std::size_t flood(std::size_t seed, std::uint32_t label) {
    const std::size_t stride = grid_.stride();
    open_.assign(1, static_cast<std::uint32_t>(seed));
    label_[seed] = label;
    std::size_t size = 0;
    while (!open_.empty()) {
      const std::size_t index = open_.back();
      open_.pop_back();
      ++size;
      for (const std::size_t next : {index - stride, index + stride, index - 1, index + 1}) {
        if (!is_new(next)) continue;
        label_[next] = label;
        open_.push_back(static_cast<std::uint32_t>(next));
      }
    }
    return size;
  }

  bool is_new(std::size_t index) const { return !grid_.blocked_at(index) && label_[index] == 0; }
  std::uint32_t label(std::size_t index) const { return label_[index]; }

 private:
  const OccupancyGrid& grid_;
  std::vector<std::uint32_t> label_;  // 0: none yet
  std::vector<std::uint32_t> open_;
};

}  // namespace

std::vector<Cell> largest_region(const OccupancyGrid& grid) {
  Regions regions(grid);
  std::uint32_t labels = 0;
  std::uint32_t largest = 0;
  std::size_t most = 0;
  for (std::size_t index = 0; index < grid.padded_size(); ++index) {
    if (!regions.is_new(index)) continue;
    const std::size_t size = regions.flood(index, ++labels);
    if (size <= most) continue;
    most = size;
    largest = labels;
  }
  std::vector<Cell> cells;
  cells.reserve(most);
  for (std::size_t index = 0; most > 0 && index < grid.padded_size(); ++index) {
    if (regions.label(index) == largest) cells.push_back(grid.cell(index));
  }
  return cells;
}

}  // namespace pathrace::scenarios
