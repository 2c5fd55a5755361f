// Draws: streams side by side, one draw from each at a time.
//
// The state of xoshiro256++ is four words; those of four streams lie next to each other, word by word, so
// that one vector instruction advances all four. Each gives the draws that it would give alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/stream.hpp"

namespace pathrace::algorithms {

class Draws {
 public:
  static constexpr std::size_t capacity = 12;

  /// Column k goes on with this stream, from where it stands.
  void set(std::size_t k, const Stream& stream) { put(k, stream.state()); }
  /// Column `to` goes on where column `from` stands, which is not to be used any more.
  void move(std::size_t from, std::size_t to) {
    put(to, taken(from));
    bits_[to] = bits_[from];
  }

  /// Column `to` goes on where column `from` of others stands, which is not to be used any more.
  void take(const Draws& others, std::size_t from, std::size_t to) { put(to, others.taken(from)); }

  /// The next draw of columns 0..count-1, and of those up to the next multiple of four, which then go astray.
  void advance(std::size_t count) {
    for (std::size_t first = 0; first < count; first += width) quads_[first / width].advance(&bits_[first]);
  }
  /// What the last advance brought.
  std::uint64_t bits(std::size_t k) const { return bits_[k]; }

  /// One more draw of column k alone.
  std::uint64_t another(std::size_t k) {
    State state = taken(k);
    const std::uint64_t bits = Stream::advance(state);
    put(k, state);
    return bits;
  }

 private:
  static constexpr std::size_t width = 4;
  using State = std::array<std::uint64_t, 4>;
  // A vector of g++ and clang, for any processor.
  using Four = std::uint64_t __attribute__((vector_size(width * sizeof(std::uint64_t))));

  struct Quad {
    std::array<Four, 4> state{};

    // Stream::advance, four abreast. No vector crosses a call: without AVX that would be another convention.
    void advance(std::uint64_t* bits) {
      Four& a = state[0];
      Four& b = state[1];
      Four& c = state[2];
      Four& d = state[3];
      const Four sum = a + d;
      const Four drawn = (sum << 23U | sum >> 41U) + a;
      std::memcpy(bits, &drawn, sizeof drawn);
      const Four shifted = b << 17U;
      c ^= a;
      d ^= b;
      b ^= c;
      a ^= d;
      c ^= shifted;
      d = d << 45U | d >> 19U;
    }
  };

  State taken(std::size_t k) const {
    State state{};
    for (std::size_t word = 0; word < state.size(); ++word) {
      state[word] = quads_[k / width].state[word][k % width];
    }
    return state;
  }
  void put(std::size_t k, const State& state) {
    for (std::size_t word = 0; word < state.size(); ++word) {
      quads_[k / width].state[word][k % width] = state[word];
    }
  }

  std::array<Quad, capacity / width> quads_{};
  alignas(Four) std::array<std::uint64_t, capacity> bits_{};
};

}  // namespace pathrace::algorithms
