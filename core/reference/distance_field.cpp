#include "core/reference/distance_field.hpp"

#include <limits>
#include <numbers>

#include "core/checkpoint.hpp"

namespace pathrace::reference {
namespace {

std::size_t bucket_of(std::int64_t straight, std::int64_t diagonal) {
  return static_cast<std::size_t>(whole_part({straight, diagonal}));
}

}  // namespace

// The double is off by one at most, and then 2 d^2 tells.
std::int64_t whole_part(LatticeLength length) {
  const std::int64_t square = 2 * length.diagonal * length.diagonal;
  auto whole = static_cast<std::int64_t>(static_cast<double>(length.diagonal) * std::numbers::sqrt2);
  if (whole * whole > square) --whole;
  if ((whole + 1) * (whole + 1) <= square) ++whole;
  return length.straight + whole;
}

DistanceField::DistanceField(const Terrain& terrain, Cell source, std::optional<Cell> target)
    : grid_(*terrain.grid),
      rule_(terrain.rule),
      best_(filled_gradually<std::vector<Count>>(grid_.padded_size(), Count{})),
      settled_(filled_gradually<std::vector<std::uint8_t>>(grid_.padded_size(), 0)) {
  order_.reserve(grid_.padded_size());
  search(grid_.index(source), target ? grid_.index(*target) : std::numeric_limits<std::size_t>::max());
}

void DistanceField::reach(std::size_t index, Count count) {
  Count& known = best_[index];
  const bool shorter = known.straight < 0 || LatticeLength{count.straight, count.diagonal} <
                                                 LatticeLength{known.straight, known.diagonal};
  if (!shorter) return;
  known = count;
  buckets_[bucket_of(count.straight, count.diagonal) % bucket_count].push_back(
      static_cast<std::uint32_t>(index));
}

void DistanceField::settle(std::size_t index) {
  settled_[index] = 1;
  order_.push_back(static_cast<std::uint32_t>(index));
  const Count here = best_[index];
  for_each_step(index, [&](std::size_t next, bool diagonal) {
    if (settled_[next] != 0) return;
    reach(next, {here.straight + (diagonal ? 0 : 1), here.diagonal + (diagonal ? 1 : 0)});
  });
}

void DistanceField::search(std::size_t source, std::size_t target) {
  reach(source, {0, 0});
  std::size_t idle = 0;
  for (std::size_t lowest = 0; idle < bucket_count; ++lowest) {
    checkpoint();
    std::vector<std::uint32_t>& bucket = buckets_[lowest % bucket_count];
    idle = bucket.empty() ? idle + 1 : 0;
    for (const std::uint32_t index : bucket) {  // every step leads to another bucket
      if (settled_[index] != 0) continue;       // reached again on a shorter way
      settle(index);
      if (index == target) return;
    }
    bucket.clear();
  }
}

}  // namespace pathrace::reference
