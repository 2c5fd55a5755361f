#include "core/meter.hpp"

#include <algorithm>

#include "core/checkpoint.hpp"

namespace pathrace {

Meter::Meter(const Budget& budget) : budget_(budget), begin_(std::chrono::steady_clock::now()) {}

bool Meter::spent() const {
  return evaluations_left() == 0 || checks_left() == 0 ||
         left(budget_.iterations, iterations_.value()) == 0 || timed();
}

bool Meter::exhausted() const {
  return spent() || out_of_time();
}

bool Meter::out_of_time() const {
  if (stop_requested.load(std::memory_order_relaxed)) {
    interrupted_.store(true, std::memory_order_relaxed);
    return true;
  }
  if (!budget_.wall_s) return false;
  if (timed()) return true;
  if (elapsed_s() < *budget_.wall_s) return false;
  timed_.store(true, std::memory_order_relaxed);
  return true;
}

bool Meter::exceeded() const {
  const auto above = [](const std::optional<std::uint64_t>& limit, std::uint64_t count) {
    return limit && count > *limit;
  };
  const Work spent = work();
  return above(budget_.evaluations, spent.evaluations) || above(budget_.iterations, spent.iterations) ||
         above(budget_.checks, spent.checks);
}

std::size_t Meter::admitted(std::size_t wanted) const {
  return static_cast<std::size_t>(std::min<std::uint64_t>(wanted, evaluations_left()));
}

void Meter::improved(double cost) {
  if (!(cost < best_cost())) return;
  trace_.push_back({work(), elapsed_s(), cost});
  best_cost_.store(cost, std::memory_order_relaxed);
}

void Meter::count(std::string_view name, std::uint64_t amount) {
  for (Counter& counter : counters_) {
    if (counter.name != name) continue;
    counter.value += amount;
    return;
  }
  counters_.push_back({std::string(name), amount});
}

double Meter::elapsed_s() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

}  // namespace pathrace
