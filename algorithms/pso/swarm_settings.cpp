#include "algorithms/pso/swarm_settings.hpp"

#include <algorithm>
#include <cmath>

namespace pathrace::algorithms {

const std::vector<Field<SwarmSettings>>& swarm_fields() {
  using S = SwarmSettings;
  static const std::vector<Field<S>> fields = {
      integer("particles", &S::particles, 1, 100000, "particles", Source::field, "N, size of the swarm"),
      choice("inertia", &S::inertia, Source::paper,
             "linear: w falls from w_start to w_end, eq. (4); constant: w_start; constriction: Clerc and "
             "Kennedy's factor of c1 + c2 in place of w"),
      real("w_start", &S::w_start, 0, 2, "", Source::paper, "inertia weight at first"),
      real("w_end", &S::w_end, 0, 2, "", Source::paper, "inertia weight at last"),
      real("c1", &S::c1, 0, 10, "", Source::paper, "pull towards a particle's own best, eq. (1)"),
      real("c2", &S::c2, 0, 10, "", Source::paper, "pull towards the swarm's best, eq. (1)"),
      real("v_max", &S::v_max, 0, 10, "half ranges", Source::field,
           "greatest speed per coordinate and iteration, eq. (3), as a share of half the coordinate's range"),
      choice("topology", &S::topology, Source::paper,
             "whose best a particle follows: of the whole swarm, or of its neighbours on a ring"),
      integer("neighbours", &S::neighbours, 1, 1000, "particles", Source::field,
              "neighbours on each side, for the ring"),
  };
  return fields;
}

Momentum momentum(const SwarmSettings& settings, std::size_t k, std::size_t last) {
  switch (settings.inertia) {
    case InertiaRule::linear: {
      const double share = last == 0 ? 1 : std::min(1.0, static_cast<double>(k) / static_cast<double>(last));
      return {settings.w_start - (settings.w_start - settings.w_end) * share, 1};
    }
    case InertiaRule::constant: return {settings.w_start, 1};
    case InertiaRule::constriction: {
      const double phi = settings.c1 + settings.c2;
      if (phi <= 4) return {1, 1};  // Clerc and Kennedy: nothing to restrain
      return {1, 2 / (phi - 2 + std::sqrt(phi * phi - 4 * phi))};
    }
  }
  return {};
}

}  // namespace pathrace::algorithms
