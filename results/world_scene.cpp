#include "results/world_scene.hpp"

#include "core/world_motion.hpp"

namespace pathrace::results {

WorldScene scene_of(const World& world, const std::vector<Point>& points) {
  WorldMotion motion(world);
  WorldScene scene;
  scene.disc_trails.resize(world.discs.size() - world.walls);
  const auto note = [&] {
    for (std::size_t i = world.walls; i < world.discs.size(); ++i) {
      scene.disc_trails[i - world.walls].push_back(motion.discs()[i].centre);
    }
    scene.goal_trail.push_back(motion.goal());
  };
  note();
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    motion.advance(points[k]);
    note();
  }
  scene.discs.assign(motion.discs().begin(), motion.discs().end());
  scene.goal = motion.goal();
  return scene;
}

}  // namespace pathrace::results
