// Caves: random cells smoothed by a cellular automaton.
//
// A cell is blocked in the next round when at least five of the nine cells around and including it are; cells
// outside the map count as blocked. Start and goal lie far apart in the largest cave.
#include <cstdint>

#include "scenarios/generated.hpp"

namespace pathrace::scenarios {
namespace {

struct CaveSettings : Placement {
  int percent = 42;
  int rounds = 4;
};

// One byte per cell in a frame of ones, so that the nine cells need no bounds check.
class Automaton {
 public:
  Automaton(int n, double probability, Stream& stream)
      : n_(static_cast<std::size_t>(n)), stride_(n_ + 2), rock_(stride_ * stride_, 1), columns_(stride_) {
    for (std::size_t y = 1; y <= n_; ++y) {
      for (std::size_t x = 1; x <= n_; ++x) rock_[y * stride_ + x] = stream.chance(probability) ? 1 : 0;
    }
  }

  void smooth() {
    std::vector<std::uint8_t> next = rock_;
    for (std::size_t y = 1; y <= n_; ++y) {
      const std::size_t row = y * stride_;
      for (std::size_t x = 0; x < stride_; ++x) {
        columns_[x] = rock_[row - stride_ + x] + rock_[row + x] + rock_[row + stride_ + x];
      }
      for (std::size_t x = 1; x <= n_; ++x) {
        next[row + x] = columns_[x - 1] + columns_[x] + columns_[x + 1] >= 5 ? 1 : 0;
      }
    }
    rock_.swap(next);
  }

  bool is_rock(int x, int y) const {
    return rock_[static_cast<std::size_t>(y + 1) * stride_ + static_cast<std::size_t>(x + 1)] != 0;
  }

 private:
  std::size_t n_;
  std::size_t stride_;
  std::vector<std::uint8_t> rock_;
  std::vector<int> columns_;  // of three cells each
};

Sketch draw(const CaveSettings& settings, int n, Stream& stream) {
  Automaton automaton(n, settings.percent / 100.0, stream);
  for (int round = 0; round < settings.rounds; ++round) automaton.smooth();
  Sketch sketch{OccupancyGrid(n, n), {}, {}};
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      if (automaton.is_rock(x, y)) sketch.grid.block({x, y});
    }
  }
  return sketch;
}

}  // namespace

Family caves_family() {
  const GeneratedCard card{
      "caves", "caves of a cellular automaton, ends far apart", "percent", Ends::far, {"20-42", "64-42"}};
  return generated_family<CaveSettings>(
      card,
      {integer("percent", &CaveSettings::percent, 0, 50, "%", Source::ours,
               "chance of rock before smoothing"),
       integer("rounds", &CaveSettings::rounds, 0, 20, "", Source::ours, "rounds of smoothing")},
      draw);
}

}  // namespace pathrace::scenarios
