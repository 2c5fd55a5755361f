#include "algorithms/pso/swarm.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "algorithms/draws.hpp"

namespace pathrace::algorithms {
namespace {

constexpr std::size_t block = 16;  // coordinates of a particle that move together

// The share in [0, 1) of a whole number below 2^32. Its bits go under those of 2^52: a vector instruction
// does that, where there is none to make floating point numbers of 64 bits.
double share_of(std::uint64_t bits) {
  constexpr double base = 0x1.0p52;
  return (std::bit_cast<double>(std::bit_cast<std::uint64_t>(base) | bits) - base) * 0x1.0p-32;
}

// By value: references would keep the loop from becoming vectors.
double clipped(double value, double low, double high) {
  const double raised = value < low ? low : value;
  return high < raised ? high : raised;
}

struct Pulls {
  double c1;
  double c2;
  const double* own;
  const double* best;
  const std::uint64_t* draws;  // each gives r1 and r2, 32 bits each
};

struct Limits {
  const double* low;
  const double* high;
  const double* speed;
};

// Equations (1) to (3), for a block of coordinates of one particle.
void follow(const Pulls& pulls, const Momentum& momentum, const Limits& limits, std::size_t count,
            double* __restrict v, double* __restrict x) {
  const auto [c1, c2, own, best, draws] = pulls;
  const auto [low, high, fastest] = limits;
  const auto [inertia, scale] = momentum;
  for (std::size_t d = 0; d < count; ++d) {
    const double r1 = share_of(draws[d] >> 32);
    const double r2 = share_of(draws[d] & 0xFFFFFFFFU);
    const double pull = c1 * r1 * (own[d] - x[d]) + c2 * r2 * (best[d] - x[d]);
    const double speed = clipped(scale * (inertia * v[d] + pull), -fastest[d], fastest[d]);
    v[d] = speed;
    x[d] = clipped(x[d] + speed, low[d], high[d]);
  }
}

}  // namespace

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
    const std::size_t after = i + step < size() ? i + step : i + step - size();
    const std::size_t before = i >= step ? i - step : i + size() - step;
    for (const std::size_t other : {after, before}) {
      const bool better = best_costs_[other] < best_costs_[guide];
      if (better || (best_costs_[other] == best_costs_[guide] && other < guide)) guide = other;
    }
  }
  return guide;
}

// In blocks of coordinates: the draws of all particles side by side, then particle by particle.
void Swarm::move(std::size_t first, std::size_t count, const Momentum& momentum, const Stream& stream) {
  static_assert(abreast <= Draws::capacity);
  Draws draws;
  std::array<std::size_t, abreast> guides;
  for (std::size_t k = 0; k < count; ++k) draws.set(k, stream.fork(first + k));
  for (std::size_t k = 0; k < count; ++k) guides[k] = guide_of(first + k);
  std::array<std::array<std::uint64_t, block>, abreast> drawn;
  for (std::size_t begin = 0; begin < dimensions(); begin += block) {
    const std::size_t some = std::min(block, dimensions() - begin);
    for (std::size_t d = 0; d < some; ++d) {
      draws.advance(count);
      for (std::size_t k = 0; k < count; ++k) drawn[k][d] = draws.bits(k);
    }
    for (std::size_t k = 0; k < count; ++k) {
      step(first + k, guides[k], begin, {drawn[k].data(), some}, momentum);
    }
  }
}

// Coordinates from `begin` on, one draw each.
void Swarm::step(std::size_t i, std::size_t guide, std::size_t begin, std::span<const std::uint64_t> draws,
                 const Momentum& momentum) {
  const std::size_t from = i * dimensions() + begin;
  const Pulls pulls{settings_.c1, settings_.c2, bests_.data() + from,
                    bests_.data() + guide * dimensions() + begin, draws.data()};
  const Limits limits{box_.low.data() + begin, box_.high.data() + begin, box_.max_speed.data() + begin};
  follow(pulls, momentum, limits, draws.size(), velocities_.data() + from, positions_.data() + from);
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
