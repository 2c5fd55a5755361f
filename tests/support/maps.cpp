#include "tests/support/maps.hpp"

#include <stdexcept>
#include <utility>

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

// Name, start, goal; straight and diagonal steps of the optimum under free, squeeze, strict and four.
const std::vector<ReferenceMap>& reference_maps() {
  // clang-format off
  static const std::vector<ReferenceMap> maps = {
      {"asr_fig2_5", {0, 0}, {4, 4}, {0, 4}, {0, 4}, {4, 2}, {8, 0}, {
           "00001",
           "00100",
           "00000",
           "00100",
           "10000"
      }},
      {"asr_fig5_5", {0, 0}, {4, 4}, {0, 4}, {0, 4}, {2, 3}, {8, 0}, {
           "00000",
           "00010",
           "01000",
           "00000",
           "00000"
      }},
      {"asr_fig6_5", {0, 0}, {4, 4}, {0, 4}, {0, 4}, {4, 2}, {8, 0}, {
           "00000",
           "00100",
           "00000",
           "00100",
           "00000"
      }},
      {"trap_L_20", {0, 0}, {19, 19}, {20, 9}, {20, 9}, {22, 8}, {38, 0}, {
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000100000",
           "00000000000000100000",
           "00000000000000100000",
           "00000000000000100000",
           "00000000000000100000",
           "00000000000000100000",
           "00000000000000100000",
           "00000000000000100000",
           "00000000000000100000",
           "00000111111111100000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000"
      }},
      {"trap_U_east_20", {9, 9}, {19, 9}, {10, 10}, {10, 10}, {16, 7}, {30, 0}, {
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000111111111100000",
           "00000000000000100000",
           "00000000000000100000",
           "00000000000000100000",
           "00000000000000100000",
           "00000000000000100000",
           "00000000000000100000",
           "00000000000000100000",
           "00000000000000100000",
           "00000111111111100000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000"
      }},
      {"trap_hook_20", {0, 0}, {19, 19}, {24, 7}, {24, 7}, {26, 6}, {38, 0}, {
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000111110000",
           "00000000000000010000",
           "00000000000000010000",
           "00000000000000010000",
           "00000000000000010000",
           "00000000000000010000",
           "00000000000000010000",
           "00001000000000010000",
           "00001000000000010000",
           "00001000000000010000",
           "00001000000000010000",
           "00001111111111110000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000"
      }},
      {"trap_nestedL_20", {0, 0}, {19, 19}, {28, 5}, {28, 5}, {30, 4}, {38, 0}, {
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000001000",
           "00000000000000001000",
           "00000000000000001000",
           "00000000000001001000",
           "00000000000001001000",
           "00000000000001001000",
           "00000000000001001000",
           "00000000000001001000",
           "00000000000001001000",
           "00000000000001001000",
           "00000011111111001000",
           "00000000000000001000",
           "00000000000000001000",
           "00011111111111111000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000"
      }},
      {"trap_baffle_20", {0, 0}, {19, 19}, {68, 19}, {68, 19}, {84, 11}, {106, 0}, {
           "00010000000100000000",
           "00010000000100000000",
           "00010001000100010000",
           "00010001000100010000",
           "00010001000100010000",
           "00010001000100010000",
           "00010001000100010000",
           "00010001000100010000",
           "00010001000100010000",
           "00010001000100010000",
           "00010001000100010000",
           "00010001000100010000",
           "00010001000100010000",
           "00010001000100010000",
           "00010001000100010000",
           "00010001000100010000",
           "00010001000100010000",
           "00010001000100010000",
           "00000001000000010000",
           "00000001000000010000"
      }},
      {"trap_comb_20", {0, 0}, {19, 19}, {22, 8}, {22, 8}, {24, 7}, {38, 0}, {
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00001000100010001000",
           "00001000100010001000",
           "00001000100010001000",
           "00001000100010001000",
           "00001000100010001000",
           "00001000100010001000",
           "00001000100010001000",
           "00001000100010001000",
           "00001000100010001000",
           "00001000100010001000",
           "00001000100010001000",
           "00001000100010001000",
           "00001000100010001000",
           "00001111111111111000"
      }},
      {"trap_tunnel_20", {0, 0}, {19, 19}, {16, 11}, {16, 11}, {18, 10}, {38, 0}, {
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "11101111111111111111",
           "11101111111111111111",
           "11101111111111111111",
           "11101111111111111111",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000",
           "00000000000000000000"
      }},
      {"trap_spiral_20", {0, 0}, {11, 11}, {34, 10}, {34, 10}, {46, 4}, {54, 0}, {
           "00000000000000000000",
           "00000000000000000000",
           "00111111111111111100",
           "00000000000000000100",
           "00000000000000000100",
           "00000111111111100100",
           "00000100000000100100",
           "00000100000000100100",
           "00000100100000100100",
           "00000100100000100100",
           "00000100100000100100",
           "00000100100000100100",
           "00000100100000100100",
           "00000100100000100100",
           "00000100111111100100",
           "00000100000000000100",
           "00000100000000000100",
           "00000111111111111100",
           "00000000000000000000",
           "00000000000000000000"
      }},
      {"trap_pocket_10", {0, 9}, {9, 0}, {4, 7}, {4, 7}, {6, 6}, {18, 0}, {
           "0000000000",
           "0000000000",
           "0011001000",
           "0011001000",
           "0000001000",
           "0111000000",
           "0000000000",
           "0000010100",
           "0000010100",
           "0000000100"
      }},
  };
  // clang-format on
  return maps;
}

}  // namespace pathrace::testing
