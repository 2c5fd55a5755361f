#include "baselines/grid/canonical_moves.hpp"

#include <cstdlib>
#include <optional>

#include "core/checkpoint.hpp"
#include "core/lattice_length.hpp"

namespace pathrace::baselines {
namespace {

// The nine cells around n = (0, 0), n itself free.
class Surroundings {
 public:
  Surroundings(MoveRule rule, unsigned neighbours) : rule_(rule) {
    is_free_[1][1] = true;
    for (std::size_t d = 0; d < directions.size(); ++d) {
      is_free_[directions[d].y + 1][directions[d].x + 1] = (neighbours >> d & 1U) != 0;
    }
  }

  bool is_free(Cell cell) const { return is_free_[cell.y + 1][cell.x + 1]; }

  /// Length of the step between two of the nine cells, when it is one and legal.
  std::optional<LatticeLength> step(Cell from, Cell to) const {
    const int dx = std::abs(to.x - from.x);
    const int dy = std::abs(to.y - from.y);
    if (dx > 1 || dy > 1 || dx + dy == 0 || !is_free(from) || !is_free(to)) return std::nullopt;
    if (dx + dy == 1) return LatticeLength{1, 0};
    const int free_sides = (is_free({to.x, from.y}) ? 1 : 0) + (is_free({from.x, to.y}) ? 1 : 0);
    static constexpr int needed[] = {3, 2, 1, 0};  // four, strict, squeeze, free
    if (free_sides < needed[static_cast<std::size_t>(rule_)]) return std::nullopt;
    return LatticeLength{0, 1};
  }

  /// Is there a way of at most two steps that avoids n and is shorter than `length`, or as long when
  /// `ties_count`? Three steps are longer than any two.
  bool way_around(Cell from, Cell to, LatticeLength length, bool ties_count) const {
    const auto wins = [&](LatticeLength other) { return ties_count ? other <= length : other < length; };
    const std::optional<LatticeLength> direct = step(from, to);
    if (direct && wins(*direct)) return true;
    for (const Cell middle : directions) {
      const std::optional<LatticeLength> first = step(from, middle);
      const std::optional<LatticeLength> second = step(middle, to);
      if (first && second && wins(*first + *second)) return true;
    }
    return false;
  }

 private:
  MoveRule rule_;
  bool is_free_[3][3] = {};  // [y + 1][x + 1]
};

bool yields_ties(MoveRule rule, int arrival) {
  return rule == MoveRule::four ? directions[static_cast<std::size_t>(arrival)].y != 0
                                : !is_diagonal(arrival);
}

unsigned remaining(const Surroundings& around, unsigned legal, MoveRule rule, int arrival) {
  constexpr Cell n{0, 0};
  const Cell parent = directions[static_cast<std::size_t>(opposite(arrival))];
  const std::optional<LatticeLength> arrived = around.step(parent, n);
  if (!arrived) return 0;  // nobody arrives this way
  unsigned mask = 0;
  for (int d = 0; d < direction_count; ++d) {
    if ((legal >> d & 1U) == 0 || d == opposite(arrival)) continue;
    const Cell to = directions[static_cast<std::size_t>(d)];
    const LatticeLength through = *arrived + *around.step(n, to);
    if (!around.way_around(parent, to, through, yields_ties(rule, arrival))) mask |= 1U << d;
  }
  return mask;
}

}  // namespace

CanonicalMoves::CanonicalMoves(MoveRule rule) {
  for (unsigned neighbours = 0; neighbours < 256; ++neighbours) {
    const Surroundings around(rule, neighbours);
    unsigned legal = 0;
    for (int d = 0; d < direction_count; ++d) {
      if (around.step({0, 0}, directions[static_cast<std::size_t>(d)])) legal |= 1U << d;
    }
    legal_[neighbours] = static_cast<std::uint8_t>(legal);
    for (int arrival = 0; arrival < direction_count; ++arrival) {
      after_[static_cast<std::size_t>(arrival)][neighbours] =
          static_cast<std::uint8_t>(remaining(around, legal, rule, arrival));
    }
  }
}

const CanonicalMoves& CanonicalMoves::of(MoveRule rule) {
  static const std::array<CanonicalMoves, 4> tables = {
      CanonicalMoves(MoveRule::four), CanonicalMoves(MoveRule::strict), CanonicalMoves(MoveRule::squeeze),
      CanonicalMoves(MoveRule::free)};
  return tables[static_cast<std::size_t>(rule)];
}

std::vector<std::uint8_t> free_neighbours(const OccupancyGrid& grid) {
  using Bytes = std::vector<std::uint8_t>;
  const std::size_t stride = grid.stride();
  Bytes is_free = filled_gradually<Bytes>(grid.padded_size(), 0);
  for (std::size_t first = 0; first < is_free.size(); first += stride) {
    checkpoint();
    for (std::size_t i = first; i < first + stride; ++i) is_free[i] = grid.blocked_at(i) ? 0 : 1;
  }
  Bytes neighbours = filled_gradually<Bytes>(grid.padded_size(), 0);
  const std::ptrdiff_t width = grid.width();
  for (int y = 0; y < grid.height(); ++y) {
    checkpoint();
    const std::size_t row = grid.index({0, y});
    const std::uint8_t* const above = is_free.data() + (row - stride);
    const std::uint8_t* const here = is_free.data() + row;
    const std::uint8_t* const below = is_free.data() + (row + stride);
    std::uint8_t* const out = neighbours.data() + row;
    for (std::ptrdiff_t x = 0; x < width; ++x) {
      out[x] =
          static_cast<std::uint8_t>(here[x + 1] | below[x + 1] << 1 | below[x] << 2 | below[x - 1] << 3 |
                                    here[x - 1] << 4 | above[x - 1] << 5 | above[x] << 6 | above[x + 1] << 7);
    }
  }
  return neighbours;
}

}  // namespace pathrace::baselines
