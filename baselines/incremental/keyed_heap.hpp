// A priority queue of cells whose keys may change: a binary heap that knows where each cell is.
//
// Keys are compared part by part, and equal keys by the cell's number, so that the order of any set of
// entries is one. Both arrays are sized once; nothing is allocated later.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "baselines/grid/ring_cost.hpp"

namespace pathrace::baselines {

struct SearchKey {
  RingCost first = 0;
  RingCost second = 0;

  friend bool operator==(const SearchKey&, const SearchKey&) = default;
  friend bool operator<(const SearchKey& a, const SearchKey& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  }
};

class KeyedHeap {
 public:
  using Index = std::uint32_t;

  struct Entry {
    SearchKey key;
    Index cell = 0;

    friend bool operator==(const Entry&, const Entry&) = default;
    friend bool operator<(const Entry& a, const Entry& b) {
      return a.key == b.key ? a.cell < b.cell : a.key < b.key;
    }
  };

  /// For cells 0..cells-1.
  explicit KeyedHeap(std::size_t cells) : place_(cells, absent) { heap_.reserve(cells); }

  bool empty() const { return heap_.empty(); }
  /// The least entry. Expects that there is one.
  const Entry& top() const { return heap_.front(); }

  /// Adds a cell, or gives it another key.
  void put(Index cell, SearchKey key) {
    if (place_[cell] == absent) {
      place_[cell] = static_cast<Index>(heap_.size());
      heap_.push_back({key, cell});
    }
    settle(place_[cell], {key, cell});
  }

  /// Takes a cell out, if it is in.
  void remove(Index cell) {
    const Index hole = place_[cell];
    if (hole == absent) return;
    place_[cell] = absent;
    const Entry last = heap_.back();
    heap_.pop_back();
    if (last.cell != cell) settle(hole, last);
  }

  void clear() {
    for (const Entry& entry : heap_) place_[entry.cell] = absent;
    heap_.clear();
  }

 private:
  static constexpr Index absent = std::numeric_limits<Index>::max();

  // Finds the place of an entry that may stand at `hole` or above or below it.
  void settle(std::size_t hole, const Entry& entry) {
    while (hole > 0 && entry < heap_[(hole - 1) / 2]) {
      set(hole, heap_[(hole - 1) / 2]);
      hole = (hole - 1) / 2;
    }
    for (std::size_t child = 2 * hole + 1; child < heap_.size(); child = 2 * hole + 1) {
      if (child + 1 < heap_.size() && heap_[child + 1] < heap_[child]) ++child;
      if (!(heap_[child] < entry)) break;
      set(hole, heap_[child]);
      hole = child;
    }
    set(hole, entry);
  }

  void set(std::size_t place, const Entry& entry) {
    heap_[place] = entry;
    place_[entry.cell] = static_cast<Index>(place);
  }

  std::vector<Entry> heap_;
  std::vector<Index> place_;
};

}  // namespace pathrace::baselines
