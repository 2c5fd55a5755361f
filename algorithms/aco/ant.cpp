#include "algorithms/aco/ant.hpp"

#include <algorithm>
#include <bit>

namespace pathrace::algorithms {

Ant::Ant(const Ground& ground) : ground_(ground), tabu_(ground.moves.size(), 0) {
  if (ground.dead_end == DeadEnd::revisit_with_loop_erasure) place_.assign(ground.moves.size(), 0);
}

void Ant::begin() {
  for (const std::uint32_t cell : marked_) tabu_[cell] = 0;
  if (!place_.empty()) {
    for (const std::uint32_t cell : path_) place_[cell] = 0;
  }
  marked_.clear();
  path_.clear();
  steps_ = 0;
  arrived_ = false;
  enter(ground_.start);
}

void Ant::enter(std::size_t cell) {
  const auto index = static_cast<std::uint32_t>(cell);
  if (tabu_[cell] == 0) {
    tabu_[cell] = 1;
    marked_.push_back(index);
  }
  path_.push_back(index);
  if (!place_.empty()) place_[cell] = static_cast<std::uint32_t>(path_.size());
}

void Ant::back_up() {
  path_.pop_back();
}

void Ant::enter_or_erase(std::size_t cell) {
  const std::uint32_t place = place_[cell];
  if (place == 0) return enter(cell);
  while (path_.size() > place) {
    place_[path_.back()] = 0;
    path_.pop_back();
  }
}

template <typename Open>
int Ant::choose(std::size_t cell, Stream& stream, const Open& open) const {
  const float* weights = ground_.trail.weights(cell);
  const unsigned legal = ground_.moves[cell];
  std::array<float, direction_count> cumulative;
  unsigned candidates = 0;
  float total = 0;
  for (int d = 0; d < direction_count; ++d) {
    const bool is_open = (legal >> d & 1U) != 0 && open(ground_.moves.step(cell, d));
    candidates |= static_cast<unsigned>(is_open) << d;
    total += is_open ? weights[d] : 0.0F;
    cumulative[static_cast<std::size_t>(d)] = total;
  }
  if (candidates == 0) return -1;
  const float u = stream.uniform_float();
  if (!(total > 0)) {  // every weight has underflown: no preference is left
    auto skip = static_cast<int>(u * static_cast<float>(std::popcount(candidates)));
    for (; skip > 0; --skip) candidates &= candidates - 1;
    return std::countr_zero(candidates);
  }
  const float pick = u * total;
  int chosen = 0;
  for (const float sum : cumulative) chosen += sum <= pick ? 1 : 0;
  if (chosen < direction_count) return chosen;
  int last = direction_count - 1;  // u * total rounded up to the total: the last positive weight wins
  while ((candidates >> last & 1U) == 0 || weights[last] <= 0) --last;
  return last;
}

void Ant::walk(Stream stream, std::uint64_t step_limit, const Meter& meter) {
  begin();
  const std::uint64_t limit = std::min(step_limit, ground_.max_steps);
  while (path_.back() != ground_.goal) {
    if (steps_ == limit) return;
    if (++steps_ % clock_interval == 0 && meter.out_of_time()) return;
    const std::size_t cell = path_.back();
    const int fresh = choose(cell, stream, [this](std::size_t next) { return tabu_[next] == 0; });
    if (fresh >= 0) {
      enter(ground_.moves.step(cell, fresh));
      continue;
    }
    if (ground_.dead_end == DeadEnd::die) return;
    if (ground_.dead_end == DeadEnd::backtrack) {
      if (path_.size() == 1) return;  // all that can be reached has been seen
      back_up();
      continue;
    }
    const int any = choose(cell, stream, [](std::size_t) { return true; });
    if (any < 0) return;
    enter_or_erase(ground_.moves.step(cell, any));
  }
  arrived_ = true;
}

int Ant::direction(std::size_t i) const {
  const std::ptrdiff_t difference =
      static_cast<std::ptrdiff_t>(path_[i + 1]) - static_cast<std::ptrdiff_t>(path_[i]);
  int d = 0;
  while (ground_.moves.offset(d) != difference) ++d;
  return d;
}

LatticeLength Ant::length() const {
  LatticeLength length;
  for (std::size_t i = 0; i + 1 < path_.size(); ++i) {
    (is_diagonal(direction(i)) ? length.diagonal : length.straight) += 1;
  }
  return length;
}

}  // namespace pathrace::algorithms
