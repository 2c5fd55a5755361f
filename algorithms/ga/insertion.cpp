#include "algorithms/ga/insertion.hpp"

#include <algorithm>
#include <bit>

namespace pathrace::algorithms {
namespace {

constexpr unsigned lower_right = 0b111;  // E, SE, S

constexpr int sign(int value) {
  return (value > 0) - (value < 0);
}

// Row by row, from up and left to down and right.
constexpr std::array<int, 9> direction_by_signs = {5, 6, 7, 4, -1, 0, 3, 2, 1};

constexpr unsigned bit(int direction) {
  return 1U << (direction & 7);
}

// The direction whose step ends nearest to `there`; ties at random. `directions` is not empty.
int nearest(const GeneMap& map, Gene from, unsigned directions, Cell there, Stream& stream) {
  int best = std::countr_zero(directions);
  if (std::has_single_bit(directions)) return best;
  std::int64_t least = -1;
  std::uint64_t equals = 0;
  for (; directions != 0; directions &= directions - 1) {
    const int d = std::countr_zero(directions);
    const Cell cell = map.cell(map.step(from, d));
    const std::int64_t dx = cell.x - there.x;
    const std::int64_t dy = cell.y - there.y;
    const std::int64_t distance = dx * dx + dy * dy;
    if (least >= 0 && distance > least) continue;
    equals = distance == least ? equals + 1 : 1;
    if (equals == 1 || stream.below(equals) == 0) best = d;
    least = distance;
  }
  return best;
}

}  // namespace

Fan fan_towards(Insertion rule, Cell from, Cell to) {
  const int dx = sign(to.x - from.x);
  const int dy = sign(to.y - from.y);
  const int signs = 3 * (dy + 1) + dx + 1;
  const int middle = direction_by_signs[static_cast<std::size_t>(signs)];
  if (rule == Insertion::general) {
    return {bit(middle) | bit(middle + 1) | bit(middle - 1), middle};
  }
  if (dx < 0 || dy < 0) return {};
  if (rule == Insertion::blind || (dx > 0 && dy > 0)) return {lower_right, 1};
  return {bit(middle), middle};
}

Inserter::Inserter(const GeneMap& map, Insertion rule, GapRepair repair, std::size_t reach)
    : map_(map), rule_(rule), repair_(repair), detour_(map, repair == GapRepair::none ? 0 : reach) {}

Inserter::Outcome Inserter::fill(std::span<const Gene> genes, std::uint64_t limit, const Meter& clock,
                                 Stream& stream, LoopFreePath& path) {
  limit_ = limit;
  checks_ = 0;
  detours_ = 0;
  std::uint64_t next_look = clock_interval;
  path.append(genes.front());
  for (std::size_t k = 1; k < genes.size(); ++k) {
    const std::uint64_t left = std::min<std::uint64_t>(genes.size() - k, limit_ - checks_);
    const std::size_t followed = path.follow(map_, genes.subspan(k, static_cast<std::size_t>(left)));
    checks_ += followed;
    k += followed;
    if (k == genes.size()) break;
    const Way way = walk(genes[k], stream, path);
    if (way == Way::cut) return Outcome::cut;
    if (way == Way::failed) return Outcome::deleted;
    if (checks_ < next_look) continue;
    if (clock.out_of_time()) return Outcome::cut;
    next_look = checks_ + clock_interval;
  }
  return path.back() == genes.back() ? Outcome::filled : Outcome::deleted;
}

Inserter::Way Inserter::walk(Gene target, Stream& stream, LoopFreePath& path) {
  const Cell there = map_.cell(target);
  while (path.back() != target) {
    if (checks_ == limit_) return Way::cut;
    ++checks_;
    const Gene from = path.back();
    if (map_.linked(from, target)) return path.append(target) ? Way::arrived : Way::failed;
    const Fan fan = fan_towards(rule_, map_.cell(from), there);
    if (fan.directions == 0) return Way::out_of_reach;
    const unsigned legal = map_.legal(from) & fan.directions;
    if (legal == 0) {
      const Way way = blocked(from, target, stream, path);
      if (way != Way::arrived) return way;
      continue;
    }
    const int d = legal == fan.directions ? fan.middle : nearest(map_, from, legal, there, stream);
    if (!path.append(map_.step(from, d))) return Way::failed;
  }
  return Way::arrived;
}

// `arrived`: on the far side of what is in the way.
Inserter::Way Inserter::blocked(Gene from, Gene target, Stream& stream, LoopFreePath& path) {
  if (rule_ != Insertion::general) {
    return (map_.legal(from) & lower_right) == 0 ? Way::failed : Way::out_of_reach;
  }
  if (repair_ == GapRepair::none) return Way::failed;
  ++detours_;
  const std::vector<Gene>& way = detour_.search(from, target, limit_ - checks_, stream);
  checks_ += detour_.expanded();
  for (const Gene gene : way) {
    if (!path.append(gene)) return Way::failed;
  }
  if (!way.empty()) return Way::arrived;
  return checks_ == limit_ ? Way::cut : Way::out_of_reach;
}

}  // namespace pathrace::algorithms
