// The swarm: particles that remember their best place and follow the best of the others.
//
//   v := w v + c1 r1 (pbest - x) + c2 r2 (gbest - x)     (1)   r1, r2 uniform, fresh per coordinate
//   x := x + v                                           (2)
//   v within +-v_max, x within its box; clipped, velocity kept   (3)
//
// J. Kennedy, R. Eberhart, "Particle swarm optimization", Proc. ICNN 1995; as Algorithm 1 of Nasrollahy and
// Javadi, EMS 2009. Positions, velocities and bests are an array each, one row of coordinates per particle.
//
// An iteration has two halves. First every particle moves and is judged, in any order: particle i reads the
// bests of the iteration before and writes its own row and cost. Then `learn` compares in index order:
// strictly better only, so that of equals the lowest index and the oldest memory stay.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "algorithms/pso/swarm_settings.hpp"
#include "core/executor.hpp"
#include "core/stream.hpp"

namespace pathrace::algorithms {

/// Where particles may be and how fast they may move, per coordinate. All of one length.
struct SwarmBox {
  std::vector<double> low;
  std::vector<double> high;
  std::vector<double> max_speed;
};

class Swarm {
 public:
  static constexpr std::size_t abreast = 8;  ///< particles that move side by side

  Swarm(const SwarmSettings& settings, SwarmBox box);

  std::size_t size() const { return costs_.size(); }
  std::size_t dimensions() const { return box_.low.size(); }
  const SwarmBox& box() const { return box_; }

  std::span<double> position(std::size_t i) { return {positions_.data() + i * dimensions(), dimensions()}; }
  std::span<const double> position(std::size_t i) const { return row(positions_, i); }
  /// Positions of particles first..first + count - 1, one behind the other.
  std::span<const double> positions(std::size_t first, std::size_t count) const {
    return {positions_.data() + first * dimensions(), count * dimensions()};
  }
  std::span<double> velocity(std::size_t i) { return {velocities_.data() + i * dimensions(), dimensions()}; }
  /// Cost of where the particle is now. Not a number counts as infinite.
  void judge(std::size_t i, double cost) { costs_[i] = cost < infinite ? cost : infinite; }
  double cost(std::size_t i) const { return costs_[i]; }

  /// Forgets every best; positions and velocities are the caller's to fill.
  void forget();
  /// Equations (1) to (3) for particles first..first + count - 1, count <= abreast; particle i draws from
  /// stream.fork(i). Safe for different particles at once.
  void move(std::size_t first, std::size_t count, const Momentum& momentum, const Stream& stream);
  /// Takes the costs of particles 0..count-1 into account. True when the best of the swarm has changed.
  bool learn(std::size_t count);

  /// Infinite until something with a finite cost was learnt.
  double best_cost() const { return best_costs_[leader_]; }
  std::span<const double> best_position() const { return row(bests_, leader_); }
  double best_cost(std::size_t i) const { return best_costs_[i]; }
  std::span<const double> best_position(std::size_t i) const { return row(bests_, i); }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  std::span<const double> row(const std::vector<double>& rows, std::size_t i) const {
    return {rows.data() + i * dimensions(), dimensions()};
  }
  std::size_t guide_of(std::size_t i) const;
  void step(std::size_t i, std::size_t guide, std::size_t begin, std::span<const std::uint64_t> draws,
            const Momentum& momentum);

  SwarmSettings settings_;
  SwarmBox box_;
  std::vector<double> positions_;
  std::vector<double> velocities_;
  std::vector<double> bests_;
  std::vector<double> costs_;
  std::vector<double> best_costs_;
  std::size_t leader_ = 0;
};

/// Calls `body(first, count)` for particles 0..total-1, count <= Swarm::abreast of them at a time, on all
/// threads.
template <typename Body>
void for_each_abreast(Executor& executor, std::size_t total, const Body& body) {
  const std::size_t groups = (total + Swarm::abreast - 1) / Swarm::abreast;
  const auto threads = static_cast<std::size_t>(executor.threads());
  for_each_index(executor, groups, (groups + threads - 1) / threads, [&](std::size_t group) {
    const std::size_t first = group * Swarm::abreast;
    body(first, std::min(Swarm::abreast, total - first));
  });
}

}  // namespace pathrace::algorithms
