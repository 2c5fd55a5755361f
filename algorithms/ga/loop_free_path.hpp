// The deletion operator: of two equal genes, everything between them and one of them goes.
//
// Loops are cut while the chromosome is written: a cell that stands there already takes the writer back to
// it. That is the operator repeated until nothing is left to cut, the earliest loop first and the longest
// of those that begin there (G. Lawler, "Intersections of Random Walks", 1991: loop erasure in time order
// and by last visits give the same path).
//
// Xie, Yu, "Research of AS-R mobile robot path planning based on genetic algorithms", 2010, section 2.4.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "algorithms/ga/place_table.hpp"

namespace pathrace::algorithms {

class LoopFreePath {
 public:
  /// The table outlives the path and serves nobody else while the path is written.
  explicit LoopFreePath(PlaceTable& places) : places_(places) {}

  /// Starts anew in this memory.
  void open(std::span<Gene> slot) {
    slot_ = slot;
    size_ = 0;
    places_.clear();
  }
  /// False when the slot is full.
  bool append(Gene gene) {
    const std::uint32_t place = places_.find(gene);
    if (place != PlaceTable::nowhere) {
      while (size_ > place + 1) places_.forget(slot_[--size_]);
      return true;
    }
    if (size_ == slot_.size()) return false;
    places_.set(gene, size_);
    slot_[size_++] = gene;
    return true;
  }

  /// Appends genes from the front for as long as each is a legal step from the one before, new to the path
  /// and finds room: most of a chromosome, most of the time. Returns how many. The path is not empty.
  std::size_t follow(const GeneMap& map, std::span<const Gene> genes) {
    const PlaceTable::Marker marker = places_.marker();
    const std::size_t most = std::min(genes.size(), slot_.size() - size_);
    const std::size_t size = size_;
    Gene* const end = slot_.data() + size;
    Gene last = back();
    std::size_t count = 0;
    while (count < most && map.linked(last, genes[count]) && marker.mark(genes[count], size + count)) {
      last = genes[count];
      end[count++] = last;
    }
    size_ = size + count;
    return count;
  }

  std::size_t size() const { return size_; }
  /// Of a path that is not empty.
  Gene back() const { return slot_[size_ - 1]; }
  std::span<const Gene> genes() const { return slot_.first(size_); }

 private:
  PlaceTable& places_;
  std::span<Gene> slot_;
  std::size_t size_ = 0;
};

}  // namespace pathrace::algorithms
