// How the trials of a store ended, summed up.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

#include "core/record.hpp"

namespace pathrace::results {

/// How many trials of a planner ended alike.
struct OutcomeCount {
  std::string planner;  ///< label
  Verdict verdict = Verdict::solved;
  bool noted = false;  ///< with a note
  std::uint64_t trials = 0;

  friend bool operator==(const OutcomeCount&, const OutcomeCount&) = default;
};

/// "gave up"
inline std::string in_words(Verdict verdict) {
  std::string words(name(verdict));
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

}  // namespace pathrace::results
