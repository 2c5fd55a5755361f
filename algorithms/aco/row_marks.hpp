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
  explicit RowMarks(std::size_t rows) : marks_((rows + block - 1) / block * block, 0) {}

  void add(std::size_t row) { marks_[row] = 1; }
  /// The same as a function of its own, for loops: it does not look up each time where the marks are.
  auto adder() {
    return [marks = marks_.data()](std::size_t row) { marks[row] = 1; };
  }
  void add_all() { std::fill(marks_.begin(), marks_.end(), std::uint8_t{1}); }
  void clear() { std::fill(marks_.begin(), marks_.end(), std::uint8_t{0}); }
  void swap(RowMarks& other) { marks_.swap(other.marks_); }
  bool operator==(const RowMarks&) const = default;

  /// Writes the rows of the set to `rows`, which has room for them all, in ascending order. Returns the end.
  std::uint32_t* list(std::uint32_t* rows) const {
    for (std::size_t first = 0; first < marks_.size(); first += block) {
      std::uint64_t bits = bits_of_block(first);
      for (; bits != 0; bits &= bits - 1) {
        *rows++ = static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(std::countr_zero(bits));
      }
    }
    return rows;
  }

 private:
  static constexpr std::size_t in_a_word = sizeof(std::uint64_t);
  static constexpr std::size_t block = 64;

  // A bit for each of 64 marks, without a branch.
  std::uint64_t bits_of_block(std::size_t first) const {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < block; k += in_a_word) bits |= bits_of_word(first + k) << k;
    return bits;
  }

  // Bit b is mark first + b. Mark b, a 1 at bit 8 b, is moved to bit 56 + b by the summand 2^(56 - 7 b) of
  // the factor; no other sum of such bits comes to 56..63, and none carries.
  std::uint64_t bits_of_word(std::size_t first) const {
    std::uint64_t word = 0;
    std::memcpy(&word, marks_.data() + first, sizeof word);
    if constexpr (std::endian::native == std::endian::big) word = __builtin_bswap64(word);
    return word * 0x0102040810204080U >> 56U;
  }

  std::vector<std::uint8_t> marks_;
};

}  // namespace pathrace::algorithms
