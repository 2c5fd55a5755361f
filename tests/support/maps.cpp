#include "tests/support/maps.hpp"

#include <stdexcept>
#include <utility>

#include "scenarios/library.hpp"

namespace pathrace::testing {
namespace {

template <typename Place>
OccupancyGrid rearranged(const OccupancyGrid& grid, int width, int height, Place place) {
  OccupancyGrid result(width, height);
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (!grid.is_free({x, y})) result.block(place(Cell{x, y}));
    }
  }
  return result;
}

}  // namespace

OccupancyGrid grid_of(const std::vector<std::string>& rows) {
  if (rows.empty()) throw std::invalid_argument("a drawn map needs a row");
  OccupancyGrid grid(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (std::size_t y = 0; y < rows.size(); ++y) {
    if (rows[y].size() != rows[0].size()) throw std::invalid_argument("row of another length: " + rows[y]);
    for (std::size_t x = 0; x < rows[y].size(); ++x) {
      const char drawn = rows[y][x];
      if (std::string("#1.0").find(drawn) == std::string::npos) throw std::invalid_argument("row " + rows[y]);
      if (drawn == '#' || drawn == '1') grid.block({static_cast<int>(x), static_cast<int>(y)});
    }
  }
  return grid;
}

Terrain terrain_of(const OccupancyGrid& grid, MoveRule rule) {
  return {std::make_shared<const OccupancyGrid>(grid), rule};
}

OccupancyGrid random_grid(Stream stream, int width, int height, double density) {
  OccupancyGrid grid(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (stream.chance(density)) grid.block({x, y});
    }
  }
  return grid;
}

std::vector<Cell> free_cells_of(const OccupancyGrid& grid) {
  std::vector<Cell> cells;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (grid.is_free({x, y})) cells.push_back({x, y});
    }
  }
  return cells;
}

Question random_question(Stream stream, int max_side, double max_density) {
  const int width = stream.between(1, max_side);
  const int height = stream.between(1, max_side);
  OccupancyGrid grid = random_grid(stream.fork(0), width, height, stream.uniform() * max_density);
  grid.clear({stream.between(0, width - 1), stream.between(0, height - 1)});
  const std::vector<Cell> cells = free_cells_of(grid);
  const Cell start = cells[stream.below(cells.size())];
  const Cell goal = cells[stream.below(cells.size())];
  return {std::move(grid), start, goal};
}

Cell mirrored(const OccupancyGrid& grid, Cell cell) {
  return {grid.width() - 1 - cell.x, cell.y};
}

Cell transposed(Cell cell) {
  return {cell.y, cell.x};
}

Question mirrored(const Question& question) {
  const auto place = [&](Cell cell) { return mirrored(question.grid, cell); };
  return {rearranged(question.grid, question.grid.width(), question.grid.height(), place),
          place(question.start), place(question.goal)};
}

Question transposed(const Question& question) {
  return {rearranged(question.grid, question.grid.height(), question.grid.width(),
                     [](Cell cell) { return transposed(cell); }),
          transposed(question.start), transposed(question.goal)};
}

LatticeLength ReferenceMap::optimum(MoveRule rule) const {
  switch (rule) {
    case MoveRule::four: return four;
    case MoveRule::strict: return strict;
    case MoveRule::squeeze: return squeeze;
    case MoveRule::free: break;
  }
  return free;
}

namespace {

std::vector<std::string> rows_of(const OccupancyGrid& grid) {
  std::vector<std::string> rows;
  for (int y = 0; y < grid.height(); ++y) {
    std::string& row = rows.emplace_back();
    for (int x = 0; x < grid.width(); ++x) row += grid.is_free({x, y}) ? '.' : '#';
  }
  return rows;
}

ReferenceMap stated(const std::string& id, Cell start, Cell goal, LatticeLength free, LatticeLength squeeze,
                    LatticeLength strict, LatticeLength four) {
  return {id, start, goal, free, squeeze, strict, four, rows_of(scenarios::Library().load(id).grid())};
}

}  // namespace

// Start, goal; straight and diagonal steps of the optimum under free, squeeze, strict and four
// (algorithms.md 6).
const std::vector<ReferenceMap>& reference_maps() {
  static const std::vector<ReferenceMap> maps = {
      stated("asr/fig2", {0, 0}, {4, 4}, {0, 4}, {0, 4}, {4, 2}, {8, 0}),
      stated("asr/fig5", {0, 0}, {4, 4}, {0, 4}, {0, 4}, {2, 3}, {8, 0}),
      stated("asr/fig6", {0, 0}, {4, 4}, {0, 4}, {0, 4}, {4, 2}, {8, 0}),
      stated("curated/trap-l-20", {0, 0}, {19, 19}, {20, 9}, {20, 9}, {22, 8}, {38, 0}),
      stated("curated/trap-u-east-20", {9, 9}, {19, 9}, {10, 10}, {10, 10}, {16, 7}, {30, 0}),
      stated("curated/trap-hook-20", {0, 0}, {19, 19}, {24, 7}, {24, 7}, {26, 6}, {38, 0}),
      stated("curated/trap-nested-l-20", {0, 0}, {19, 19}, {28, 5}, {28, 5}, {30, 4}, {38, 0}),
      stated("curated/trap-baffle-20", {0, 0}, {19, 19}, {68, 19}, {68, 19}, {84, 11}, {106, 0}),
      stated("curated/trap-comb-20", {0, 0}, {19, 19}, {22, 8}, {22, 8}, {24, 7}, {38, 0}),
      stated("curated/trap-tunnel-20", {0, 0}, {19, 19}, {16, 11}, {16, 11}, {18, 10}, {38, 0}),
      stated("curated/trap-spiral-20", {0, 0}, {11, 11}, {34, 10}, {34, 10}, {46, 4}, {54, 0}),
      stated("curated/trap-pocket-10", {0, 9}, {9, 0}, {4, 7}, {4, 7}, {6, 6}, {18, 0}),
  };
  return maps;
}

}  // namespace pathrace::testing
