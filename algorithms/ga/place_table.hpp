// A place table: at which position does a cell stand in the chromosome at hand?
//
// One word per cell: the chromosome's tag above, the position below. A new chromosome is a new tag, so that
// nothing has to be wiped in between.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "algorithms/ga/gene_map.hpp"
#include "core/checkpoint.hpp"

namespace pathrace::algorithms {

class PlaceTable {
 public:
  static constexpr std::uint32_t nowhere = 0xFFFFFFFFU;

  explicit PlaceTable(std::size_t genes) : words_(filled_gradually<std::vector<std::uint64_t>>(genes, 0)) {}

  /// Forgets every cell.
  void clear() {
    if (++tag_ != 0) return;
    std::fill(words_.begin(), words_.end(), std::uint64_t{0});  // the tags are used up
    tag_ = 1;
  }
  void set(Gene gene, std::size_t position) {
    words_[gene] = std::uint64_t{tag_} << 32 | static_cast<std::uint32_t>(position);
  }
  void forget(Gene gene) { words_[gene] = 0; }
  std::uint32_t find(Gene gene) const {
    const std::uint64_t word = words_[gene];
    return word >> 32 == tag_ ? static_cast<std::uint32_t>(word) : nowhere;
  }

  /// Sets cells that have no place yet, for tight loops: a copy on the stack, which no store can be suspected
  /// to alter. Good until the table is cleared.
  class Marker {
   public:
    Marker(std::uint64_t* words, std::uint32_t tag) : words_(words), tag_(tag) {}
    /// False, and nothing is set, when the cell has a place.
    bool mark(Gene gene, std::size_t position) const {
      if (words_[gene] >> 32 == tag_) return false;
      words_[gene] = tag_ << 32 | static_cast<std::uint32_t>(position);
      return true;
    }

   private:
    std::uint64_t* words_;
    std::uint64_t tag_;
  };
  Marker marker() { return {words_.data(), tag_}; }

 private:
  std::vector<std::uint64_t> words_;
  std::uint32_t tag_ = 0;
};

}  // namespace pathrace::algorithms
