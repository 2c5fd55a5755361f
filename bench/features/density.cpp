#include "bench/features/feature.hpp"

namespace pathrace::bench {
namespace {

std::optional<double> density(FeatureContext& context) {
  const OccupancyGrid& grid = context.scenario().grid();
  const std::int64_t cells = std::int64_t{grid.width()} * grid.height();
  return static_cast<double>(cells - grid.free_cells()) / static_cast<double>(cells);
}

}  // namespace

Feature density_feature() {
  return {"density", "share", "blocked share of the cells", FeatureType::real, density};
}

}  // namespace pathrace::bench
