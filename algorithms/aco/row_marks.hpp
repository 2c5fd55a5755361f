// Marks on rows: which of them something was done to.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace pathrace::algorithms {

/// A set of row numbers, a byte each: threads may add different rows at the same time.
class RowMarks {
 public:
  RowMarks() = default;
  /// None of `rows` rows.
  explicit RowMarks(std::size_t rows) : marks_((rows + in_a_word - 1) / in_a_word * in_a_word, 0) {}

  void add(std::size_t row) { marks_[row] = 1; }
  /// The same as a function of its own, for loops: it does not look up each time where the marks are.
  auto adder() {
    return [marks = marks_.data()](std::size_t row) { marks[row] = 1; };
  }
  void clear() { std::fill(marks_.begin(), marks_.end(), std::uint8_t{0}); }
  void swap(RowMarks& other) { marks_.swap(other.marks_); }

  /// `visit(row)` for each row of the set, in some order.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t first = 0; first < marks_.size(); first += in_a_word) {
      std::uint64_t word = 0;
      std::memcpy(&word, marks_.data() + first, sizeof word);
      for (; word != 0; word &= word - 1) visit(first + byte_of(std::countr_zero(word)));
    }
  }

 private:
  static constexpr std::size_t in_a_word = sizeof(std::uint64_t);

  // The byte, in the order of memory, that a bit of a word comes from.
  static std::size_t byte_of(int bit) {
    const auto byte = static_cast<std::size_t>(bit) / 8;
    return std::endian::native == std::endian::little ? byte : in_a_word - 1 - byte;
  }

  std::vector<std::uint8_t> marks_;
};

}  // namespace pathrace::algorithms
