// Random numbers that belong to an index, never to a thread.
//
// A stream is a place in a tree. fork(i) is the i-th child, whatever has been drawn from the parent; the
// draws of a stream come from xoshiro256++ (D. Blackman, S. Vigna, ACM TOMS 47(4), 2021), seeded from the
// place by SplitMix64. The distributions are our own, so that every standard library gives the same bits.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/hash.hpp"

namespace pathrace {

class Stream {
 public:
  explicit Stream(std::uint64_t place) : place_(place) {
    std::uint64_t state = place;
    for (std::uint64_t& word : state_) word = mix64(state += golden_gamma);
  }

  /// The child with this index; neither reads nor changes what has been drawn here.
  Stream fork(std::uint64_t index) const {
    return Stream(mix64((place_ ^ fork_salt) + golden_gamma * (index + 1)));
  }
  /// The child with this name.
  Stream fork(std::string_view label) const { return fork(Hasher().add(label).value()); }

  std::uint64_t place() const { return place_; }

  /// The next 64 bits.
  std::uint64_t bits() { return advance(state_); }

  /// What the next draws come from, for whoever advances several streams at once.
  const std::array<std::uint64_t, 4>& state() const { return state_; }

  /// One step of xoshiro256++ on a raw state; public so that published vectors can be checked.
  static std::uint64_t advance(std::array<std::uint64_t, 4>& s) {
    const std::uint64_t result = std::rotl(s[0] + s[3], 23) + s[0];
    const std::uint64_t t = s[1] << 17;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= t;
    s[3] = std::rotl(s[3], 45);
    return result;
  }

  /// Uniform in [0, 1), 53 bits.
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }
  /// Uniform in [0, 1), 24 bits.
  float uniform_float() { return static_cast<float>(bits() >> 40) * 0x1.0p-24F; }

  /// Uniform in 0..count-1 without bias (D. Lemire, ACM TOMACS 29(1), 2019). count > 0.
  std::uint64_t below(std::uint64_t count) {
    auto [high, low] = multiply(bits(), count);
    if (low < count) {
      const std::uint64_t threshold = (0 - count) % count;
      while (low < threshold) std::tie(high, low) = multiply(bits(), count);
    }
    return high;
  }
  /// Uniform in first..last, both included. first <= last.
  int between(int first, int last) {
    const auto count = static_cast<std::uint64_t>(std::int64_t{last} - first) + 1;
    return static_cast<int>(first + static_cast<std::int64_t>(below(count)));
  }
  bool chance(double probability) { return uniform() < probability; }

  template <typename T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }

 private:
  static constexpr std::uint64_t fork_salt = 0xD1B54A32D192ED03U;

  static std::pair<std::uint64_t, std::uint64_t> multiply(std::uint64_t a, std::uint64_t b) {
    __extension__ using Wide = unsigned __int128;
    const Wide product = Wide{a} * b;
    return {static_cast<std::uint64_t>(product >> 64), static_cast<std::uint64_t>(product)};
  }

  std::uint64_t place_;
  std::array<std::uint64_t, 4> state_{};
};

}  // namespace pathrace
