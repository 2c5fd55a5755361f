// Bands of a map, and the stretches of a path in them.
#include "algorithms/aco/bands.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/algorithms/trail_field.hpp"

namespace pathrace::algorithms {
namespace {

std::size_t band_of(const Bands& bands, std::size_t count, std::size_t cell) {
  std::size_t found = count;
  for (std::size_t band = 0; band < count; ++band) {
    if (!bands[band].contains(cell)) continue;
    EXPECT_EQ(found, count) << "two bands have cell " << cell;
    found = band;
  }
  EXPECT_LT(found, count) << "no band has cell " << cell;
  return found;
}

std::vector<Stretch> split_one_by_one(const Bands& bands, std::size_t count, const Field& field,
                                      std::size_t cell, const std::vector<std::uint8_t>& path) {
  std::vector<Stretch> stretches;
  std::size_t band = count;
  for (std::size_t k = 0; k <= path.size(); ++k) {
    const std::size_t next = band_of(bands, count, cell);
    if (next != band) stretches.push_back({static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(cell)});
    band = next;
    if (k < path.size()) cell = field.moves.step(cell, path[k]);
  }
  return stretches;
}

TEST(Bands, EveryCellIsInOneOfThemWhateverTheirNumber) {
  const Field field(std::vector<std::string>(9, "...."), MoveRule::free, 1, 1, equal);
  for (std::size_t count = 1; count <= 15; ++count) {
    const Bands bands(field.moves.size(), field.grid.stride(), count);
    for (std::size_t cell = 0; cell < field.moves.size(); ++cell) band_of(bands, count, cell);
  }
}

// Steps in random directions, so that a path turns back at any distance from a border; runs of one direction,
// so that it crosses several bands.
TEST(Bands, APathIsSplitWhereItComesToAnotherBand) {
  Stream stream(31);
  for (const int height : {1, 2, 7, 40, 90}) {
    const Field field(std::vector<std::string>(static_cast<std::size_t>(height), "....."), MoveRule::free, 1,
                      1, equal);
    for (const std::size_t count : {1U, 2U, 3U, 4U, 50U}) {
      const Bands bands(field.moves.size(), field.grid.stride(), count);
      std::vector<Stretch> stretches{{1, 2}};
      for (int k = 0; k < 200; ++k) {
        const std::size_t start = field.at(stream.between(0, 4), stream.between(0, height - 1));
        std::vector<std::uint8_t> path;
        std::size_t cell = start;
        int direction = 0;
        const auto length = static_cast<std::size_t>(stream.between(0, k % 2 == 0 ? 40 : 300));
        for (int tries = 0; tries < 3000 && path.size() < length; ++tries) {
          if (k % 3 == 0 || stream.between(0, 9) == 0) direction = stream.between(0, 7);
          if ((field.moves[cell] >> direction & 1) == 0) {
            direction = stream.between(0, 7);
            continue;
          }
          path.push_back(static_cast<std::uint8_t>(direction));
          cell = field.moves.step(cell, direction);
        }
        bands.split(start, path, stretches);
        ASSERT_EQ(stretches, split_one_by_one(bands, count, field, start, path))
            << height << " rows, " << count << " bands, walk " << k;
      }
    }
  }
}

}  // namespace
}  // namespace pathrace::algorithms
