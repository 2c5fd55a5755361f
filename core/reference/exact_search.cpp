#include "core/reference/exact_search.hpp"

#include "core/reference/distance_field.hpp"

namespace pathrace::reference {

Optimum optimum(const Terrain& terrain, Cell start, Cell goal) {
  return {true, DistanceField(terrain, start, goal).length(goal)};
}

}  // namespace pathrace::reference
