#include "baselines/any_angle/free_runs.hpp"

#include "core/checkpoint.hpp"

namespace pathrace::baselines {

FreeRuns::FreeRuns(const OccupancyGrid& grid) : width_(static_cast<std::size_t>(grid.width())) {
  at_or_after_.reserve(width_ * static_cast<std::size_t>(grid.height()));
  for (int y = 0; y < grid.height(); ++y) {
    checkpoint();
    first_in_row_.push_back(runs_.size());
    bool inside = false;
    for (int x = 0; x < grid.width(); ++x) {
      const bool is_free = grid.is_free({x, y});
      if (is_free && !inside) runs_.push_back({2 * x - 1, 2 * x + 1});
      if (is_free) runs_.back().right = 2 * x + 1;
      inside = is_free;
      at_or_after_.push_back(static_cast<std::uint32_t>(runs_.size() - (is_free ? 1 : 0)));
    }
  }
  first_in_row_.push_back(runs_.size());
}

}  // namespace pathrace::baselines
