// What a trial may spend. Whichever limit is reached first ends it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/hash.hpp"

namespace pathrace {

struct Budget {
  std::optional<std::uint64_t> evaluations;  ///< candidate paths or walks judged by their cost
  std::optional<std::uint64_t> iterations;   ///< rounds of a planner's main loop
  std::optional<std::uint64_t> checks;       ///< cells tested or visited
  std::optional<double> wall_s;              ///< seconds; rows that it cut short stay outside digests

  bool unlimited() const { return !evaluations && !iterations && !checks && !wall_s; }

  friend bool operator==(const Budget&, const Budget&) = default;
};

/// "evaluations=5000,checks=200000"; "none" when unlimited.
std::string to_string(const Budget& budget);

/// Hash of the limits on work; wall time is a cost and does not name a trial.
std::uint64_t work_hash(const Budget& budget);

}  // namespace pathrace
