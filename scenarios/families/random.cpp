// Random maps: each cell is blocked with the same probability, independently of the others.
//
// Unlike `dense`, maps may be denser than what percolates: start and goal lie far apart in the largest
// region, whatever its shape.
#include "scenarios/generated.hpp"

namespace pathrace::scenarios {
namespace {

struct RandomSettings : Placement {
  int percent = 35;
};

Sketch draw(const RandomSettings& settings, int n, Stream& stream) {
  Sketch sketch{OccupancyGrid(n, n), {}, {}};
  const double probability = settings.percent / 100.0;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      if (stream.chance(probability)) sketch.grid.block({x, y});
    }
  }
  return sketch;
}

}  // namespace

Family random_family() {
  const GeneratedCard card{"random",
                           "each cell blocked with the same probability, ends far apart",
                           "percent",
                           Ends::far,
                           {"20-35", "64-35"}};
  return generated_family<RandomSettings>(
      card,
      {integer("percent", &RandomSettings::percent, 0, 60, "%", Source::ours, "chance of a blocked cell")},
      draw);
}

}  // namespace pathrace::scenarios
