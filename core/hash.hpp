// Content hashes: sixty-four bits that name a scenario, a trial or a result.
//
// Words are absorbed one at a time through the SplitMix64 finaliser; text is preceded by its length, so
// that no two different sequences of fields spell the same words. Not cryptographic: it guards against
// accidents and against edits, not against somebody who computes collisions.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace pathrace {

/// The finaliser of SplitMix64 (Steele, Lea, Flood, OOPSLA 2014): a bijection that flips half of the
/// output bits for each input bit.
constexpr std::uint64_t mix64(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31);
}

inline constexpr std::uint64_t golden_gamma = 0x9E3779B97F4A7C15U;

class Hasher {
 public:
  Hasher& add(std::uint64_t word) {
    state_ = mix64((state_ ^ word) + golden_gamma * ++count_);
    return *this;
  }
  Hasher& add(std::int64_t word) { return add(static_cast<std::uint64_t>(word)); }
  Hasher& add(int word) { return add(static_cast<std::int64_t>(word)); }
  Hasher& add(double value) { return add(std::bit_cast<std::uint64_t>(value)); }
  Hasher& add(std::string_view text);

  std::uint64_t value() const { return mix64(state_ ^ count_); }

 private:
  std::uint64_t state_ = 0x70617468'72616365U;  // "pathrace"
  std::uint64_t count_ = 0;
};

/// Sixteen lower-case hexadecimal digits.
std::string hex(std::uint64_t value);

}  // namespace pathrace
