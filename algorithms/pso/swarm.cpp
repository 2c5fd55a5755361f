#include "algorithms/pso/swarm.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace pathrace::algorithms {

Swarm::Swarm(const SwarmSettings& settings, SwarmBox box) : settings_(settings), box_(std::move(box)) {
  const auto particles = static_cast<std::size_t>(settings.particles);
  positions_.resize(particles * dimensions());
  velocities_.resize(particles * dimensions());
  bests_.resize(particles * dimensions());
  costs_.resize(particles);
  best_costs_.resize(particles);
  forget();
}

void Swarm::forget() {
  std::fill(best_costs_.begin(), best_costs_.end(), infinite);
  std::fill(costs_.begin(), costs_.end(), infinite);
  leader_ = 0;
}

// The particle whose best place particle i follows: the lowest index among the best.
std::size_t Swarm::guide_of(std::size_t i) const {
  const auto reach = static_cast<std::size_t>(settings_.neighbours);
  if (settings_.topology == Topology::global || 2 * reach + 1 >= size()) return leader_;
  std::size_t guide = i;
  for (std::size_t step = 1; step <= reach; ++step) {
    for (const std::size_t other : {(i + step) % size(), (i + size() - step) % size()}) {
      const bool better = best_costs_[other] < best_costs_[guide];
      if (better || (best_costs_[other] == best_costs_[guide] && other < guide)) guide = other;
    }
  }
  return guide;
}

// In blocks, so that the draws stay scalar and the arithmetic becomes vectors. One draw gives r1 and r2, 32
// bits each.
void Swarm::move(std::size_t i, const Momentum& momentum, Stream stream) {
  constexpr std::size_t block = 16;
  std::array<double, block> own_pull;
  std::array<double, block> guide_pull;
  const std::size_t dims = dimensions();
  double* const x = positions_.data() + i * dims;
  double* const v = velocities_.data() + i * dims;
  const double* const own = bests_.data() + i * dims;
  const double* const guide = bests_.data() + guide_of(i) * dims;
  const double* const low = box_.low.data();
  const double* const high = box_.high.data();
  const double* const fastest = box_.max_speed.data();
  for (std::size_t begin = 0; begin < dims; begin += block) {
    const std::size_t count = std::min(block, dims - begin);
    for (std::size_t k = 0; k < count; ++k) {
      const std::uint64_t bits = stream.bits();
      own_pull[k] = settings_.c1 * (static_cast<double>(bits >> 32) * 0x1.0p-32);
      guide_pull[k] = settings_.c2 * (static_cast<double>(bits & 0xFFFFFFFFU) * 0x1.0p-32);
    }
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t d = begin + k;
      const double pulls = own_pull[k] * (own[d] - x[d]) + guide_pull[k] * (guide[d] - x[d]);
      const double speed = momentum.scale * (momentum.inertia * v[d] + pulls);
      v[d] = std::min(std::max(speed, -fastest[d]), fastest[d]);
      x[d] = std::min(std::max(x[d] + v[d], low[d]), high[d]);
    }
  }
}

bool Swarm::learn(std::size_t count) {
  bool improved = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (!(costs_[i] < best_costs_[i])) continue;
    if (costs_[i] < best_costs_[leader_]) {
      leader_ = i;
      improved = true;
    }
    best_costs_[i] = costs_[i];
    std::copy_n(position(i).data(), dimensions(), bests_.data() + i * dimensions());
  }
  return improved;
}

}  // namespace pathrace::algorithms
