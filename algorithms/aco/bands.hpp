// A map in bands: neighbouring rows of cells, as many bands as threads that share the map.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pathrace::algorithms {

/// Padded indices begin..end-1.
struct CellRange {
  std::size_t begin = 0;
  std::size_t end = 0;

  bool contains(std::size_t index) const { return index - begin < end - begin; }
};

/// A part of a path on cells of one band, from where it comes there to where it leaves, with the step that
/// does so, or ends; perhaps in the cell where it comes.
struct Stretch {
  std::uint32_t first = 0;  ///< the number of its first step
  std::uint32_t cell = 0;   ///< its first, a padded index

  friend bool operator==(const Stretch&, const Stretch&) = default;
};

class Bands {
 public:
  /// `count` bands for a padded map of so many cells, `stride` in a row; the last bands may be empty.
  Bands(std::size_t cells, std::size_t stride, std::size_t count);

  CellRange operator[](std::size_t band) const;

  /// The stretches of a path from `start` on, in its order.
  void split(std::size_t start, std::span<const std::uint8_t> path, std::vector<Stretch>& stretches) const;

 private:
  std::size_t cells_;  // of the map
  std::ptrdiff_t stride_;
  std::ptrdiff_t rows_;  // of a band
  std::ptrdiff_t last_;  // band that is not empty
};

}  // namespace pathrace::algorithms
