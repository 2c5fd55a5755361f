#include "core/hash.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pathrace {

Hasher& Hasher::add(std::string_view text) {
  add(static_cast<std::uint64_t>(text.size()));
  for (std::size_t begin = 0; begin < text.size(); begin += 8) {
    std::uint64_t word = 0;
    const std::size_t end = std::min(begin + 8, text.size());
    for (std::size_t i = begin; i < end; ++i) {
      word |= std::uint64_t{static_cast<unsigned char>(text[i])} << (8 * (i - begin));
    }
    add(word);
  }
  return *this;
}

std::string hex(std::uint64_t value) {
  return fmt::format("{:016x}", value);
}

}  // namespace pathrace
