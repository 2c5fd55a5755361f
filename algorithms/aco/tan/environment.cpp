#include "algorithms/aco/tan/environment.hpp"

#include "algorithms/aco/tan/preplanned_path.hpp"

namespace pathrace::algorithms {

Environment environment_of(const Problem& problem, const CoverSettings& cover_settings,
                           const GaussianField& field) {
  Environment environment;
  environment.circles =
      cover(problem.grid, cover_settings, Stream(0));  // the order changes speed, not circles
  environment.sets = connected_sets(environment.circles);
  environment.preplanned = preplanned_path(centre(problem.start), centre(problem.goal), environment.sets);
  environment.pheromone = gaussian_field(problem.grid, environment.preplanned, field);
  return environment;
}

void draw(const Environment& environment, Overlay& overlay) {
  for (const Circle& circle : environment.circles) overlay.circles.push_back({circle.centre, circle.radius});
  overlay.polyline = environment.preplanned;
}

}  // namespace pathrace::algorithms
